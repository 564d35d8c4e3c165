// SPDX-License-Identifier: Apache-2.0
// A client that says what it is told to, well-behaved or not, plain or under TLS.
#pragma once

#include "page_server.hpp"

#include <openssl/ssl.h>

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

namespace feelem::test {

class Client {
public:
    /// Connects to 127.0.0.1; `tls`: and shakes hands, trusting anybody.
    explicit Client(int port, bool tls = false);
    ~Client();
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    bool is_connected() const { return socket_ >= 0; }
    bool send(std::string_view text);
    /// Until the other side closes or is silent for so long.
    std::string receive(std::chrono::milliseconds silence = std::chrono::seconds(5));
    /// One answer with its body, the connection left open; by its Content-Length.
    std::string receive_one(bool has_body = true);
    /// True when the other side closes within that time.
    bool is_closed_within(std::chrono::milliseconds time);
    /// No goodbye.
    void cut();
    int socket() const { return socket_; }
    std::string fingerprint() const;  ///< Of the certificate that was shown.

private:
    long read(char* bytes, std::size_t size, std::chrono::milliseconds silence);

    struct FreeTls {
        void operator()(SSL* tls) const { SSL_free(tls); }
    };
    int socket_ = -1;
    std::unique_ptr<SSL, FreeTls> tls_;
};

struct Asked {
    std::string method = "GET";
    std::string headers{};  ///< Lines with their ends.
    std::string host{};     ///< Empty: 127.0.0.1 and the port.
};
/// A whole exchange on a connection of its own; the answer with its head.
std::string ask(int port, bool tls, const std::string& target, const Asked& asked = {});

int status_of(const std::string& answer);
std::string body_of(const std::string& answer);
std::string header_of(const std::string& answer, const std::string& name);

/// "/TOKEN/" or "/".
std::string prefix_of(const server::PageServer& server);

}  // namespace feelem::test
