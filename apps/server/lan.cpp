// SPDX-License-Identifier: Apache-2.0
#include "lan.hpp"

#include "base/letter_case.hpp"
#include "connection.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace feelem::server {
namespace {

/// Connecting a datagram socket sends nothing; the system only chooses the way. The address is one for
/// documents (RFC 5737).
std::string address_that_leads_outside() {
    const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket < 0) return {};
    sockaddr_in outside{};
    outside.sin_family = AF_INET;
    outside.sin_port = htons(9);
    inet_pton(AF_INET, "192.0.2.1", &outside.sin_addr);
    const bool found = connect(socket, reinterpret_cast<sockaddr*>(&outside), sizeof outside) == 0;
    std::string address = found ? own_address(socket) : std::string();
    close(socket);
    return address;
}

std::string usable_address(const ifaddrs& entry) {
    const bool is_up = (entry.ifa_flags & IFF_UP) != 0 && (entry.ifa_flags & IFF_LOOPBACK) == 0;
    if (entry.ifa_addr == nullptr || !is_up) return {};
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (entry.ifa_addr->sa_family == AF_INET) {
        sockaddr_in v4{};
        std::memcpy(&v4, entry.ifa_addr, sizeof v4);
        inet_ntop(AF_INET, &v4.sin_addr, text.data(), text.size());
        const bool is_link_local = std::string_view(text.data()).starts_with("169.254.");
        return is_link_local ? std::string() : std::string(text.data());
    }
    if (entry.ifa_addr->sa_family != AF_INET6) return {};
    sockaddr_in6 v6{};
    std::memcpy(&v6, entry.ifa_addr, sizeof v6);
    if (IN6_IS_ADDR_LINKLOCAL(&v6.sin6_addr)) return {};  // Not without a zone, which no browser takes.
    inet_ntop(AF_INET6, &v6.sin6_addr, text.data(), text.size());
    return text.data();
}

std::string host_name() {
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) != 0) return {};
    std::string host = lower_case(name.data());
    const bool is_plain = std::ranges::all_of(host, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
    });
    return is_plain && host.size() < 200 && host != "localhost" ? host : std::string();
}

}  // namespace

LanNames lan_names() {
    LanNames names;
    ifaddrs* list = nullptr;
    if (getifaddrs(&list) == 0) {
        for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
            std::string address = usable_address(*entry);
            if (!address.empty()) names.addresses.push_back(std::move(address));
        }
        freeifaddrs(list);
    }
    std::ranges::sort(names.addresses);
    names.addresses.erase(std::unique(names.addresses.begin(), names.addresses.end()), names.addresses.end());
    // IPv4 first: easier to read aloud. In front of all, the one by which others see us.
    const auto is_v6 = [](const std::string& address) { return address.find(':') != std::string::npos; };
    const std::string best = address_that_leads_outside();
    std::ranges::stable_sort(names.addresses, {}, [&](const std::string& address) {
        return address == best ? 0 : is_v6(address) ? 2 : 1;
    });
    names.host = host_name();
    return names;
}

std::string in_url(const std::string& address) {
    return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

}  // namespace feelem::server
