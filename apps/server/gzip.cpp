// SPDX-License-Identifier: Apache-2.0
#include "gzip.hpp"

#include <zlib.h>

#include <array>
#include <new>

namespace feelem::server {
namespace {

constexpr int kGzip = 16 + MAX_WBITS;

Bytef* input_of(const void* bytes) {
    return const_cast<Bytef*>(static_cast<const Bytef*>(bytes));  // zlib never writes there.
}

}  // namespace

struct GzipPacker::State {
    z_stream stream{};
};

GzipPacker::GzipPacker() : state_(std::make_unique<State>()) {
    if (deflateInit2(&state_->stream, 6, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc();
}

GzipPacker::~GzipPacker() {
    deflateEnd(&state_->stream);
}

std::string GzipPacker::add(std::string_view bytes, bool is_last) {
    z_stream& stream = state_->stream;
    stream.next_in = input_of(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string packed;
    std::array<char, 16384> chunk{};
    do {
        stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
        stream.avail_out = static_cast<uInt>(chunk.size());
        deflate(&stream, is_last ? Z_FINISH : Z_NO_FLUSH);
        packed.append(chunk.data(), chunk.size() - stream.avail_out);
    } while (stream.avail_out == 0);
    return packed;
}

std::string unpack(std::span<const std::byte> gzip) {
    z_stream stream{};
    if (inflateInit2(&stream, kGzip) != Z_OK) throw std::bad_alloc();
    stream.next_in = input_of(gzip.data());
    stream.avail_in = static_cast<uInt>(gzip.size());
    std::string plain;
    std::array<char, 65536> chunk{};
    int status = Z_OK;
    while (status == Z_OK) {
        stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
        stream.avail_out = static_cast<uInt>(chunk.size());
        status = inflate(&stream, Z_NO_FLUSH);
        plain.append(chunk.data(), chunk.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    return plain;
}

}  // namespace feelem::server
