// SPDX-License-Identifier: Apache-2.0
// Numbers as programs print them most of the time (-12.345, 0.10609E-01), read where they stand: eight digits
// at a time, rounded once. Whatever else stands there is left to the general way.
#pragma once

#include "base/eight_digits.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace feelem {

/// How many of eight characters are digits before the first that is none.
inline unsigned leading_digits(std::uint64_t word) {
    const std::uint64_t values = word ^ 0x3030303030303030;  // 0 to 9 of digits alone
    const std::uint64_t others = ((values + 0x7676767676767676) | values) & 0x8080808080808080;
    return static_cast<unsigned>(std::countr_zero(others)) / 8;
}

/// The first `count` (1 to 8) of eight characters as a number, when they are digits.
inline std::uint32_t leading_value(std::uint64_t word, unsigned count) {
    const unsigned shift = 64 - 8 * count;
    return value_of_eight_digits(
        (word << shift) | ((std::uint64_t{0x3030303030303030} >> 4 * count) >> 4 * count)
    );
}

/// A position in a text of which kPlainReach characters may be looked at.
inline constexpr std::ptrdiff_t kPlainReach = 48;

inline const char* behind_blanks(const char* at, const char* end) {
    constexpr std::uint64_t kBlanks = 0x2020202020202020;
    while (end - at >= 8) {
        const std::uint64_t others = load8(at) ^ kBlanks;
        if (others != 0) return at + std::countr_zero(others) / 8;
        at += 8;
    }
    while (at != end && *at == ' ') ++at;
    return at;
}

/// One to seven digits. Moves behind them; false, without moving, when something else stands there.
inline bool scan_plain_integer(const char*& at, std::int64_t& out) {
    const std::uint64_t word = load8(at);
    const unsigned digits = leading_digits(word);
    if (digits == 0 || digits == 8) return false;
    out = leading_value(word, digits);
    at += digits;
    return true;
}

struct PlainReal {
    std::uint64_t digits = 0;  ///< At most nineteen of them.
    int exponent = 0;          ///< Of ten.
    bool negative = false;
};

/// [-]digits.digits[E+-dd[d]] and then a blank or the end of the line, or another number's sign behind the
/// exponent. Moves behind it; false when something else stands there.
inline bool scan_plain(const char*& at, PlainReal& out) {
    constexpr std::array<std::uint32_t, 9> kPowers{
        1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000};
    const char* p = at;
    out.negative = *p == '-';
    p += out.negative ? 1 : 0;
    std::uint64_t word = load8(p);
    const unsigned before = leading_digits(word);
    if (before == 8 || p[before] != '.') return false;
    std::uint64_t digits = before == 0 ? 0 : leading_value(word, before);
    p += before + 1;
    word = load8(p);
    unsigned behind = leading_digits(word);
    if (before + behind == 0) return false;
    if (behind > 0) digits = digits * kPowers[behind] + leading_value(word, behind);
    p += behind;
    if (behind == 8) {
        word = load8(p);
        const unsigned more = leading_digits(word);
        if (more == 8 || before + more > 11) return false;
        if (more > 0) digits = digits * kPowers[more] + leading_value(word, more);
        p += more;
        behind += more;
    }
    int exponent = -static_cast<int>(behind);
    if (*p == 'E') {
        const auto tens = static_cast<unsigned>(p[2] - '0'), units = static_cast<unsigned>(p[3] - '0');
        if ((p[1] != '+' && p[1] != '-') || tens > 9 || units > 9) return false;
        unsigned written = 10 * tens + units;
        const auto third = static_cast<unsigned>(p[4] - '0');
        const char minus = p[1];
        p += 4;
        if (third <= 9) {
            written = 10 * written + third;
            ++p;
        }
        if (*p == '.' || (*p >= '0' && *p <= '9')) return false;
        exponent += minus == '-' ? -static_cast<int>(written) : static_cast<int>(written);
    } else if (*p != ' ' && *p != '\r' && *p != '\n') {
        return false;  // Perhaps an exponent without a letter.
    }
    out.digits = digits;
    out.exponent = exponent;
    at = p;
    return true;
}

/// Digits and power of ten are exact in a double: one rounded operation (Clinger).
inline bool to_double(const PlainReal& plain, double& out) {
    if (plain.digits >> 53U != 0 || plain.exponent < -22 || plain.exponent > 22) return false;
    const auto digits = static_cast<double>(plain.digits);
    const double value = plain.exponent <= 0
                             ? digits / kPowersOfTen[static_cast<std::size_t>(-plain.exponent)]
                             : digits * kPowersOfTen[static_cast<std::size_t>(plain.exponent)];
    out = plain.negative ? -value : value;
    return true;
}

/// The nearest double rounds to the nearest float unless it lies in the middle between two: no middle can lie
/// between a number and the double nearest to it.
inline bool to_float(const PlainReal& plain, float& out) {
    double value = 0;
    if (!to_double(plain, value)) return false;
    constexpr std::uint64_t kBelow = (std::uint64_t{1} << 29U) - 1, kMiddle = std::uint64_t{1} << 28U;
    const double size = std::abs(value);
    const bool usual = size >= static_cast<double>(std::numeric_limits<float>::min()) &&
                       size < static_cast<double>(std::numeric_limits<float>::max());
    if ((std::bit_cast<std::uint64_t>(value) & kBelow) == kMiddle || (!usual && plain.digits != 0))
        return false;
    out = static_cast<float>(value);
    return true;
}

/// As scan_plain; the double or float nearest to what is printed.
inline bool scan_plain_real(const char*& at, double& out) {
    const char* from = at;
    PlainReal plain;
    if (scan_plain(at, plain) && to_double(plain, out)) return true;
    at = from;
    return false;
}
inline bool scan_plain_real(const char*& at, float& out) {
    const char* from = at;
    PlainReal plain;
    if (scan_plain(at, plain) && to_float(plain, out)) return true;
    at = from;
    return false;
}

}  // namespace feelem
