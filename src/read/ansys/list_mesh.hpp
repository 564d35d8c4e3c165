// SPDX-License-Identifier: Apache-2.0
// Node lists and element lists -> Mesh.
#pragma once

#include "read/ansys/list_types.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <span>
#include <string>
#include <vector>

namespace feelem::ansys {

/// Nodes collected from the inputs, ascending by id.
struct ListedNodes {
    std::vector<NodeId> ids;
    std::vector<Point3> positions;
    std::vector<NodalAngles> angles;  ///< As long as ids, or empty.
    bool has_angles = false;          ///< A list gave them, be they zero.
    std::string length_unit;          ///< Empty: no input says so.
};

/// All NLIST listings (CoordinateSystem, LowPrecision). Consumes the nodes that were taken.
ListedNodes collect_nodes(std::span<ListFile> files, Diagnostics& diagnostics);

/// Sorts by id and drops equal definitions of a node.
void sort_nodes(ListedNodes& nodes);

/// Adds ids that have no place: coordinates NaN. For results and elements without a node list.
void add_unplaced(ListedNodes& nodes, std::vector<NodeId> ids);

/// Ids of the nodes that elements use.
std::vector<NodeId> nodes_of_elements(std::span<const ListFile> files);

/// The mesh; `parts`: further part names that results need. Consumes the nodes, and the elements that were
/// taken.
Mesh build_mesh(
    std::span<ListFile> files,
    TypeTable types,
    ListedNodes nodes,
    std::span<const std::string> parts,
    Diagnostics& diagnostics
);

}  // namespace feelem::ansys
