// SPDX-License-Identifier: Apache-2.0
#include "page_server.hpp"

#include "answers.hpp"
#include "base/sha256.hpp"
#include "certificate.hpp"
#include "connect_page.hpp"
#include "guard.hpp"
#include "gzip.hpp"
#include "listener.hpp"
#include "page_assets.hpp"
#include "qr_code.hpp"
#include "rate_limit.hpp"
#include "side_files.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

namespace feelem::server {
namespace {

/// Requests of one address: more than any page needs, less than what would keep others waiting.
constexpr double kRequestsAtOnce = 4000, kRequestsASecond = 1000;
/// Of one that does not know the link.
constexpr double kRefusalsAtOnce = 60, kRefusalsASecond = 5;

/// What the library reads: a head that we have checked. What it writes goes out by our connection.
class LibraryStream final : public httplib::Stream {
public:
    LibraryStream(Connection& connection, std::string head)
        : connection_(connection), head_(std::move(head)) {}
    bool is_readable() const override { return at_ < head_.size(); }
    bool is_writable() const override { return true; }
    ssize_t read(char* bytes, std::size_t size) override {
        const std::size_t count = std::min(size, head_.size() - at_);
        std::copy_n(head_.data() + at_, count, bytes);
        at_ += count;
        return static_cast<ssize_t>(count);
    }
    ssize_t write(const char* bytes, std::size_t size) override {
        return connection_.write({bytes, size}) ? static_cast<ssize_t>(size) : -1;
    }
    void get_remote_ip_and_port(std::string& address, int& port) const override {
        address = connection_.address();
        port = 0;
    }
    void get_local_ip_and_port(std::string& address, int& port) const override {
        address = connection_.own_address();
        port = 0;
    }
    int socket() const override { return connection_.socket(); }

private:
    Connection& connection_;
    std::string head_;
    std::size_t at_ = 0;
};

/// The library for one request: it makes the answer's head and sends the body.
class Library final : public httplib::Server {
public:
    bool answer(LibraryStream& stream, bool close) {
        set_keep_alive_timeout(60);
        set_keep_alive_max_count(1000);
        svr_sock_ = stream.socket();  // Without a socket of its own it takes itself to be shutting down.
        bool is_closed = false;
        return process_request(stream, close, is_closed, nullptr);
    }
};

bool wants_close(const RequestHead& head) {
    const std::string_view connection = head.header("connection");
    if (head.version == "HTTP/1.0") return connection != "keep-alive";
    return connection.find("close") != std::string_view::npos ||
           connection.find("Close") != std::string_view::npos;
}

std::vector<std::string> host_names(const LanNames& lan, const Certificate& certificate) {
    std::vector<std::string> names{"127.0.0.1", "localhost", "[::1]"};
    for (const std::string& address : lan.addresses) names.push_back(in_url(address));
    names.insert(names.end(), certificate.names.begin(), certificate.names.end());
    return names;
}

}  // namespace

struct PageServer::State {
    explicit State(const ServeOptions& options) : folder(options.scene_path), opening(options.opening) {}

    SceneFolder folder;
    std::map<std::string, Asset, std::less<>> assets;
    Certificate certificate;
    LanNames lan;
    std::string token;
    int port = 0;
    std::unique_ptr<Guard> guard;
    std::unique_ptr<FrontDoor> door;
    std::unique_ptr<InsideQuestions> inside;  ///< Null: the scene is all there is.
    std::shared_ptr<Opening> opening;         ///< Null: the scene was there from the start.
    RateLimit requests{kRequestsAtOnce, kRequestsASecond};
    RateLimit refusals{kRefusalsAtOnce, kRefusalsASecond};

