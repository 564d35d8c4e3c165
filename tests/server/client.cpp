// SPDX-License-Identifier: Apache-2.0
#include "client.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <netinet/in.h>
#include <openssl/x509.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

namespace feelem::test {

Client::Client(int port, bool tls) {
    std::signal(SIGPIPE, SIG_IGN);
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval limit{20, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
    if (connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) cut();
    if (!tls || socket_ < 0) return;
    static SSL_CTX* const context = SSL_CTX_new(TLS_client_method());  // As a browser has one.
    tls_.reset(SSL_new(context));
    SSL_set_fd(tls_.get(), socket_);
    if (SSL_connect(tls_.get()) != 1) {
        tls_.reset();
        cut();
    }
}

Client::~Client() {
    if (tls_) SSL_shutdown(tls_.get());
    cut();
}

void Client::cut() {
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
    tls_.reset();
}

bool Client::send(std::string_view text) {
    while (!text.empty()) {
        const long sent = tls_ ? SSL_write(tls_.get(), text.data(), static_cast<int>(text.size()))
                               : ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
        if (sent <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

long Client::read(char* bytes, std::size_t size, std::chrono::milliseconds silence) {
    pollfd asked{socket_, POLLIN, 0};
    const bool has_more = tls_ && SSL_pending(tls_.get()) > 0;
    if (!has_more && poll(&asked, 1, static_cast<int>(silence.count())) <= 0) return -1;
    return tls_ ? SSL_read(tls_.get(), bytes, static_cast<int>(size)) : recv(socket_, bytes, size, 0);
}

std::string Client::receive(std::chrono::milliseconds silence) {
    std::string answer;
    std::array<char, 65536> bytes{};
    for (long got = 1; got > 0;) {
        got = read(bytes.data(), bytes.size(), silence);
        if (got > 0) answer.append(bytes.data(), static_cast<std::size_t>(got));
    }
    return answer;
}

std::string Client::receive_one(bool has_body) {
    std::string answer;
    char byte = 0;
    while (!answer.ends_with("\r\n\r\n")) {
        if (read(&byte, 1, std::chrono::seconds(5)) != 1) return answer;
        answer += byte;
    }
    const std::string length = header_of(answer, "Content-Length");
    const std::size_t end = answer.size() + (has_body && !length.empty() ? std::stoul(length) : 0);
    std::array<char, 4096> bytes{};
    while (answer.size() < end) {
        const long got =
            read(bytes.data(), std::min(bytes.size(), end - answer.size()), std::chrono::seconds(5));
        if (got <= 0) return answer;
        answer.append(bytes.data(), static_cast<std::size_t>(got));
    }
    return answer;
}

bool Client::is_closed_within(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    std::array<char, 4096> bytes{};
    while (std::chrono::steady_clock::now() < end) {
        pollfd asked{socket_, POLLIN, 0};
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (poll(&asked, 1, static_cast<int>(left.count())) <= 0) return false;
        if (recv(socket_, bytes.data(), bytes.size(), 0) <= 0) return true;
    }
    return false;
}

std::string Client::fingerprint() const {
    const std::unique_ptr<X509, decltype(&X509_free)> paper(SSL_get1_peer_certificate(tls_.get()), X509_free);
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    X509_digest(paper.get(), EVP_sha256(), digest.data(), &size);
    return fmt::format("{:02X}", fmt::join(digest.begin(), digest.begin() + size, ":"));
}

std::string ask(int port, bool tls, const std::string& target, const Asked& asked) {
    Client client(port, tls);
    const std::string host = asked.host.empty() ? fmt::format("127.0.0.1:{}", port) : asked.host;
    client.send(fmt::format(
        "{} {} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n{}\r\n", asked.method, target, host, asked.headers
    ));
    return client.receive();
}

int status_of(const std::string& answer) {
    constexpr std::string_view kStart = "HTTP/1.1 ";
    return answer.starts_with(kStart) ? std::atoi(answer.c_str() + kStart.size()) : 0;
}

std::string body_of(const std::string& answer) {
    const std::size_t end = answer.find("\r\n\r\n");
    return end == std::string::npos ? "" : answer.substr(end + 4);
}

std::string header_of(const std::string& answer, const std::string& name) {
    const std::size_t at = answer.find("\r\n" + name + ": ");
    if (at == std::string::npos || at > answer.find("\r\n\r\n")) return "";
    const std::size_t from = at + name.size() + 4;
    return answer.substr(from, answer.find("\r\n", from) - from);
}

std::string prefix_of(const server::PageServer& server) {
    const std::string address = server.address();
    return address.substr(address.find('/', std::string_view("http://").size()));
}

}  // namespace feelem::test
