// SPDX-License-Identifier: Apache-2.0
// Rows of equal columns with a right-aligned whole number each, several at a time where the processor can.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace feelem {

/// `count` columns of 8 to 16 characters from `at` on: blanks, then one to eight digits up to the last.
/// False: something else stands in one of them, and `out` holds nothing. Reads no byte outside the columns.
bool columns_of_integers(const char* at, std::size_t width, std::size_t count, std::int64_t* out);
bool columns_of_integers(const char* at, std::size_t width, std::size_t count, std::uint32_t* out);

/// The same on any processor.
bool columns_of_integers_portable(const char* at, std::size_t width, std::size_t count, std::int64_t* out);
bool columns_of_integers_portable(const char* at, std::size_t width, std::size_t count, std::uint32_t* out);

/// Three columns of 21 characters as Fortran's E21.13E3 prints reals: -1.2345678901234E+001, exponents from
/// -9 to 13, each rounded once. False: something else stands in one of them.
bool three_reals_of_21(const char* at, double* out);
/// The same without registers of 512 bits.
bool narrow_three_reals_of_21(const char* at, double* out);

/// Columns of 12 to 20 characters, each so far behind `at`, as Fortran's G prints reals: at least one blank
/// or a sign, digits with a point, and then four blanks or an exponent E-02; each rounded once. False:
/// something else stands in one of them, a number cannot be rounded so, there is none, or the processor is
/// another; `out` holds nothing then. Looks at up to kBeforeReals bytes before each column, for nothing.
bool columns_of_reals(const char* at, std::span<const std::uint32_t> offsets, std::size_t width, double* out);
bool columns_of_reals(const char* at, std::span<const std::uint32_t> offsets, std::size_t width, float* out);
inline constexpr std::size_t kBeforeReals = 7;

/// Where a field begins and ends.
struct TextField {
    const char* first = nullptr;
    const char* last = nullptr;
};

/// Three fields of blanks, perhaps a minus, and digits with a point, each rounded once. False: something else
/// stands in one of them, it has more than fifteen characters, or the processor is another. Looks at sixteen
/// bytes before the end of each.
bool three_reals_between(const std::array<TextField, 3>& fields, double* out);

/// Whether the processor has what reading reals here needs; else all that does is always false.
bool has_fast_columns();

}  // namespace feelem
