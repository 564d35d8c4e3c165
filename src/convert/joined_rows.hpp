// SPDX-License-Identifier: Apache-2.0
// Rows of two results of one kind, side by side: elements may have values at some steps and not at others.
#pragma once

#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace feelem {

inline constexpr std::uint32_t kNoRowThere = static_cast<std::uint32_t>(-1);

struct JoinedRows {
    std::vector<std::uint32_t> owner;   ///< As Result::row_owner.
    std::vector<NodeIndex> node;        ///< As Result::row_node; ascending within an owner.
    std::vector<std::uint32_t> from_a;  ///< The row of the first result; kNoRowThere: it has none.
    std::vector<std::uint32_t> from_b;  ///< Likewise of the second.
};

/// Every element's (part's) node that one of the two has a row for, once; where an owner names a node several
/// times, the first row of one stands beside the first row of the other, and so on.
JoinedRows join_rows(const Result& a, const Result& b);

/// `values` of rows in their new places; NaN where there was none.
std::vector<float> spread_rows(
    const std::vector<float>& values, const std::vector<std::uint32_t>& from, std::size_t width
);

}  // namespace feelem
