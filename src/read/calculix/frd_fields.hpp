// SPDX-License-Identifier: Apache-2.0
// Must: read the two fixed-width fields of .frd text, I10 (or I5) and E12.5, fast and never wrong.
// Assumes: `at` has as many readable bytes as the field is wide.
// Algorithm: eight characters at a time in one register (Lemire's SWAR digits). An E12.5 has six digits, so
// digits x 10^e is one exactly rounded double operation while |e| <= 22 (Clinger); the second rounding to
// float is right unless the double falls on a tie between floats, which is tested for.
// Data: none. What does not look exactly like that is refused, and the caller takes the general way.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace feelem::frd {

static_assert(std::endian::native == std::endian::little, "the digit tricks below are for little-endian");

inline std::uint64_t load8(const char* at) {
    std::uint64_t word = 0;
    std::memcpy(&word, at, sizeof word);
    return word;
}

inline bool is_eight_digits(std::uint64_t word) {
    return ((word & 0xF0F0F0F0F0F0F0F0) | (((word + 0x0606060606060606) & 0xF0F0F0F0F0F0F0F0) >> 4)) ==
           0x3333333333333333;
}

inline std::uint32_t value_of_eight_digits(std::uint64_t word) {
    constexpr std::uint64_t kMask = 0x000000FF000000FF;
    constexpr std::uint64_t kHundreds = 0x000F424000000064;  // 100 + (1000000 << 32)
    constexpr std::uint64_t kUnits = 0x0000271000000001;     // 1 + (10000 << 32)
    word -= 0x3030303030303030;
    word = word * 10 + (word >> 8);
    word = ((word & kMask) * kHundreds + ((word >> 16) & kMask) * kUnits) >> 32;
    return static_cast<std::uint32_t>(word);
}

/// Blanks, then digits to the end of the field. False: something else, or nothing.
inline bool fast_integer(const char* at, std::size_t width, std::int64_t& out) {
    std::int64_t value = 0;
    std::size_t i = 0;
    if (width == 10) {
        // Blanks may only lead: as bytes of ones from the low end they make z & (z + 1) vanish.
        const std::uint64_t word = load8(at + 2);
        const std::uint64_t blank = (~word & 0x1010101010101010) >> 4;
        const std::uint64_t ones = blank * 0xFF;
        const std::uint64_t digits = word | 0x1010101010101010;
        const bool plain = at[0] == ' ' && at[1] == ' ' && (ones & (ones + 1)) == 0 &&
                           ones != ~std::uint64_t{0} && (word & 0xC0C0C0C0C0C0C0C0) == 0 &&
                           is_eight_digits(digits) && ((word ^ 0x2020202020202020) & ones) == 0;
        if (plain) {
            out = value_of_eight_digits(digits);
            return true;
        }
    }
    while (i < width && at[i] == ' ') ++i;
    if (i == width) return false;
    for (; i < width; ++i) {
        if (at[i] < '0' || at[i] > '9') return false;
        value = value * 10 + (at[i] - '0');
    }
    out = value;
    return true;
}

inline constexpr std::array<double, 23> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// "-1.23456E-01" or " 1.23456E-01", nothing else. False: take the general way. Without branches that depend
/// on the number: signs and exponents of results are as good as random.
template <class T>
bool fast_real12(const char* at, T& out) {
    const std::uint64_t word = load8(at);
    // s d . d d d d d  ->  0 0 d d d d d d
    const std::uint64_t digits = (word & 0xFFFFFFFFFF000000) | ((word & 0xFF00) << 8) | 0x3030;
    const auto tens = static_cast<unsigned>(at[10] - '0');
    const auto units = static_cast<unsigned>(at[11] - '0');
    const bool negative = at[0] == '-';
    const bool shrinks = at[9] == '-';
    const bool plain = (negative | (at[0] == ' ')) & (at[2] == '.') & (at[8] == 'E') &
                       (shrinks | (at[9] == '+')) & (tens <= 9) & (units <= 9) & is_eight_digits(digits);
    const int written = static_cast<int>(tens * 10 + units);
    const int exponent = (shrinks ? -written : written) - 5;
    if (!plain || exponent < -22 || exponent > 22) return false;
    // One of the two factors is 1, so that there is one rounding.
    const auto up = static_cast<std::size_t>(exponent > 0 ? exponent : 0);
    const auto down = static_cast<std::size_t>(exponent < 0 ? -exponent : 0);
    const double mantissa = value_of_eight_digits(digits);
    const double value = mantissa * kPowersOfTen[up] / kPowersOfTen[down];
    auto bits = std::bit_cast<std::uint64_t>(value);
    if constexpr (std::is_same_v<T, float>) {
        if ((bits & 0x1FFFFFFF) == 0x10000000) return false;
    }
    bits |= std::uint64_t{negative} << 63;
    out = static_cast<T>(std::bit_cast<double>(bits));
    return true;
}

}  // namespace feelem::frd
