// SPDX-License-Identifier: Apache-2.0
// By which names and addresses others on the local network reach this machine.
#pragma once

#include <string>
#include <vector>

namespace feelem::server {

struct LanNames {
    /// Of all interfaces that are up, loopback and link-local left out; the one that leads outside first.
    std::vector<std::string> addresses;
    std::string host;  ///< "desk"; empty when it is not a name for others.
};
LanNames lan_names();

/// "192.168.1.7" as it is, "fd00::7" as "[fd00::7]".
std::string in_url(const std::string& address);

}  // namespace feelem::server
