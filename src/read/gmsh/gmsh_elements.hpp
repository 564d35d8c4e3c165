// SPDX-License-Identifier: Apache-2.0
// The rows of $Elements and $Nodes in every version and coding, each read once.
#pragma once

#include "read/gmsh/gmsh_sections.hpp"
#include "read/gmsh/gmsh_types.hpp"

#include "feelem/ids.hpp"
#include "feelem/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace feelem::gmsh {

struct NodeRows {
    std::vector<NodeId> ids;
    std::vector<Point3> places;
};

/// Elements as they come, in runs of one type, physical group and entity.
struct ElementRows {
    struct Run {
        const TypeRow* type = nullptr;
        std::int64_t physical = 0;  ///< Version 2 alone; 4 has it on the entity.
        std::int64_t entity = 0;
        bool is_wide = false;  ///< Its nodes stand in wide_nodes: some are beyond 32 bits.
        std::size_t first = 0, first_node = 0;

        /// Of Feelem's; 0 for types that are not known.
        std::size_t width() const { return type->known ? element_row(type->type).node_count : 0; }
    };
    std::vector<Run> runs;
    std::vector<ElementId> ids;
    std::vector<std::size_t> offsets;  ///< In the file.
    std::vector<std::uint32_t> nodes;  ///< In Feelem's order.
    std::vector<NodeId> wide_nodes;

    std::size_t end_of(std::size_t run) const {
        return run + 1 < runs.size() ? runs[run + 1].first : ids.size();
    }
    std::span<const std::uint32_t> nodes_of(const Run& run, std::size_t first, std::size_t count) const {
        const std::size_t width = run.width();
        return std::span(nodes).subspan(run.first_node + (first - run.first) * width, count * width);
    }
    /// Element i's, whatever they are; until the next call.
    std::span<const NodeId> row(const Run& run, std::size_t i, std::array<NodeId, kMaxElementNodes>& room)
        const;
};

/// The rows of a section behind those that are there. Throw Error on damaged rows.
void read_element_rows(const Input& input, const Coding& coding, const Section& section, ElementRows& rows);
void read_node_rows(const Input& input, const Coding& coding, const Section& section, NodeRows& rows);

}  // namespace feelem::gmsh