    std::string path_prefix() const { return token.empty() ? "/" : "/" + token + "/"; }
    std::vector<std::string> links() const;
    void collect_assets();
    FrontDoor::Outcome serve(Connection& connection, const RequestHead& head);
    void answer(
        const Exchange& exchange, const Guard::Verdict& verdict, int refused, const Connection& connection
    );
};

std::vector<std::string> PageServer::State::links() const {
    std::vector<std::string> hosts, names;
    if (token.empty()) return hosts;
    for (const std::string& address : lan.addresses) hosts.push_back(in_url(address));
    for (const std::string& name : certificate.names) {
        if (name != "localhost" && !name.starts_with("*")) names.push_back(name);
    }
    // Ours is for every address; one that somebody gave is mostly for its names alone.
    hosts.insert(certificate.is_own ? hosts.end() : hosts.begin(), names.begin(), names.end());
    for (std::string& host : hosts) host = fmt::format("https://{}:{}{}", host, port, path_prefix());
    return hosts;
}

void PageServer::State::collect_assets() {
    for (const PageAsset& asset : page_assets()) {
        assets[std::string(asset.path)] = {
            std::string(asset.path), asset.gzip, sha256_hex(asset.gzip), nullptr};
    }
    const auto add_hint = [this](const auto& with_hint) {
        Asset& index = assets["/index.html"];
        index = packed_asset("/index.html", with_hint(unpack(index.gzip)));
    };
    if (inside) add_hint(with_inside_hint);
    if (opening) add_hint(with_opening_hint);
    if (token.empty()) return;
    const ConnectFacts facts{
        links(),
        certificate.fingerprint,
        certificate.is_own,
        port,
        fmt::format("http://localhost:{}{}", port, path_prefix())};
    assets["/connect.html"] = packed_asset("/connect.html", connect_page(facts));
    const std::string link = facts.links.empty() ? facts.usb_link : facts.links.front();
    assets["/connect.svg"] = packed_asset("/connect.svg", qr_for_page(link));
    assets["/connect.css"] = packed_asset("/connect.css", connect_style());
    add_hint(with_connect_hint);
}

FrontDoor::Outcome PageServer::State::serve(Connection& connection, const RequestHead& head) {
    const Guard::Verdict verdict = guard->judge(head, {connection.is_tls(), connection.own_address()});
    const bool is_stranger = verdict.status != 0 && !token.empty();
    RateLimit& limit = is_stranger ? refusals : requests;
    const bool is_too_often = !limit.take(connection.address(), Clock::now());
    const bool close = wants_close(head) || is_stranger || is_too_often;
    Library library;
    library.set_pre_routing_handler([&](const httplib::Request& request, httplib::Response& response) {
        // The library's own object, not a constant.
        const Exchange exchange{head, const_cast<httplib::Request&>(request), response, !token.empty()};
        try {
            answer(exchange, verdict, is_too_often ? 429 : verdict.status, connection);
        } catch (const std::exception&) {
            response = {};
            answer_text(response, 500, "something went wrong here\n");
        }
        return httplib::Server::HandlerResponse::Handled;
    });
    // Ranges, encodings and the like are ours; of the target the library decodes the path.
    const bool is_reading = head.method == "GET" || head.method == "HEAD";
    const std::string target = verdict.target.empty() ? "/" : verdict.target;
    LibraryStream stream(
        connection,
        fmt::format(
            "{} {} HTTP/1.1\r\n{}\r\n",
            is_reading ? head.method : "GET",
            target,
            close ? "Connection: close\r\n" : ""
        )
    );
    const bool is_sent = library.answer(stream, close);
    return {is_sent && !close, verdict.status == 0};
}

void PageServer::State::answer(
    const Exchange& exchange, const Guard::Verdict& verdict, int refused, const Connection& connection
) {
    httplib::Response& response = exchange.response;
    add_common_headers(response);
    if (refused == 405) response.set_header("Allow", "GET, HEAD");
    if (refused == 429) response.set_header("Retry-After", "10");
    switch (refused) {
    case 0: break;
    case 403: return answer_text(response, 403, "the whole link is needed, as it was printed\n");
    case 405: return answer_text(response, 405, "only GET and HEAD\n");
    case 421: return answer_text(response, 421, "this is not the server you look for\n");
    default: return answer_text(response, refused, "too many requests\n");
    }
    if (verdict.lacks_slash) {
        response.set_header("Location", path_prefix());
        return answer_text(response, 308, "the link ends with a slash\n");
    }
    const std::string& path = exchange.request.path;
    if (const auto asset = assets.find(path == "/" ? "/index.html" : path); asset != assets.end()) {
        if (opening) opening->welcome();
        return answer_asset(exchange, asset->second);
    }
    const auto is_gone = [&] { return connection.is_gone(); };
    if (opening && path == "/opening") return opening->answer_progress(exchange, is_gone);
    // Whoever comes too late for the shape alone gets the scene.
    const bool is_shape = opening && path == "/shape.glb";
    if (const auto shape = is_shape ? opening->shape() : nullptr) return answer_file(exchange, shape);
    if (opening && (is_shape || folder.owns(path) || path.starts_with("/inside/")) &&
        !opening->is_finished(exchange, is_gone))
        return;
    if (const auto file = folder.find(is_shape ? "/scene.glb" : path)) return answer_file(exchange, file);
    if (path.starts_with("/inside/")) {
        if (inside) return inside->answer(exchange, connection.address(), is_gone);
        return answer_text(response, 404, "this scene has no volume elements: open the model file\n");
    }
    answer_text(response, 404, "there is no such file\n");
}

PageServer::PageServer(const ServeOptions& options) : state_(std::make_unique<State>(options)) {
    const std::string suffix = std::filesystem::path(options.scene_path).extension().string();
    if (!options.opening && !state_->folder.find("/scene" + suffix)) {
        throw Error(Code::FileNotFound, options.scene_path, "there is no such scene");
    }
    if (options.lan) {
        state_->lan = lan_names();
        const std::string folder =
            options.certificate_folder.empty() ? data_folder() : options.certificate_folder;
        state_->certificate = options.certificate_file.empty()
                                  ? own_certificate(folder, state_->lan)
                                  : given_certificate(options.certificate_file, options.key_file);
        state_->token = make_token();
    }
    const Listener listener = open_listener({options.port, options.only_that, options.lan});
    state_->port = listener.port;
    state_->door = std::make_unique<FrontDoor>(
        listener.socket,
        state_->certificate.context.get(),
        [this](Connection& connection, const RequestHead& head) { return state_->serve(connection, head); },
        options.limits
    );
    state_->guard =
        std::make_unique<Guard>(host_names(state_->lan, state_->certificate), state_->port, state_->token);
    if (options.model) state_->inside = std::make_unique<InsideQuestions>(*options.model, options.inside);
    state_->collect_assets();
}

PageServer::~PageServer() {
    stop();
}

void PageServer::start() {
    state_->door->start();
}

void PageServer::stop() {
    state_->door->stop();
}

int PageServer::port() const noexcept {
    return state_->port;
}

std::string PageServer::address() const {
    return fmt::format("http://127.0.0.1:{}{}", state_->port, state_->path_prefix());
}

std::vector<std::string> PageServer::links() const {
    return state_->links();
}

std::string PageServer::fingerprint() const {
    return state_->certificate.fingerprint;
}

bool PageServer::has_own_certificate() const {
    return state_->certificate.is_own;
}

bool PageServer::has_new_certificate() const {
    return state_->certificate.is_new;
}

}  // namespace feelem::server
