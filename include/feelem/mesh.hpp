// SPDX-License-Identifier: Apache-2.0
// The finite-element mesh as flat arrays. Valid by construction: MeshBuilder is the only way to make one.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace feelem {

using Point3 = std::array<double, 3>;
/// Rotation of a nodal coordinate system: degrees about Z, then X', then Y'' (the order of THXY THYZ THZX).
using NodalAngles = std::array<double, 3>;

/// What solver users call a body, component, property or material: decision 9 says which it is per solver.
struct Part {
    std::string name;
};

/// A run of elements of one type. Element i has nodes[i * node_count, (i + 1) * node_count).
/// Mid-side nodes may be kNoNode (left out by the solver); corners never are. Corners may repeat only in
/// shapes that are no standard element (a brick with one collapsed edge): degenerate standard shapes were
/// retyped.
struct ElementBlock {
    ElementType type = ElementType::Point1;
    std::vector<ElementId> ids;
    std::vector<PartIndex> parts;  ///< One per element.
    std::vector<NodeIndex> nodes;
};

/// A named group of nodes or elements (component, NSET, ELSET).
struct NodeSet {
    std::string name;
    std::vector<NodeIndex> nodes;
};
struct ElementSet {
    std::string name;
    std::vector<ElementIndex> elements;
};

/// Length of one unit of the coordinates; no name = unknown, never guessed.
struct LengthUnit {
    std::string name;  ///< m mm cm in ft um
    double metres = 0;
};

struct Mesh {
    std::vector<NodeId> node_ids;      ///< Strictly ascending.
    std::vector<Point3> coordinates;   ///< One per node, in length units; NaN = the file gives none.
    std::vector<ElementBlock> blocks;  ///< At most one of a type, in order of first appearance.
    std::vector<Part> parts;
    std::vector<NodeSet> node_sets;
    std::vector<ElementSet> element_sets;
    /// Rotation of nodal coordinate systems (degrees about Z, X', Y''; docs/formats/); empty when
    /// none.
    std::vector<NodalAngles> node_angles;
    std::map<std::string, std::uint64_t> skipped_elements;  ///< Solver's type name -> rows without a surface.
    std::optional<LengthUnit> length_unit;

    std::size_t node_count() const noexcept { return node_ids.size(); }
    std::size_t element_count() const noexcept;
};

/// An element of a block, resolved from its index over all blocks.
struct ElementRef {
    const ElementBlock* block = nullptr;
    std::size_t position = 0;  ///< Within the block.

    ElementId id() const { return block->ids[position]; }
    PartIndex part() const { return block->parts[position]; }
    std::span<const NodeIndex> nodes() const;
};
ElementRef element_at(const Mesh& mesh, ElementIndex index);

/// Index of a node id, or kNoNode. Binary search; for many look-ups build a NodeLookup
/// (model/node_lookup.hpp).
NodeIndex find_node(const Mesh& mesh, NodeId id);

}  // namespace feelem
