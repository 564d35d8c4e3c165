// SPDX-License-Identifier: Apache-2.0
// A link as a QR code: for the terminal and for the page.
#pragma once

#include <string>

namespace feelem::server {

/// Two rows of the code in one line of text; dark on light by its own colours, whatever the terminal's are.
std::string qr_for_terminal(const std::string& text);
/// An <svg> element, which is a picture by itself too.
std::string qr_for_page(const std::string& text);

}  // namespace feelem::server
