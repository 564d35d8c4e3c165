// SPDX-License-Identifier: Apache-2.0
#include "base/number.hpp"

#include "base/nearest_double.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>
#include <system_error>

namespace feelem {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\0';
}

bool equal_in_any_case(std::string_view text, std::string_view lower) {
    return std::ranges::equal(text, lower, [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b;
    });
}

bool is_not_a_number(std::string_view text) {
    if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
    return equal_in_any_case(text, "nan") || equal_in_any_case(text, "inf") ||
           equal_in_any_case(text, "infinity") ||
           (!text.empty() && text.find_first_not_of('*') == std::string_view::npos);
}

template <class T>
std::optional<T> parse_plain(std::string_view text) {
    T value{};
    const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = end == text.data() + text.size();
    // fast_float reports overflow as an error but still gives infinity (or zero on underflow).
    if (!whole || (error != std::errc{} && error != std::errc::result_out_of_range)) return std::nullopt;
    return value;
}

/// Rewrites 1.5D+02 and 1.5-101 with an E in between.
template <class T>
std::optional<T> parse_fortran(std::string_view text) {
    std::array<char, 64> buffer{};
    if (text.empty() || text.size() + 1 > buffer.size()) return std::nullopt;
    const std::size_t mark = text.find_first_of("dDqQ+-", 1);
    if (mark == std::string_view::npos) return std::nullopt;
    const bool has_letter = text[mark] != '+' && text[mark] != '-';
    char* out = std::copy_n(text.data(), mark, buffer.data());
    *out++ = 'e';
    std::string_view exponent = text.substr(mark + (has_letter ? 1 : 0));
    if (exponent.empty() || exponent.find_first_not_of("0123456789", 1) != std::string_view::npos)
        return std::nullopt;
    out = std::copy(exponent.begin(), exponent.end(), out);
    return parse_plain<T>({buffer.data(), static_cast<std::size_t>(out - buffer.data())});
}

template <class T>
std::optional<T> parse_real(std::string_view field) {
    std::string_view text = trim(field);
    if (is_not_a_number(text)) return std::numeric_limits<T>::quiet_NaN();
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-') || text.starts_with('+')) return std::nullopt;
    }
    if (const auto value = parse_plain<T>(text)) return value;
    return parse_fortran<T>(text);
}

}  // namespace

std::string_view trim(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::optional<std::int64_t> parse_integer(std::string_view field) {
    std::string_view text = trim(field);
    if (text.starts_with('+')) text.remove_prefix(1);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<float> parse_float(std::string_view field) {
    return parse_real<float>(field);
}
std::optional<double> parse_double(std::string_view field) {
    return parse_real<double>(field);
}

bool nearest_double(std::uint64_t digits, int exponent, bool negative, double& out) {
    using Format = fast_float::binary_format<double>;
    const fast_float::adjusted_mantissa found = fast_float::compute_float<Format>(exponent, digits);
    if (found.power2 < 0) return false;
    const std::uint64_t bits = found.mantissa | (static_cast<std::uint64_t>(found.power2) << 52U);
    out = std::bit_cast<double>(bits | (std::uint64_t{negative} << 63U));
    return true;
}

}  // namespace feelem
