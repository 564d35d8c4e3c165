// SPDX-License-Identifier: Apache-2.0
// Eight digits at a time in one register (Lemire's SWAR digits), and digits with a power of ten rounded once
// (Clinger): what fast readers of numbers share.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace feelem {

static_assert(std::endian::native == std::endian::little, "the digit tricks below are for little-endian");

inline std::uint64_t load8(const char* at) {
    std::uint64_t word = 0;
    std::memcpy(&word, at, sizeof word);
    return word;
}

/// Whether the same characters stand in both; for a few of them, which no call is worth.
inline bool same_characters(const char* a, const char* b, std::size_t count) {
    if (count < 8) {
        for (std::size_t i = 0; i < count; ++i) {
            if (a[i] != b[i]) return false;
        }
        return true;
    }
    std::uint64_t differ = load8(a + count - 8) ^ load8(b + count - 8);
    for (std::size_t i = 0; i + 8 < count; i += 8) differ |= load8(a + i) ^ load8(b + i);
    return differ == 0;
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

/// Eight columns: blanks, then digits up to the last one. Bits are set in `bad` when they are anything else,
/// so that a row of columns is tested once.
inline std::uint32_t eight_columns(std::uint64_t word, std::uint64_t& bad) {
    // As bytes of ones from the low end, blanks that only lead make z & (z + 1) vanish.
    const std::uint64_t ones = ((~word & 0x1010101010101010) >> 4) * 0xFF;
    const std::uint64_t digits = word | 0x1010101010101010;
    bad |= ones & (ones + 1);
    bad |= (word ^ 0x2020202020202020) & ones;
    bad |= static_cast<std::uint64_t>(ones == ~std::uint64_t{0} || !is_eight_digits(digits));
    return value_of_eight_digits(digits);
}

/// Blanks, then digits to the end of a field. False: something else, or nothing; then the caller takes the
/// general way. Reads no byte outside the field.
inline bool fast_integer(const char* at, std::size_t width, std::int64_t& out) {
    constexpr std::size_t kMostDigits = 18;
    std::size_t i = 0;
    if (width >= 8) {
        std::uint64_t bad = 0;
        const std::uint32_t value = eight_columns(load8(at + width - 8), bad);
        for (; i + 8 < width; ++i) bad |= static_cast<std::uint64_t>(at[i] != ' ');
        if (bad == 0) {
            out = value;
            return true;
        }
        i = 0;
    }
    while (i < width && at[i] == ' ') ++i;
    if (i == width || width - i > kMostDigits) return false;
    std::int64_t value = 0;
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

inline constexpr std::array<std::uint64_t, 9> kWholePowersOfTen{
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000};

/// How many of the first characters of a word are digits.
inline unsigned count_digits(std::uint64_t word) {
    const std::uint64_t digits = word ^ 0x3030303030303030;
    // A carry out of a character that is no digit reaches only those behind it.
    const std::uint64_t others = ((digits + 0x7676767676767676) | digits) & 0x8080808080808080;
    return static_cast<unsigned>(std::countr_zero(others)) / 8;
}

/// The value of the first `count` characters, which are digits; at most 8.
inline std::uint64_t value_of_digits(std::uint64_t word, unsigned count) {
    if (count == 0) return 0;
    // Zeros before the first digit.
    const unsigned shift = 64 - 8 * count;
    return value_of_eight_digits(shift == 0 ? word : (word << shift) | (0x3030303030303030 >> (64 - shift)));
}

/// digits x 10^exponent in one rounding, where that is exact.
inline bool scale_exactly(std::uint64_t digits, int exponent, bool negative, double& out) {
    constexpr std::uint64_t kMostDigits = std::uint64_t{1} << 53;
    if (digits > kMostDigits || exponent < -22 || exponent > 22) return false;
    const auto whole = static_cast<double>(digits);
    const double value = exponent <= 0 ? whole / kPowersOfTen[static_cast<std::size_t>(-exponent)]
                                       : whole * kPowersOfTen[static_cast<std::size_t>(exponent)];
    out = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) | (std::uint64_t{negative} << 63));
    return true;
}

}  // namespace feelem
