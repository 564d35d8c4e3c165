// SPDX-License-Identifier: Apache-2.0
// The socket that connections come to.
#pragma once

namespace feelem::server {

struct Listener {
    int socket = -1;
    int port = 0;
};

struct ListenOptions {
    int port = 0;             ///< 0: any free one.
    bool only_that = false;   ///< Else the next free port of the twenty after it.
    bool everywhere = false;  ///< On all interfaces; else on loopback.
};
/// Throws Error(BadOption) when no port is free.
Listener open_listener(const ListenOptions& options);

}  // namespace feelem::server
