// SPDX-License-Identifier: Apache-2.0
// The page that brings a headset or a phone here: the link as a QR code, the fingerprint, what to do.
#pragma once

#include <string>
#include <vector>

namespace feelem::server {

struct ConnectFacts {
    std::vector<std::string> links;  ///< The first is in the code.
    std::string fingerprint;
    bool is_own_certificate = true;
    int port = 0;
    std::string usb_link;
};
std::string connect_page(const ConnectFacts& facts);
std::string connect_style();

/// The page with a hint in its head that there is such a page.
std::string with_connect_hint(std::string index);

}  // namespace feelem::server
