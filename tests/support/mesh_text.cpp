// SPDX-License-Identifier: Apache-2.0
#include "support/mesh_text.hpp"

#include "feelem/element_type.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace feelem::test {

std::string mesh_text(const Mesh& mesh) {
    std::string out;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
        out += fmt::format("{}", raw(mesh.node_ids[i]));
        for (const double x : mesh.coordinates[i])
            out += fmt::format(" {:x}", std::bit_cast<std::uint64_t>(x));
        out += '\n';
    }
    for (const ElementBlock& block : mesh.blocks) {
        out += fmt::format("{}:", element_row(block.type).name);
        for (const ElementId id : block.ids) out += fmt::format(" {}", raw(id));
        for (const PartIndex part : block.parts) out += fmt::format(" {}", mesh.parts[raw(part)].name);
        for (const NodeIndex node : block.nodes) out += fmt::format(" {}", raw(node));
        out += '\n';
    }
    for (const NodeSet& set : mesh.node_sets) {
        out += set.name + ':';
        for (const NodeIndex node : set.nodes) out += fmt::format(" {}", raw(node));
        out += '\n';
    }
    for (const ElementSet& set : mesh.element_sets) {
        out += set.name + ':';
        for (const ElementIndex element : set.elements) out += fmt::format(" {}", raw(element));
        out += '\n';
    }
    for (const auto& [name, count] : mesh.skipped_elements) out += fmt::format("{} {}\n", name, count);
    return out;
}

std::string diagnostics_text(const Diagnostics& diagnostics) {
    std::string out;
    for (const Diagnostic& one : diagnostics.entries())
        out += fmt::format("{} {} {} {}\n", code_info(one.code).word, one.where, one.text, one.count);
    return out;
}

}  // namespace feelem::test
