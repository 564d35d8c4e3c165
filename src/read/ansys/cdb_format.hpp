// SPDX-License-Identifier: Apache-2.0
// Columns of a block's rows: the Fortran format on its second line, and numbers out of such columns.
#pragma once

#include "base/eight_digits.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace feelem::ansys::cdb {

/// (3i9,6e21.13e3), (1i7,2i9,6e21.13), (19i10), (2i9,19a9): integers, then reals or texts.
struct RowFormat {
    std::size_t integers = 0;
    std::size_t id_width = 0;       ///< Of the first column,
    std::size_t integer_width = 0;  ///< of the others.
    std::size_t integers_end = 0;   ///< Where the integers' columns end.
    std::size_t others = 0;         ///< Reals or texts.
    std::size_t other_width = 0;
    std::size_t decimals = 0;
};
/// Empty when the line is no such format.
std::optional<RowFormat> parse_format(std::string_view line);

/// "-1.2345678901234E+000", right-aligned behind blanks: Decimals digits behind the point, an exponent of two
/// or three. False: something else; then the caller takes the general way. Fourteen digits are exact in a
/// double, so digits x 10^e is one rounded operation while |e| <= 22 (Clinger).
template <std::size_t Decimals>
inline bool fast_real_of(const char* at, std::size_t width, double& out) {
    static_assert(Decimals == 13 || Decimals == 9);
    constexpr bool kWide = Decimals == 13;
    constexpr std::size_t kMantissa = Decimals + 3;  // Sign, digit, point, decimals.
    if (width < kMantissa + 4) return false;
    const bool three = at[width - 5] == 'E';
    const std::size_t mark = width - (three ? 5 : 4);
    if (mark < kMantissa) return false;

    const char* start = at + mark - kMantissa;
    // Counted, not tested one by one: a branch each would cost more than the number itself.
    unsigned odd = at[mark] != 'E';
    for (const char* blank = at; blank != start; ++blank) odd += *blank != ' ';
    std::uint64_t head = 0;
    if constexpr (kWide) {  // s d . d d d d d  ->  0 0 d d d d d d
        const std::uint64_t word = load8(start);
        head = (word & 0xFFFFFFFFFF000000) | ((word & 0xFF00) << 8) | 0x3030;
    } else {  // s d . d  ->  0 0 0 0 0 0 d d
        head = (std::uint64_t{static_cast<unsigned char>(start[3])} << 56) |
               (std::uint64_t{static_cast<unsigned char>(start[1])} << 48) | 0x303030303030;
    }
    const std::uint64_t tail = load8(at + mark - 8);
    const bool negative = *start == '-';
    const bool shrinks = at[mark + 1] == '-';
    const auto hundreds = three ? static_cast<unsigned>(at[mark + 2] - '0') : 0U;
    const auto tens = static_cast<unsigned>(at[width - 2] - '0');
    const auto units = static_cast<unsigned>(at[width - 1] - '0');
    odd += *start != (negative ? '-' : ' ');
    odd += start[2] != '.';
    odd += !is_eight_digits(head);
    odd += !is_eight_digits(tail);
    odd += at[mark + 1] != (shrinks ? '-' : '+');
    odd += hundreds > 9;
    odd += tens > 9;
    odd += units > 9;
    const int written = static_cast<int>(hundreds * 100 + tens * 10 + units);
    const int exponent = (shrinks ? -written : written) - static_cast<int>(Decimals);
    if (odd != 0 || exponent < -22 || exponent > 22) return false;
    const auto digits = static_cast<double>(
        value_of_eight_digits(head) * std::int64_t{100'000'000} + value_of_eight_digits(tail)
    );
    // Nearly always the first: a branch is cheaper than a second operation.
    const double value = exponent <= 0 ? digits / kPowersOfTen[static_cast<std::size_t>(-exponent)]
                                       : digits * kPowersOfTen[static_cast<std::size_t>(exponent)];
    out = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) | (std::uint64_t{negative} << 63));
    return true;
}

inline bool fast_real(const char* at, std::size_t width, std::size_t decimals, double& out) {
    if (decimals == 13) return fast_real_of<13>(at, width, out);
    return decimals == 9 && fast_real_of<9>(at, width, out);
}

/// Whether all of these bytes are blanks, digits or signs, or at least no line ends among them.
inline bool stays_in_line(const char* at, std::size_t count) {
    constexpr std::uint64_t kPrintable =
        0x2020202020202020;  // Set in blanks, digits and signs alone of those.
    std::size_t i = 0;
    std::uint64_t common = kPrintable;
    for (; i + 8 <= count; i += 8) common &= load8(at + i);
    for (; i < count; ++i) common &= at[i] & 0x20 ? kPrintable : 0;
    return common == kPrintable;
}

}  // namespace feelem::ansys::cdb
