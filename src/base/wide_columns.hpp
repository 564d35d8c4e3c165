// SPDX-License-Identifier: Apache-2.0
// Columns by registers of 512 bits, for base/columns.cpp, which chooses among the ways that there are.
#pragma once

#include <cstddef>
#include <cstdint>

namespace feelem {

/// Whether the processor has them (AVX-512 with byte permutations: since Ice Lake and Zen 4).
bool has_wide_columns();

/// At most kWideColumns columns of 8 to kWidestColumn characters: as columns_of_integers() says. Only where
/// has_wide_columns().
bool wide_columns_of_integers(const char* at, std::size_t width, std::size_t count, std::uint32_t* out);
inline constexpr std::size_t kWideColumns = 8;
inline constexpr std::size_t kWidestColumn = 16;

/// As three_reals_of_21() says. Only where has_wide_columns().
bool wide_three_reals_of_21(const char* at, double* out);

}  // namespace feelem
