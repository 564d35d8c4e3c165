// SPDX-License-Identifier: Apache-2.0
#include "front_door.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <map>
#include <system_error>
#include <utility>

namespace feelem::server {
namespace {

using namespace std::chrono_literals;

constexpr int kTlsHandshake = 0x16;  ///< First byte of every TLS connection.

std::string_view reason(int status) {
    switch (status) {
    case 405: return "Method Not Allowed";
    case 413: return "Content Too Large";
    case 414: return "URI Too Long";
    case 426: return "Upgrade Required";
    case 431: return "Request Header Fields Too Large";
    case 505: return "HTTP Version Not Supported";
    default: return "Bad Request";
    }
}

}  // namespace

std::string closing_answer(int status) {
    const std::string text =
        status == 426 ? "This address begins with https://\n" : std::string(reason(status)) + "\n";
    return fmt::format(
        "HTTP/1.1 {} {}\r\n{}Content-Type: text/plain; charset=utf-8\r\nContent-Length: {}\r\n"
        "X-Content-Type-Options: nosniff\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n{}",
        status,
        reason(status),
        status == 405 ? "Allow: GET, HEAD\r\n" : "",
        text.size(),
        text
    );
}

FrontDoor::FrontDoor(int listener, SSL_CTX* tls, Handler handler, const DoorLimits& limits)
    : listener_(listener), tls_(tls), handler_(std::move(handler)), limits_(limits) {}

FrontDoor::~FrontDoor() {
    stop();
    close(listener_);
}

void FrontDoor::start() {
    thread_ = std::thread([this] { accept_loop(); });
}

void FrontDoor::stop() {
    is_stopping_ = true;
    shutdown(listener_, SHUT_RDWR);  // Wakes up who waits at it.
    if (thread_.joinable()) thread_.join();
    {
        const std::lock_guard lock(mutex_);
        for (Guest& guest : guests_) {
            if (guest.connection != nullptr) guest.connection->interrupt();
        }
    }
    sweep(true);
}

void FrontDoor::accept_loop() {
    // TLS writes by its own call: a client that is gone must be an error, not a signal. Threads inherit this.
    sigset_t pipe;
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
    while (!is_stopping_) {
        if (is_crowded()) {  // Those sent away leave at once; until then newcomers wait outside.
            sweep(false);
            std::this_thread::sleep_for(1ms);
            continue;
        }
        pollfd asked{listener_, POLLIN, 0};
        if (poll(&asked, 1, 500) > 0) {
            const int socket = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
            if (socket >= 0) {
                admit(socket);
            } else if (errno == EMFILE || errno == ENFILE || errno == ENOMEM) {
                std::this_thread::sleep_for(50ms);  // Until somebody leaves.
            }
        }
        sweep(false);
    }
}

bool FrontDoor::is_crowded() {
    const std::lock_guard lock(mutex_);
    return guests_.size() >= 2 * limits_.connections;
}

void FrontDoor::admit(int socket) {
    const std::lock_guard lock(mutex_);
    const auto staying = static_cast<std::size_t>(std::ranges::count(guests_, false, &Guest::leaving));
    if (staying >= limits_.connections) send_away_one();
    Guest& guest = guests_.emplace_back();
    guest.address = other_address(socket);
    guest.since = Clock::now();
    auto connection = std::make_unique<Connection>(socket, guest.address, is_loopback(guest.address));
    guest.connection = connection.get();
    try {
        guest.thread = std::thread([this, &guest, own = std::move(connection)]() mutable {
            attend(guest, *own);
            const std::lock_guard leaving(mutex_);
            guest.connection = nullptr;
            guest.leaving = true;
            own.reset();
        });
    } catch (const std::system_error&) {  // No more threads: the machine is full, not wrong.
        guests_.pop_back();
    }
}

/// Strangers before those we know; among strangers one of the address with most connections; the oldest.
void FrontDoor::send_away_one() {
    std::map<std::string_view, std::size_t> crowd;
    for (const Guest& guest : guests_) {
        if (!guest.leaving && !guest.known) ++crowd[guest.address];
    }
    const auto merit = [&](const Guest& guest) {
        const auto found = crowd.find(guest.address);
        const std::size_t many = guest.known || found == crowd.end() ? 0 : found->second;
        return std::tuple(guest.leaving, guest.known, ~many, guest.since);
    };
    const auto least = std::ranges::min_element(guests_, {}, merit);
    if (least == guests_.end() || least->leaving || least->connection == nullptr) return;
    least->leaving = true;
    least->connection->interrupt();
}

/// Ends the threads of those who have left; at the end of all.
void FrontDoor::sweep(bool all) {
    std::list<Guest> gone;
    {
        const std::lock_guard lock(mutex_);
        for (auto guest = guests_.begin(); !all && guest != guests_.end();) {
            const auto next = std::next(guest);
            if (guest->connection == nullptr) gone.splice(gone.end(), guests_, guest);
            guest = next;
        }
    }
    // At the end nobody adds any more, and those inside need the lock to leave.
    for (Guest& guest : all ? guests_ : gone) guest.thread.join();
    if (all) guests_.clear();
}

void FrontDoor::attend(Guest& guest, Connection& connection) {
    try {
        serve(guest, connection);
    } catch (const std::exception&) {
        // Out of memory for this one: it is closed, the others go on.
    }
}

void FrontDoor::serve(Guest& guest, Connection& connection) {
    if (tls_ != nullptr) {
        const Deadline end = Clock::now() + limits_.handshake;
        const int first = connection.peek(end);
        if (first < 0) return;
        if (first == kTlsHandshake) {
            if (!connection.begin_tls(tls_, end)) return;
        } else if (!connection.is_local()) {
            connection.write(closing_answer(426));
            return connection.finish();
        }
    }
    std::string pending;
    while (!is_stopping_) {
        HeadAnswer found = next_head(connection, pending, guest.known ? limits_.known_idle : limits_.idle);
        if (found.state == HeadState::Incomplete) return;
        connection.begin_answer();
        if (found.state == HeadState::Refused) {
            connection.write(closing_answer(found.status));
            return connection.finish();
        }
        pending.erase(0, found.size);
        const Outcome outcome = handler_(connection, found.head);
        {
            const std::lock_guard lock(mutex_);
            guest.known = guest.known || outcome.known;
            guest.since = Clock::now();
        }
        if (!outcome.keep) return connection.finish();
    }
}

/// Incomplete: the connection is over.
HeadAnswer FrontDoor::next_head(
    Connection& connection, std::string& pending, std::chrono::milliseconds idle
) {
    Deadline end = Clock::now() + (pending.empty() ? idle : limits_.head);
    std::array<char, 4096> bytes{};
    while (true) {
        if (!pending.empty()) {
            HeadAnswer found = read_head(pending);
            if (found.state != HeadState::Incomplete) return found;
        }
        const std::size_t got = connection.read(bytes.data(), bytes.size(), end);
        if (got == 0) return {};
        if (pending.empty()) end = Clock::now() + limits_.head;
        pending.append(bytes.data(), got);
        if (Clock::now() >= end) return {};
    }
}

}  // namespace feelem::server
