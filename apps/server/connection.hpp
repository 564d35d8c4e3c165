// SPDX-License-Identifier: Apache-2.0
// One accepted socket, plain or under TLS. Every wait has an end.
#pragma once

#include <openssl/ssl.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace feelem::server {

using Clock = std::chrono::steady_clock;
using Deadline = Clock::time_point;

class Connection {
public:
    /// Takes the socket over. `address` is the other side's.
    Connection(int socket, std::string address, bool is_local);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// First byte that has come, left where it is; -1 when none came in time.
    int peek(Deadline end);
    /// False when the handshake fails or does not end in time.
    bool begin_tls(SSL_CTX* context, Deadline end);
    /// What has come, at most `size` bytes; 0 when the other side ended, fell silent or broke the rules.
    std::size_t read(char* bytes, std::size_t size, Deadline end);
    /// All of it, or false.
    bool write(std::string_view bytes);
    /// A new answer begins: the time that writing may take is counted from here.
    void begin_answer();
    /// Any thread: whoever waits here wakes up and finds it closed.
    void interrupt();
    /// Whether the other side has closed: nobody waits for an answer.
    bool is_gone() const;
    /// Says goodbye so that the last answer arrives even when the other side is still sending.
    void finish();

    bool is_tls() const { return tls_ != nullptr; }
    bool is_local() const { return is_local_; }
    const std::string& address() const { return address_; }
    const std::string& own_address() const { return own_address_; }
    int socket() const { return socket_; }

private:
    bool wait(short events, Deadline end);
    /// After a call into TLS that wants more: false when it is over.
    bool wait_for_tls(int result, Deadline end);

    struct FreeTls {
        void operator()(SSL* tls) const { SSL_free(tls); }
    };
    int socket_;
    std::string address_, own_address_;
    bool is_local_;
    bool is_broken_ = false;  ///< TLS must not be spoken to again.
    std::atomic<bool> is_interrupted_ = false;
    std::unique_ptr<SSL, FreeTls> tls_;
    Clock::time_point answer_began_;
    std::size_t answer_bytes_ = 0;
};

/// "192.168.1.7" of a socket's other (or own) end; IPv4 inside IPv6 as IPv4, IPv6 without its brackets.
std::string other_address(int socket);
std::string own_address(int socket);
bool is_loopback(const std::string& address);

}  // namespace feelem::server
