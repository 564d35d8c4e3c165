// SPDX-License-Identifier: Apache-2.0
#include "page_server.hpp"

#include "base/sha256.hpp"
#include "byte_range.hpp"
#include "page_assets.hpp"
#include "side_files.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <span>
#include <string_view>
#include <thread>
#include <utility>

namespace feelem::server {
namespace {

constexpr const char* kHost = "127.0.0.1";

/// What three.js and the page need and nothing more: images and workers made in the page, files of this
/// server.
constexpr const char* kContentSecurityPolicy =
    "default-src 'self'; img-src 'self' data: blob:; connect-src 'self' data: blob:; worker-src 'self' "
    "blob:; "
    "object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

struct MediaType {
    std::string_view suffix, type;
};
constexpr std::array kMediaTypes{
    MediaType{".html", "text/html; charset=utf-8"},
    MediaType{".js", "text/javascript; charset=utf-8"},
    MediaType{".css", "text/css; charset=utf-8"},
    MediaType{".json", "application/json"},
    MediaType{".svg", "image/svg+xml"},
    MediaType{".png", "image/png"},
    MediaType{".ico", "image/x-icon"},
    MediaType{".wasm", "application/wasm"},
    MediaType{".woff2", "font/woff2"},
    MediaType{".glb", "model/gltf-binary"},
    MediaType{".gltf", "model/gltf+json"},
    MediaType{".bin", "application/octet-stream"}};

std::string media_type(std::string_view path) {
    for (const MediaType& row : kMediaTypes) {
        if (path.ends_with(row.suffix)) return std::string(row.type);
    }
    return "application/octet-stream";
}

struct Asset {
    std::string_view path;
    std::span<const std::byte> gzip;
    std::string hash;
};

std::string unpack(std::span<const std::byte> gzip) {
    z_stream stream{};
    constexpr int kGzip = 16 + MAX_WBITS;
    if (inflateInit2(&stream, kGzip) != Z_OK) throw std::bad_alloc();
    stream.next_in =
        const_cast<Bytef*>(reinterpret_cast<const Bytef*>(gzip.data()));  // zlib never writes there
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

void add_common_headers(httplib::Response& response) {
    response.set_header("Content-Security-Policy", kContentSecurityPolicy);
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cross-Origin-Opener-Policy", "same-origin");
    response.set_header("Cross-Origin-Embedder-Policy", "require-corp");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
}

void answer_text(httplib::Response& response, int status, const std::string& text) {
    response.status = status;
    response.set_content(text, "text/plain; charset=utf-8");
}

/// True, and answered with 304, when the client has this version already.
bool is_known(const httplib::Request& request, httplib::Response& response, const std::string& etag) {
    response.set_header("ETag", etag);
    const std::string known = request.get_header_value("If-None-Match");
    if (known != "*" && known.find(etag) == std::string::npos) return false;
    response.status = 304;
    return true;
}

/// The library answers any range it can parse, beyond the end too: it is told what the file can give.
void answer_bytes(
    const httplib::Request& request,
    httplib::Response& response,
    std::string_view bytes,
    const std::string& type,
    std::shared_ptr<const void> owner
) {
    auto& ranges =
        const_cast<httplib::Request&>(request).ranges;  // The library's own object, not a constant.
    ranges.clear();
    response.set_header("Accept-Ranges", "bytes");
    const RangeRequest wanted = read_range(request.get_header_value("Range"), bytes.size());
    if (wanted.answer == RangeAnswer::NotSatisfiable) {
        response.set_header("Content-Range", fmt::format("bytes */{}", bytes.size()));
        return answer_text(response, 416, "the file is shorter than that\n");
    }
    response.status = 200;
    if (wanted.answer == RangeAnswer::Part) {
        response.status = 206;
        ranges.emplace_back(
            static_cast<ssize_t>(wanted.range.first), static_cast<ssize_t>(wanted.range.last)
        );
    }
    if (bytes.empty()) return response.set_content("", type);
    // A provider, for the library would compress a body again.
    response.set_content_provider(
        bytes.size(),
        type,
        [bytes, owner = std::move(owner)](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
            constexpr std::size_t kChunk = 1u << 20;
            if (offset >= bytes.size()) return false;
            const std::string_view part = bytes.substr(offset, std::min(length, kChunk));
            return sink.write(part.data(), part.size());
        }
    );
}

void answer_asset(const httplib::Request& request, httplib::Response& response, const Asset& asset) {
    // The builder puts a hash into the names of files under assets/.
    const bool has_hash = asset.path.starts_with("/assets/");
    response.set_header("Cache-Control", has_hash ? "public, max-age=31536000, immutable" : "no-cache");
    response.set_header("Vary", "Accept-Encoding");
    const bool takes_gzip = request.get_header_value("Accept-Encoding").find("gzip") != std::string::npos;
    if (is_known(request, response, fmt::format("\"{}{}\"", asset.hash, takes_gzip ? "-gzip" : ""))) return;
    const std::string type = media_type(asset.path);
    if (!takes_gzip) {
        auto plain = std::make_shared<std::string>(unpack(asset.gzip));
        const std::string_view bytes = *plain;
        return answer_bytes(request, response, bytes, type, std::move(plain));
    }
    response.set_header("Content-Encoding", "gzip");
    const std::string_view bytes(reinterpret_cast<const char*>(asset.gzip.data()), asset.gzip.size());
    answer_bytes(request, response, bytes, type, nullptr);
}

void answer_file(
    const httplib::Request& request,
    httplib::Response& response,
    const std::shared_ptr<const ServedFile>& file
) {
    response.set_header("Cache-Control", "no-cache");
    if (is_known(request, response, file->etag)) return;
    answer_bytes(request, response, file->bytes.text(), media_type(request.path), file);
}

}  // namespace

struct PageServer::State {
    explicit State(const std::string& scene) : folder(scene) {}

