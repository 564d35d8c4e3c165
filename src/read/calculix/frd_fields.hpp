// SPDX-License-Identifier: Apache-2.0
// Must: read the real field of .frd text, E12.5, fast and never wrong (integers: base/eight_digits.hpp).
// Assumes: `at` has as many readable bytes as the field is wide.
// Algorithm: eight characters at a time in one register (Lemire's SWAR digits). An E12.5 has six digits, so
// digits x 10^e is one exactly rounded double operation while |e| <= 22 (Clinger); the second rounding to
// float is right unless the double falls on a tie between floats, which is tested for.
// Data: none. What does not look exactly like that is refused, and the caller takes the general way.
#pragma once

#include "base/eight_digits.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace feelem::frd {

/// Multiply, then divide: one of them is 1.
struct Scale {
    double up;
    double down;
};
/// By exponent + 32.
inline constexpr std::array<Scale, 64> kScales = [] {
    std::array<Scale, 64> scales{};
    for (Scale& scale : scales) scale = {1, 1};
    for (std::size_t i = 0; i < kPowersOfTen.size(); ++i) {
        scales[32 + i] = {kPowersOfTen[i], 1};
        scales[32 - i] = {1, kPowersOfTen[i]};
    }
    return scales;
}();

/// "-1.23456E-01" or " 1.23456E-01", nothing else: bits are set in `odd` when it is anything else, so that a
/// row of fields is tested once. Without branches that depend on the number: signs and exponents of results
/// are as good as random.
template <class T>
[[gnu::always_inline]] inline T real12(const char* at, std::uint64_t& odd) {
    constexpr std::uint64_t kTens = 63;  // Exponents beyond are refused; the table must be safe for any.
    const std::uint64_t word = load8(at);
    // s d . d d d d d  ->  0 0 d d d d d d
    const std::uint64_t digits = (word & 0xFFFFFFFFFF000000) | ((word & 0xFF00) << 8) | 0x3030;
    const auto tens = static_cast<unsigned>(at[10] - '0');
    const auto units = static_cast<unsigned>(at[11] - '0');
    const bool negative = at[0] == '-';
    const bool shrinks = at[9] == '-';
    odd |= static_cast<std::uint64_t>(at[0] != (negative ? '-' : ' '));
    odd |= static_cast<std::uint64_t>(at[9] != (shrinks ? '-' : '+'));
    odd |= static_cast<std::uint64_t>((word & 0xFF0000) ^ (std::uint64_t{'.'} << 16));
    odd |= static_cast<std::uint64_t>(at[8] ^ 'E');
    odd |= static_cast<std::uint64_t>(!is_eight_digits(digits));
    odd |= static_cast<std::uint64_t>(tens > 9) | static_cast<std::uint64_t>(units > 9);
    const int written = static_cast<int>(tens * 10 + units);
    const int exponent = (shrinks ? -written : written) - 5;
    odd |= static_cast<std::uint64_t>(exponent < -22) | static_cast<std::uint64_t>(exponent > 22);
    // One of the two factors is 1, so that there is one rounding.
    const auto scale = kScales[static_cast<std::uint64_t>(exponent + 32) & kTens];
    const double value = static_cast<double>(value_of_eight_digits(digits)) * scale.up / scale.down;
    auto bits = std::bit_cast<std::uint64_t>(value);
    // Rounded to float, a double halfway between two could have been rounded there.
    if constexpr (std::is_same_v<T, float>)
        odd |= static_cast<std::uint64_t>((bits & 0x1FFFFFFF) == 0x10000000);
    bits |= std::uint64_t{negative} << 63;
    return static_cast<T>(std::bit_cast<double>(bits));
}

/// The same for one field. False: take the general way.
template <class T>
bool fast_real12(const char* at, T& out) {
    std::uint64_t odd = 0;
    out = real12<T>(at, odd);
    return odd == 0;
}

}  // namespace feelem::frd
