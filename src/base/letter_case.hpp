// SPDX-License-Identifier: Apache-2.0
// Capitals and small letters of ASCII, whatever the locale; other bytes stay.
#pragma once

#include <string>
#include <string_view>

namespace feelem {

constexpr char to_capital(char c) noexcept {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr char to_small(char c) noexcept {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string upper_case(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = to_capital(c);
    return out;
}
inline std::string lower_case(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = to_small(c);
    return out;
}

}  // namespace feelem
