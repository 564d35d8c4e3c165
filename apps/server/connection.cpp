// SPDX-License-Identifier: Apache-2.0
#include "connection.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/err.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace feelem::server {
namespace {

using namespace std::chrono_literals;

/// Who takes an answer in more slowly than this, after a start, is cut off.
constexpr auto kAnswerStart = 20s;
constexpr std::size_t kSlowestBytesASecond = 4096;
constexpr auto kLongestStall = 15s;

std::string text_of(const sockaddr_storage& address) {
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (address.ss_family == AF_INET) {
        sockaddr_in v4{};
        std::memcpy(&v4, &address, sizeof v4);
        inet_ntop(AF_INET, &v4.sin_addr, text.data(), text.size());
    } else if (address.ss_family == AF_INET6) {
        sockaddr_in6 v6{};
        std::memcpy(&v6, &address, sizeof v6);
        inet_ntop(AF_INET6, &v6.sin6_addr, text.data(), text.size());
    }
    const std::string_view found = text.data();
    constexpr std::string_view kMapped = "::ffff:";
    const bool is_mapped = found.starts_with(kMapped) && found.find('.') != std::string_view::npos;
    return std::string(is_mapped ? found.substr(kMapped.size()) : found);
}

}  // namespace

std::string other_address(int socket) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    if (getpeername(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return {};
    return text_of(address);
}

std::string own_address(int socket) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    if (getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return {};
    return text_of(address);
}

bool is_loopback(const std::string& address) {
    return address == "::1" || address.starts_with("127.");
}

Connection::Connection(int socket, std::string address, bool is_local)
    : socket_(socket), address_(std::move(address)), own_address_(server::own_address(socket)),
      is_local_(is_local), answer_began_(Clock::now()) {
    fcntl(socket_, F_SETFL, fcntl(socket_, F_GETFL) | O_NONBLOCK);
    const int yes = 1;
    setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

Connection::~Connection() {
    tls_.reset();
    close(socket_);
}

bool Connection::wait(short events, Deadline end) {
    while (!is_interrupted_) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) return false;
        pollfd asked{socket_, events, 0};
        const int found = poll(&asked, 1, static_cast<int>(std::min<long long>(left, 60'000)));
        if (found > 0) return !is_interrupted_;
        if (found < 0 && errno != EINTR) return false;
    }
    return false;
}

bool Connection::wait_for_tls(int result, Deadline end) {
    switch (SSL_get_error(tls_.get(), result)) {
    case SSL_ERROR_WANT_READ: return wait(POLLIN, end);
    case SSL_ERROR_WANT_WRITE: return wait(POLLOUT, end);
    case SSL_ERROR_ZERO_RETURN: return false;
    default: is_broken_ = true; return false;
    }
}

int Connection::peek(Deadline end) {
    while (true) {
        unsigned char byte = 0;
        const ssize_t got = recv(socket_, &byte, 1, MSG_PEEK);
        if (got == 1) return byte;
        if (got == 0 || (errno != EAGAIN && errno != EINTR) || !wait(POLLIN, end)) return -1;
    }
}

bool Connection::begin_tls(SSL_CTX* context, Deadline end) {
    tls_.reset(SSL_new(context));
    if (!tls_ || SSL_set_fd(tls_.get(), socket_) != 1) return false;
    while (true) {
        ERR_clear_error();
        const int result = SSL_accept(tls_.get());
        if (result == 1) return true;
        if (!wait_for_tls(result, end)) return false;
        // A trickle of bytes must not keep it alive.
        if (Clock::now() >= end) return false;
    }
}

std::size_t Connection::read(char* bytes, std::size_t size, Deadline end) {
    while (!is_broken_ && !is_interrupted_) {
        if (tls_) {
            ERR_clear_error();
            std::size_t got = 0;
            const int result = SSL_read_ex(tls_.get(), bytes, size, &got);
            if (result == 1) return got;
            if (!wait_for_tls(result, end)) return 0;
            continue;
        }
        const ssize_t got = recv(socket_, bytes, size, 0);
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno != EAGAIN && errno != EINTR) return 0;
        if (!wait(POLLIN, end)) return 0;
    }
    return 0;
}

bool Connection::write(std::string_view bytes) {
    while (!bytes.empty()) {
        if (is_broken_ || is_interrupted_) return false;
        const auto now = Clock::now();
        const auto allowed = kAnswerStart + std::chrono::seconds(answer_bytes_ / kSlowestBytesASecond);
        const Deadline end = std::min(now + kLongestStall, answer_began_ + allowed);
        std::size_t put = 0;
        if (tls_) {
            ERR_clear_error();
            const int result = SSL_write_ex(tls_.get(), bytes.data(), bytes.size(), &put);
            if (result != 1 && !wait_for_tls(result, end)) return false;
            if (result != 1) continue;
        } else {
            const ssize_t sent = send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (sent < 0 && errno != EAGAIN && errno != EINTR) return false;
            if (sent < 0 && !wait(POLLOUT, end)) return false;
            if (sent < 0) continue;
            put = static_cast<std::size_t>(sent);
        }
        answer_bytes_ += put;
        bytes.remove_prefix(put);
        // Small sips keep each wait short: the whole must keep up too.
        if (now > answer_began_ + allowed) return false;
    }
    return true;
}

void Connection::begin_answer() {
    answer_began_ = Clock::now();
    answer_bytes_ = 0;
}

void Connection::interrupt() {
    is_interrupted_ = true;
    shutdown(socket_, SHUT_RDWR);
}

bool Connection::is_gone() const {
    if (is_interrupted_) return true;
    pollfd asked{socket_, POLLRDHUP, 0};
    return poll(&asked, 1, 0) > 0 && (asked.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

void Connection::finish() {
    if (is_interrupted_) return;
    if (tls_ && !is_broken_) {
        ERR_clear_error();
        SSL_shutdown(tls_.get());
    }
    shutdown(socket_, SHUT_WR);
    // Closing with unread bytes resets the connection, and the answer may be lost with it.
    const Deadline end = Clock::now() + 500ms;
    std::array<char, 4096> rest{};
    for (std::size_t left = 1 << 20; left > 0;) {
        const ssize_t got = recv(socket_, rest.data(), rest.size(), 0);
        if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR)) return;
        if (got < 0 && !wait(POLLIN, end)) return;
        if (Clock::now() >= end) return;
        left -= std::min(left, static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    }
}

}  // namespace feelem::server
