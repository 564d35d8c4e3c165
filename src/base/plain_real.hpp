// SPDX-License-Identifier: Apache-2.0
// Numbers as programs print them most of the time (-12.345, 0.10609E-01), read where they stand: eight digits
// at a time, rounded once. Whatever else stands there is left to the general way.
#pragma once

#include "base/eight_digits.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace feelem {

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
    const unsigned digits = count_digits(word);
    if (digits == 0 || digits == 8) return false;
    out = static_cast<std::int64_t>(value_of_digits(word, digits));
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
    const char* p = at;
    out.negative = *p == '-';
    p += out.negative ? 1 : 0;
    std::uint64_t word = load8(p);
    const unsigned before = count_digits(word);
    if (before == 8 || p[before] != '.') return false;
    std::uint64_t digits = value_of_digits(word, before);
    p += before + 1;
    word = load8(p);
    unsigned behind = count_digits(word);
    if (before + behind == 0) return false;
    digits = digits * kWholePowersOfTen[behind] + value_of_digits(word, behind);
    p += behind;
    if (behind == 8) {
        word = load8(p);
        const unsigned more = count_digits(word);
        if (more == 8 || before + more > 11) return false;
        digits = digits * kWholePowersOfTen[more] + value_of_digits(word, more);
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

/// The nearest double rounds to the nearest float unless it lies in the middle between two: no middle can lie
/// between a number and the double nearest to it.
inline bool to_float(const PlainReal& plain, float& out) {
    double value = 0;
    if (!scale_exactly(plain.digits, plain.exponent, plain.negative, value)) return false;
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
    if (scan_plain(at, plain) && scale_exactly(plain.digits, plain.exponent, plain.negative, out))
        return true;
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
