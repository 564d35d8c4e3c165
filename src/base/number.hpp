// SPDX-License-Identifier: Apache-2.0
// Numbers out of text as solvers print them, never by locale, each rounded once.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace feelem {

/// The text without blanks (space, tab, CR, NUL) at both ends.
std::string_view trim(std::string_view text);

/// A whole field as an integer; empty when it is anything else. A leading + is allowed.
std::optional<std::int64_t> parse_integer(std::string_view field);

/// A whole field as a real: 1.5 +1.5 1. .5 1E3 1.5D+02 1.5-101 (Fortran's exponent without a letter).
/// NaN, Inf and Infinity in any case give NaN; *** (overflow of the column) gives NaN.
/// Beyond the range of T gives infinity, which callers count as non-finite. Empty when it is anything else.
std::optional<float> parse_float(std::string_view field);
std::optional<double> parse_double(std::string_view field);

}  // namespace feelem
