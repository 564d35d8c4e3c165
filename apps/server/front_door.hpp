// SPDX-License-Identifier: Apache-2.0
// Accepts connections, lets in so many, reads heads of requests within limits, and hands good ones on.
#pragma once

#include "connection.hpp"
#include "request_head.hpp"

#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <thread>

namespace feelem::server {

struct DoorLimits {
    std::size_t connections = 96;  ///< When there are more, the one that deserves it least is closed.
    std::chrono::milliseconds handshake{10'000};
    std::chrono::milliseconds head{10'000};        ///< From its first byte to its last.
    std::chrono::milliseconds idle{15'000};        ///< Before a request, of somebody unknown.
    std::chrono::milliseconds known_idle{90'000};  ///< … of somebody who had the right to ask.
};

class FrontDoor {
public:
    struct Outcome {
        bool keep = false;   ///< Another request may follow.
        bool known = false;  ///< Who asked had the right to.
    };
    using Handler = std::function<Outcome(Connection&, const RequestHead&)>;

    /// `listener`: a bound socket, taken over. `tls`: null for loopback only; else plain connections are
    /// served from this machine alone.
    FrontDoor(int listener, SSL_CTX* tls, Handler handler, const DoorLimits& limits);
    ~FrontDoor();
    FrontDoor(const FrontDoor&) = delete;
    FrontDoor& operator=(const FrontDoor&) = delete;

    void start();
    void stop();

private:
    struct Guest {
        std::thread thread;
        Connection* connection = nullptr;  ///< Null once it is over.
        std::string address;
        Clock::time_point since;
        bool known = false;
        bool leaving = false;
    };
    void accept_loop();
    bool is_crowded();
    void admit(int socket);
    void send_away_one();
    void sweep(bool all);
    void attend(Guest& guest, Connection& connection);
    void serve(Guest& guest, Connection& connection);
    HeadAnswer next_head(Connection& connection, std::string& pending, std::chrono::milliseconds idle);

    int listener_;
    SSL_CTX* tls_;
    Handler handler_;
    DoorLimits limits_;
    std::thread thread_;
    std::atomic<bool> is_stopping_ = false;
    std::mutex mutex_;
    std::list<Guest> guests_;
};

/// A short answer without any content of ours, and the end of the connection.
std::string closing_answer(int status);

}  // namespace feelem::server
