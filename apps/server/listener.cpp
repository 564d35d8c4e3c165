// SPDX-License-Identifier: Apache-2.0
#include "listener.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace feelem::server {
namespace {

constexpr int kBacklog = 1024;  ///< A crowd must not make others wait a second for their turn.
constexpr int kPortsTried = 20;

/// -1 when it is taken. Without SO_REUSEPORT: two servers must not share a port.
int bind_socket(int family, const sockaddr* address, socklen_t size) {
    const int socket = ::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket < 0) return -1;
    const int yes = 1, no = 0;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if (family == AF_INET6) setsockopt(socket, IPPROTO_IPV6, IPV6_V6ONLY, &no, sizeof no);
    if (bind(socket, address, size) == 0 && listen(socket, kBacklog) == 0) return socket;
    close(socket);
    return -1;
}

int bind_v4(std::uint32_t address, int port) {
    sockaddr_in v4{};
    v4.sin_family = AF_INET;
    v4.sin_port = htons(static_cast<std::uint16_t>(port));
    v4.sin_addr.s_addr = htonl(address);
    return bind_socket(AF_INET, reinterpret_cast<const sockaddr*>(&v4), sizeof v4);
}

bool has_v6() {
    const int socket = ::socket(AF_INET6, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket >= 0) close(socket);
    return socket >= 0;
}

/// IPv4 comes through the same socket, where there is IPv6 at all.
int bind_everywhere(int port) {
    sockaddr_in6 v6{};
    v6.sin6_family = AF_INET6;
    v6.sin6_port = htons(static_cast<std::uint16_t>(port));
    v6.sin6_addr = in6addr_any;
    return bind_socket(AF_INET6, reinterpret_cast<const sockaddr*>(&v6), sizeof v6);
}

int port_of(int socket) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
    // The port stands at the same place in both families.
    sockaddr_in head{};
    std::memcpy(&head, &address, sizeof head);
    return ntohs(head.sin_port);
}

}  // namespace

Listener open_listener(const ListenOptions& options) {
    const bool with_v6 = options.everywhere && has_v6();
    const int first = options.port;
    const int last = options.only_that || first == 0 ? first : std::min(first + kPortsTried, 65535);
    for (int port = first; port <= last; ++port) {
        const int socket = with_v6 ? bind_everywhere(port)
                                   : bind_v4(options.everywhere ? INADDR_ANY : INADDR_LOOPBACK, port);
        if (socket >= 0) return {socket, port_of(socket)};
    }
    throw Error(
        Code::BadOption,
        "--port",
        fmt::format(
            "port {} is in use on this machine; another one, or 0 for any that is free?", options.port
        )
    );
}

}  // namespace feelem::server
