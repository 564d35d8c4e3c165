// SPDX-License-Identifier: Apache-2.0
// The blocks of solids of a mesh, and their elements in runs that are hashed together.
#pragma once

#include "model/element_table.hpp"
#include "skin/facet_batch.hpp"

#include "feelem/mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace feelem {

/// A block of solids and where its elements start in the mesh.
struct SolidBlock {
    const ElementBlock* block = nullptr;
    const ElementRow* row = nullptr;
    std::uint8_t index = 0;
    std::size_t first_element = 0;

    std::span<const NodeIndex> nodes(std::size_t position) const {
        return std::span(block->nodes).subspan(position * row->node_count, row->node_count);
    }
};

inline std::vector<SolidBlock> solid_blocks(const Mesh& mesh) {
    std::vector<SolidBlock> out;
    std::size_t first = 0;
    for (std::size_t i = 0; i < mesh.blocks.size(); ++i) {
        const ElementRow& row = element_row(mesh.blocks[i].type);
        if (row.dimension == 3) out.push_back({&mesh.blocks[i], &row, static_cast<std::uint8_t>(i), first});
        first += mesh.blocks[i].ids.size();
    }
    return out;
}

inline bool is_set_aside(const std::vector<bool>& set_aside, const SolidBlock& solids, std::size_t position) {
    return !set_aside.empty() && set_aside[solids.first_element + position];
}

/// Calls visit(run, position of its first element) for elements [first, last) that are not set aside.
template <class Visit>
void for_each_run(
    const SolidBlock& solids,
    const std::vector<bool>& set_aside,
    std::array<std::size_t, 2> range,
    Visit visit
) {
    for (std::size_t i = range[0]; i < range[1];) {
        std::size_t end = std::min(range[1], i + FacetBatch::kElements);
        if (!set_aside.empty()) {
            const std::size_t last = end;
            end = i;
            while (end < last && !is_set_aside(set_aside, solids, end)) ++end;
        }
        if (end > i) visit(ElementRun{solids.block->type, solids.nodes(i).data(), end - i}, i);
        i = end > i ? end : end + 1;
    }
}

}  // namespace feelem
