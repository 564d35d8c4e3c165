// SPDX-License-Identifier: Apache-2.0
// Digits and a power of ten as the nearest double.
#pragma once

#include <cstdint>

namespace feelem {

/// The double nearest to digits x 10^exponent, of up to nineteen digits (below 2^64). False where this takes
/// more care: then parse_double() the text.
bool nearest_double(std::uint64_t digits, int exponent, bool negative, double& out);

}  // namespace feelem
