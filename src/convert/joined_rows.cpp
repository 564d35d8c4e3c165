// SPDX-License-Identifier: Apache-2.0
#include "convert/joined_rows.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace feelem {
namespace {

/// A row by what it is of: the element (part), the node, and how often both stood together before.
struct RowKey {
    std::uint32_t owner = 0;
    NodeIndex node{};
    std::uint32_t nth = 0;
    std::uint32_t row = 0;

    auto place() const { return std::tuple(owner, node, nth); }
};

std::vector<RowKey> keys_of(const Result& result) {
    std::vector<RowKey> keys;
    const std::size_t rows = std::min({result.row_count(), result.row_owner.size(), result.row_node.size()});
    for (std::uint32_t row = 0; row < rows; ++row)
        keys.push_back({result.row_owner[row], result.row_node[row], 0, row});
    std::ranges::stable_sort(keys, [](const RowKey& a, const RowKey& b) { return a.place() < b.place(); });
    for (std::size_t i = 1; i < keys.size(); ++i) {
        if (keys[i].owner == keys[i - 1].owner && keys[i].node == keys[i - 1].node)
            keys[i].nth = keys[i - 1].nth + 1;
    }
    return keys;
}

}  // namespace

JoinedRows join_rows(const Result& a, const Result& b) {
    const std::vector<RowKey> of_a = keys_of(a), of_b = keys_of(b);
    JoinedRows joined;
    std::size_t i = 0, j = 0;
    while (i < of_a.size() || j < of_b.size()) {
        const bool has_a = i < of_a.size() && (j == of_b.size() || of_a[i].place() <= of_b[j].place());
        const bool has_b = j < of_b.size() && (i == of_a.size() || of_b[j].place() <= of_a[i].place());
        const RowKey& key = has_a ? of_a[i] : of_b[j];
        joined.owner.push_back(key.owner);
        joined.node.push_back(key.node);
        joined.from_a.push_back(has_a ? of_a[i].row : kNoRowThere);
        joined.from_b.push_back(has_b ? of_b[j].row : kNoRowThere);
        i += has_a ? 1 : 0;
        j += has_b ? 1 : 0;
    }
    return joined;
}

std::vector<float> spread_rows(
    const std::vector<float>& values, const std::vector<std::uint32_t>& from, std::size_t width
) {
    std::vector<float> out(from.size() * width, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t row = 0; row < from.size(); ++row) {
        if (from[row] == kNoRowThere) continue;
        std::copy_n(
            values.begin() + std::ptrdiff_t(from[row] * width),
            width,
            out.begin() + std::ptrdiff_t(row * width)
        );
    }
    return out;
}

}  // namespace feelem
