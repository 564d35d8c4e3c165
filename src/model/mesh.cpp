// SPDX-License-Identifier: Apache-2.0
#include "feelem/mesh.hpp"

#include <algorithm>
#include <cassert>

namespace feelem {

std::size_t Mesh::element_count() const noexcept {
    std::size_t count = 0;
    for (const ElementBlock& block : blocks) count += block.ids.size();
    return count;
}

std::span<const NodeIndex> ElementRef::nodes() const {
    const std::size_t count = element_row(block->type).node_count;
    return std::span(block->nodes).subspan(position * count, count);
}

ElementRef element_at(const Mesh& mesh, ElementIndex index) {
    std::size_t position = raw(index);
    for (const ElementBlock& block : mesh.blocks) {
        if (position < block.ids.size()) return {&block, position};
        position -= block.ids.size();
    }
    assert(false && "element index out of range");
    return {};
}

NodeIndex find_node(const Mesh& mesh, NodeId id) {
    const auto found = std::ranges::lower_bound(mesh.node_ids, id);
    if (found == mesh.node_ids.end() || *found != id) return kNoNode;
    return NodeIndex{static_cast<std::uint32_t>(found - mesh.node_ids.begin())};
}

}  // namespace feelem