    httplib::Server server;
    SceneFolder folder;
    std::map<std::string_view, Asset> assets;
    std::thread thread;
    int port = 0;

    /// Names by which a browser on this machine may call us: another one is a foreign page that made its name
    /// point here (DNS rebinding).
    bool is_for_us(const httplib::Request& request) const {
        const std::string host = request.get_header_value("Host");
        const std::array names{
            fmt::format("127.0.0.1:{}", port),
            fmt::format("localhost:{}", port),
            fmt::format("[::1]:{}", port)};
        return request.get_header_value_count("Host") == 1 && std::ranges::find(names, host) != names.end();
    }

    void answer(const httplib::Request& request, httplib::Response& response) {
        add_common_headers(response);
        if (!is_for_us(request)) return answer_text(response, 421, "this is not the server you look for\n");
        if (request.method != "GET" && request.method != "HEAD") {
            response.set_header("Allow", "GET, HEAD");
            return answer_text(response, 405, "only GET and HEAD\n");
        }
        const std::string path = request.path == "/" ? "/index.html" : request.path;
        if (const auto asset = assets.find(path); asset != assets.end()) {
            return answer_asset(request, response, asset->second);
        }
        if (const auto file = folder.find(path)) return answer_file(request, response, file);
        answer_text(response, 404, "there is no such file\n");
    }
};

PageServer::PageServer(const ServeOptions& options) : state_(std::make_unique<State>(options.scene_path)) {
    const std::string suffix = std::filesystem::path(options.scene_path).extension().string();
    if (!state_->folder.find("/scene" + suffix)) {
        throw Error(Code::FileNotFound, options.scene_path, "there is no such scene");
    }
    for (const PageAsset& asset : page_assets()) {
        state_->assets[asset.path] = {asset.path, asset.gzip, sha256_hex(asset.gzip)};
    }
    httplib::Server& server = state_->server;
    server.new_task_queue = [] { return new httplib::ThreadPool(8); };
    server.set_keep_alive_max_count(100'000);
    server.set_tcp_nodelay(true);
    server.set_payload_max_length(1024);
    // Without the library's SO_REUSEPORT: two servers must not share a port.
    server.set_socket_options([](socket_t socket) {
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
        state_->answer(request, response);
        return httplib::Server::HandlerResponse::Handled;
    });
    if (options.port == 0) {
        state_->port = server.bind_to_any_port(kHost);
        return;
    }
    constexpr int kPortsTried = 20;
    const int last = options.only_that ? options.port : std::min(options.port + kPortsTried, 65535);
    for (int port = options.port; port <= last && state_->port == 0; ++port) {
        if (server.bind_to_port(kHost, port)) state_->port = port;
    }
    if (state_->port == 0) {
        throw Error(
            Code::BadOption,
            "--port",
            fmt::format(
                "port {} is in use on this machine; another one, or 0 for any that is free?", options.port
            )
        );
    }
}

PageServer::~PageServer() {
    stop();
}

void PageServer::start() {
    state_->thread = std::thread([this] { state_->server.listen_after_bind(); });
    // The socket listens already; stop() works only once the loop runs.
    while (!state_->server.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void PageServer::stop() {
    if (!state_->thread.joinable()) return;
    state_->server.stop();
    state_->thread.join();
}

int PageServer::port() const noexcept {
    return state_->port;
}

std::string PageServer::address() const {
    return fmt::format("http://{}:{}/", kHost, state_->port);
}

}  // namespace feelem::server
