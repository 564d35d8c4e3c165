// SPDX-License-Identifier: Apache-2.0
// Must: read the real field of .frd text, E12.5, fast and never wrong (integers: base/eight_digits.hpp).
// Assumes: `at` has as many readable bytes as the field is wide.
// Algorithm: eight characters at a time in one register (Lemire's SWAR digits). An E12.5 has six digits, so
// digits x 10^e is one exactly rounded double operation while |e| <= 22 (Clinger); the second rounding to
// float is right unless the double falls on a tie between floats, which is tested for.
// Data: none. What does not look exactly like that is refused, and the caller takes the general way.
#pragma once

#include "base/eight_digits.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace feelem::frd {

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
