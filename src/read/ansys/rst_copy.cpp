// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/rst_copy.hpp"

#include <algorithm>
#include <string>

namespace feelem::rst {

void copy_elements(const Mesh& from, const CopyRules& rules, MeshBuilder& to) {
    std::vector<NodeId> nodes;
    for (const ElementBlock& block : from.blocks) {
        const std::size_t width = element_row(block.type).node_count;
        for (std::size_t i = 0; i < block.ids.size(); ++i) {
            if (!rules.wanted(block.ids[i])) continue;
            nodes.clear();
            for (const NodeIndex node : std::span(block.nodes).subspan(i * width, width))
                nodes.push_back(node == kNoNode ? NodeId{0} : rules.node(node));
            to.add_element(
                ElementId{raw(block.ids[i]) + rules.id_offset},
                block.type,
                nodes,
                to.part(from.parts[raw(block.parts[i])].name),
                [] { return std::string(); }
            );
        }
    }
}

}  // namespace feelem::rst
