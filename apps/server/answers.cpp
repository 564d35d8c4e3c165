// SPDX-License-Identifier: Apache-2.0
#include "answers.hpp"

#include "base/sha256.hpp"
#include "byte_range.hpp"
#include "gzip.hpp"
#include "zstd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace feelem::server {
namespace {

/// What three.js and the page need and nothing more: images and workers made in the page, files of this
/// server, and WebAssembly (the decoder of compressed scenes).
constexpr const char* kContentSecurityPolicy =
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data: blob:; "
    "connect-src 'self' data: blob:; worker-src 'self' blob:; "
    "object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

constexpr std::size_t kChunk = 256 << 10;

struct MediaType {
    std::string_view suffix, type;
    bool is_text = false;
};
constexpr std::array kMediaTypes{
    MediaType{".html", "text/html; charset=utf-8", true},
    MediaType{".js", "text/javascript; charset=utf-8", true},
    MediaType{".css", "text/css; charset=utf-8", true},
    MediaType{".json", "application/json", true},
    MediaType{".svg", "image/svg+xml", true},
    MediaType{".png", "image/png"},
    MediaType{".ico", "image/x-icon"},
    MediaType{".wasm", "application/wasm"},
    MediaType{".woff2", "font/woff2"},
    MediaType{".glb", "model/gltf-binary"},
    MediaType{".gltf", "model/gltf+json", true}};

MediaType media_type(std::string_view path) {
    const auto fits = [&](const MediaType& row) { return path.ends_with(row.suffix); };
    const auto found = std::ranges::find_if(kMediaTypes, fits);
    return found == kMediaTypes.end() ? MediaType{"", "application/octet-stream"} : *found;
}

/// "gzip" or "x, gzip;q=0.5", not "gzip;q=0".
bool takes(const RequestHead& head, std::string_view coding) {
    const std::string_view accepted = head.header("accept-encoding");
    const std::size_t at = accepted.find(coding);
    if (at == std::string_view::npos) return false;
    const std::size_t after = at + coding.size();
    const std::string_view rest = accepted.substr(after, accepted.find(',', at) - after);
    const std::size_t weight = rest.find("q=");
    return weight == std::string_view::npos ||
           rest.substr(weight + 2).find_first_of("123456789") != std::string_view::npos;
}

/// True, and answered with 304, when the client has this version already.
bool is_known(const Exchange& exchange, const std::string& etag) {
    exchange.response.set_header("ETag", etag);
    const std::string_view known = exchange.head.header("if-none-match");
    if (known != "*" && known.find(etag) == std::string_view::npos) return false;
    exchange.response.status = 304;
    return true;
}

using ReadPiece = std::function<std::string_view(std::size_t offset, std::size_t length)>;

/// `read` gives at most what it is asked for; nothing when the bytes are gone.
void answer_bytes(
    const Exchange& exchange,
    std::size_t size,
    const std::string& type,
    const std::string& etag,
    ReadPiece read
) {
    httplib::Response& response = exchange.response;
    exchange.request.ranges.clear();
    response.set_header("Accept-Ranges", "bytes");
    // A part of a version that is no longer served would be joined with a part of another one.
    const std::string_view condition = exchange.head.header("if-range");
    const bool is_same = condition.empty() || condition == etag;
    const RangeRequest wanted = read_range(is_same ? exchange.head.header("range") : "", size);
    if (wanted.answer == RangeAnswer::NotSatisfiable) {
        response.set_header("Content-Range", fmt::format("bytes */{}", size));
        return answer_text(response, 416, "the file is shorter than that\n");
    }
    response.status = 200;
    if (wanted.answer == RangeAnswer::Part) {
        response.status = 206;
        exchange.request.ranges.emplace_back(
            static_cast<ssize_t>(wanted.range.first), static_cast<ssize_t>(wanted.range.last)
        );
    }
    if (size == 0) return response.set_content("", type);
    response.set_content_provider(
        size,
        type,
        [read = std::move(read)](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
            const std::string_view piece = read(offset, std::min(length, kChunk));
            return !piece.empty() && sink.write(piece.data(), piece.size());
        }
    );
}

/// A file from disk, compressed on its way.
template <class Packer>
void answer_compressed(
    const Exchange& exchange,
    const std::string& type,
    const std::string& coding,
    std::shared_ptr<const ServedFile> file
) {
    exchange.response.status = 200;
    exchange.response.set_header("Content-Encoding", coding);
    exchange.response.set_chunked_content_provider(
        type,
        [file = std::move(file),
         at = std::size_t{0},
         packer = std::make_shared<Packer>(),
         piece = std::vector<char>(kChunk)](std::size_t, httplib::DataSink& sink) mutable {
            const std::size_t got =
                file->read(at, std::span(piece).first(std::min(kChunk, file->size() - at)));
            // Cut short meanwhile: the client must not take it for the whole.
            if (got == 0 && at < file->size()) return false;
            at += got;
            const std::string packed = packer->add({piece.data(), got}, at == file->size());
            if (!packed.empty() && !sink.write(packed.data(), packed.size())) return false;
            if (at == file->size()) sink.done();
            return true;
        }
    );
}

/// How a file is compressed on its way: texts for all, numbers for those who are asked to come through the
/// air (on this machine it would only cost time). Empty: not at all.
std::string coding_of(const Exchange& exchange, const MediaType& type, const ServedFile& file) {
    const RequestHead& head = exchange.head;
    if (head.count("range") > 0 || head.version == "HTTP/1.0" || file.size() == 0) return "";
    if (type.is_text) return takes(head, "gzip") ? "gzip" : "";
    return exchange.is_private && takes(head, "zstd") ? "zstd" : "";
}

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Asset packed_asset(const std::string& path, const std::string& content) {
    GzipPacker packer;
    auto packed = std::make_shared<const std::string>(packer.add(content, true));
    const auto bytes = std::as_bytes(std::span(*packed));
    return {path, bytes, sha256_hex(bytes), std::move(packed)};
}

void add_common_headers(httplib::Response& response) {
    response.set_header("Content-Security-Policy", kContentSecurityPolicy);
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("X-Frame-Options", "DENY");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Permissions-Policy", "camera=(), geolocation=(), microphone=(), payment=(), usb=()");
    response.set_header("Cross-Origin-Opener-Policy", "same-origin");
    response.set_header("Cross-Origin-Embedder-Policy", "require-corp");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
}

void answer_text(httplib::Response& response, int status, const std::string& text) {
    response.status = status;
    if (!response.has_header("Cache-Control")) response.set_header("Cache-Control", "no-store");
    response.set_content(text, "text/plain; charset=utf-8");
}

void answer_asset(const Exchange& exchange, const Asset& asset) {
    // The builder puts a hash into the names of files under assets/.
    const bool has_hash = asset.path.starts_with("/assets/");
    const std::string scope = exchange.is_private ? "private" : "public";
    exchange.response.set_header(
        "Cache-Control", has_hash ? scope + ", max-age=31536000, immutable" : "no-cache"
    );
    exchange.response.set_header("Vary", "Accept-Encoding");
    const bool as_gzip = takes(exchange.head, "gzip");
    const std::string etag = fmt::format("\"{}{}\"", asset.hash, as_gzip ? "-gzip" : "");
    if (is_known(exchange, etag)) return;
    auto plain = std::make_shared<const std::string>(as_gzip ? std::string() : unpack(asset.gzip));
    if (as_gzip) exchange.response.set_header("Content-Encoding", "gzip");
    const std::string_view bytes = as_gzip ? text_of(asset.gzip) : std::string_view(*plain);
    answer_bytes(
        exchange,
        bytes.size(),
        std::string(media_type(asset.path).type),
        etag,
        [bytes, plain = std::move(plain), owner = asset.owner](std::size_t offset, std::size_t length) {
            return bytes.substr(std::min(offset, bytes.size()), length);
        }
    );
}

void answer_file(const Exchange& exchange, const std::shared_ptr<const ServedFile>& file) {
    exchange.response.set_header("Cache-Control", exchange.is_private ? "private, no-cache" : "no-cache");
    const MediaType type = media_type(exchange.request.path);
    const std::string coding = coding_of(exchange, type, *file);
    if (type.is_text || exchange.is_private) exchange.response.set_header("Vary", "Accept-Encoding");
    const std::string version = file->etag().substr(0, file->etag().size() - 1);
    if (is_known(exchange, coding.empty() ? file->etag() : version + "-" + coding + "\"")) return;
    if (coding == "gzip")
        return answer_compressed<GzipPacker>(exchange, std::string(type.type), coding, file);
    if (coding == "zstd")
        return answer_compressed<ZstdPacker>(exchange, std::string(type.type), coding, file);
    auto piece = std::make_shared<std::vector<char>>();
    answer_bytes(
        exchange,
        file->size(),
        std::string(type.type),
        file->etag(),
        [file, piece](std::size_t offset, std::size_t length) {
            piece->resize(length);
            return std::string_view(piece->data(), file->read(offset, *piece));
        }
    );
}

}  // namespace feelem::server
