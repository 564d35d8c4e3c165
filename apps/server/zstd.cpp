// SPDX-License-Identifier: Apache-2.0
#include "zstd.hpp"

#include <zstd.h>

#include <new>
#include <vector>

namespace feelem::server {
namespace {

/// Faster than the air that it saves, by far.
constexpr int kLevel = 3;

}  // namespace

struct ZstdPacker::State {
    ZSTD_CCtx* context = ZSTD_createCCtx();
    std::vector<char> piece = std::vector<char>(ZSTD_CStreamOutSize());
};

ZstdPacker::ZstdPacker() : state_(std::make_unique<State>()) {
    if (state_->context == nullptr) throw std::bad_alloc();
    ZSTD_CCtx_setParameter(state_->context, ZSTD_c_compressionLevel, kLevel);
}

ZstdPacker::~ZstdPacker() {
    ZSTD_freeCCtx(state_->context);
}

std::string ZstdPacker::add(std::string_view bytes, bool is_last) {
    ZSTD_inBuffer from{bytes.data(), bytes.size(), 0};
    std::string packed;
    bool is_done = false;
    while (!is_done) {
        ZSTD_outBuffer to{state_->piece.data(), state_->piece.size(), 0};
        const std::size_t left =
            ZSTD_compressStream2(state_->context, &to, &from, is_last ? ZSTD_e_end : ZSTD_e_continue);
        if (ZSTD_isError(left) != 0) throw std::bad_alloc();
        packed.append(state_->piece.data(), to.pos);
        is_done = is_last ? left == 0 : from.pos == from.size;
    }
    return packed;
}

}  // namespace feelem::server
