// SPDX-License-Identifier: Apache-2.0
#include "qr_code.hpp"

#include <fmt/format.h>
#include <qrcodegen/qrcodegen.hpp>

#include <array>
#include <string_view>

namespace feelem::server {
namespace {

constexpr int kQuietZone = 4;  ///< As the standard wants it, or cameras do not find the code.

qrcodegen::QrCode code_of(const std::string& text) {
    return qrcodegen::QrCode::encodeText(text.c_str(), qrcodegen::QrCode::Ecc::MEDIUM);
}

}  // namespace

std::string qr_for_terminal(const std::string& text) {
    const qrcodegen::QrCode code = code_of(text);
    constexpr std::array<std::string_view, 4> kHalves{" ", "▄", "▀", "█"};
    const int last = code.getSize() + kQuietZone;
    std::string out;
    for (int y = -kQuietZone; y < last; y += 2) {
        out += "\x1b[38;5;16;48;5;231m";  // Black on white, of the colours that no theme changes.
        for (int x = -kQuietZone; x < last; ++x) {
            // Outside of the code every module is light.
            out += kHalves[(code.getModule(x, y) ? 2U : 0U) + (code.getModule(x, y + 1) ? 1U : 0U)];
        }
        out += "\x1b[0m\n";
    }
    return out;
}

std::string qr_for_page(const std::string& text) {
    const qrcodegen::QrCode code = code_of(text);
    const int side = code.getSize() + 2 * kQuietZone;
    std::string path;
    for (int y = 0; y < code.getSize(); ++y) {
        for (int x = 0; x < code.getSize(); ++x) {
            if (code.getModule(x, y)) path += fmt::format("M{},{}h1v1h-1z", x + kQuietZone, y + kQuietZone);
        }
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"code\" viewBox=\"0 0 {0} {0}\" role=\"img\" "
        "aria-label=\"QR code of the link\" "
        "shape-rendering=\"crispEdges\"><rect width=\"{0}\" height=\"{0}\" fill=\"#fff\"/><path d=\"{1}\" "
        "fill=\"#000\"/></svg>",
        side,
        path
    );
}

}  // namespace feelem::server
