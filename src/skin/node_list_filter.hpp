// SPDX-License-Identifier: Apache-2.0
// The paper's node map, and every facet: the two methods that are kept for fidelity and as a lesson.
#pragma once

#include "skin/outline.hpp"

#include "feelem/mesh.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace feelem {

struct ListedFacets {
    std::vector<FacetRef> kept;
    std::uint64_t in = 0;
    std::uint64_t skipped = 0;
    std::uint64_t collapsed = 0;
};
/// Facets of solids without an inner corner node (Maleshkov & Chotrov, Fig. 4): a facet whose corners all lie
/// on the surface stays, even when it lies inside. `is_surface_node`: one flag a node.
ListedFacets facets_by_node_map(const Mesh& mesh, const std::vector<bool>& is_surface_node);
ListedFacets every_facet(const Mesh& mesh);

/// One flag a node of the mesh: whether its id is in the list.
std::vector<bool> surface_node_flags(const Mesh& mesh, std::span<const NodeId> surface_nodes);

}  // namespace feelem
