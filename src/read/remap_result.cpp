// SPDX-License-Identifier: Apache-2.0
#include "read/remap_result.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace feelem {
namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

bool has_value(const Result& result, std::size_t row) {
    const std::size_t width = result.component_count();
    const auto values = std::span(result.values).subspan(row * width, width);
    return std::ranges::any_of(values, [](float value) { return !std::isnan(value); });
}

/// One row a node (element) of the mesh shown.
void remap_dense(
    const Result& result,
    std::span<const std::uint32_t> target,
    std::size_t rows,
    Result& out,
    std::uint64_t& left_out
) {
    const std::size_t width = result.component_count();
    out.values.assign(rows * width, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t row = 0; row < std::min(result.row_count(), target.size()); ++row) {
        if (target[row] == kNowhere) {
            if (has_value(result, row)) ++left_out;
            continue;
        }
        std::copy_n(&result.values[row * width], width, &out.values[std::size_t{target[row]} * width]);
    }
}

/// Rows that name their node and owner, in the order that Result asks for.
void remap_rows(const Result& result, const MeshMap& map, Result& out, std::uint64_t& left_out) {
    struct Row {
        std::uint32_t owner, node;
        std::size_t from;
    };
    const bool by_part = result.info.location == Location::PartNodal;
    std::vector<Row> rows;
    for (std::size_t row = 0; row < result.row_count(); ++row) {
        const std::uint32_t owner =
            by_part ? raw(map.parts[result.row_owner[row]]) : raw(map.elements[result.row_owner[row]]);
        const std::uint32_t node = raw(map.nodes[raw(result.row_node[row])]);
        if (owner == kNowhere || node == kNowhere) {
            if (has_value(result, row)) ++left_out;
            continue;
        }
        rows.push_back({owner, node, row});
    }
    std::ranges::sort(rows, [&](const Row& a, const Row& b) {
        // Within an element the file's order stays.
        const auto key = [&](const Row& row) {
            return std::tuple(row.owner, by_part ? row.node : 0, row.from);
        };
        return key(a) < key(b);
    });
    const std::size_t width = result.component_count();
    for (const Row& row : rows) {
        out.row_owner.push_back(row.owner);
        out.row_node.push_back(NodeIndex{row.node});
        const auto from = result.values.begin() + static_cast<std::ptrdiff_t>(row.from * width);
        out.values.insert(out.values.end(), from, from + static_cast<std::ptrdiff_t>(width));
    }
}

template <class Index>
std::vector<std::uint32_t> raw_of(std::span<const Index> indexes) {
    std::vector<std::uint32_t> out(indexes.size());
    std::ranges::transform(indexes, out.begin(), [](Index index) { return raw(index); });
    return out;
}

}  // namespace

Result remap_result(const Result& result, const MeshMap& map, const Mesh& shown, std::uint64_t& left_out) {
    Result out;
    out.info = result.info;
    switch (result.info.location) {
    case Location::Nodal:
        remap_dense(result, raw_of(std::span(map.nodes)), shown.node_count(), out, left_out);
        break;
    case Location::Elemental:
        remap_dense(result, raw_of(std::span(map.elements)), shown.element_count(), out, left_out);
        break;
    case Location::PartNodal:
    case Location::ElementNodal: remap_rows(result, map, out, left_out); break;
    }
    return out;
}

}  // namespace feelem
