// SPDX-License-Identifier: Apache-2.0
// Two meshes of one model, compared by solver ids: what is the same in both, and what is not.
#pragma once

#include "feelem/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace feelem {

/// Places agree to the five significant digits of an old node list, against the largest coordinate.
inline constexpr double kPlaceTolerance = 6e-5;

/// The same nodes at the same places, the same elements with the same nodes in the same order, all under the
/// same ids. Parts and turned nodal systems need not agree.
bool is_same_mesh(const Mesh& a, const Mesh& b);

/// Things of one kind that do not agree.
struct Disagreement {
    std::uint64_t count = 0;
    std::vector<std::int64_t> first;  ///< Their ids, the first few.

    void add(std::int64_t id);
};

/// From another mesh into the one that is shown.
struct MeshMap {
    std::vector<NodeIndex> nodes;        ///< The node of that id at that place; kNoNode: none.
    std::vector<ElementIndex> elements;  ///< The element of that id on these corners; kNoElement: none.
    std::vector<PartIndex> parts;        ///< The part that holds the same elements; kNoPart: none.

    std::uint64_t same_nodes = 0, same_elements = 0;
    Disagreement nodes_only_other, nodes_only_shown, nodes_moved;
    double farthest = 0;           ///< Of the nodes moved.
    std::int64_t farthest_id = 0;  ///< That node.
    Disagreement elements_only_other, elements_only_shown, elements_of_other_type, elements_on_other_nodes;
    std::string types;            ///< Of the first element of another type: "quad4 here, hex8 there".
    std::uint64_t thickened = 0;  ///< Of other types: shells or beams in one, solids round them in the other.
    bool is_part_for_part = false;  ///< Parts have the same indices and elements in both.
};

inline constexpr PartIndex kNoPart{static_cast<std::uint32_t>(-1)};

MeshMap map_mesh(const Mesh& other, const Mesh& shown);

/// Enough in common to be one model: more than half of the smaller mesh's nodes, or a solver that made solids
/// of shells.
bool is_one_model(const MeshMap& map, const Mesh& other, const Mesh& shown);

}  // namespace feelem
