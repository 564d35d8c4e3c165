// SPDX-License-Identifier: Apache-2.0
// Mesh -> Surface, and results onto it.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/surface.hpp"

#include <vector>

namespace feelem {

enum class SkinMethod : std::uint8_t {
    Exact,     ///< Facets owned by one solid only (decision 0007).
    NodeList,  ///< The paper's node map.
    All,       ///< Every facet of every element.
};

struct SkinOptions {
    SkinMethod method = SkinMethod::Exact;
    Domain domain = Domain::Node;
    std::vector<NodeId> surface_nodes;  ///< NodeList: the second list; nodes not in it are inner.
    double crease_angle = 30;           ///< Degrees: vertices split where facets meet at more.
    unsigned subdivide = 1;  ///< Edges of quadratic facets are cut into 2^N pieces (0 = corners only).
};

/// Throws Error(NoElements) when nothing can be drawn.
Surface make_skin(const Mesh& mesh, const SkinOptions& options, Diagnostics& diagnostics);

/// The same surface, triangles and vertices of each part in another order: nearby ones follow each other,
/// which packs and draws better.
void order_for_drawing(Surface& surface);

/// Bit for bit for vertices with a node; blended vertices by their weights; mid-side gaps of corner-only
/// results filled and marked (decision 0010). Elemental and element-nodal results need Domain::ElementNode.
SurfaceField carry(const Mesh& mesh, const Surface& surface, const Result& result);

/// The paper's Fig. 4: bit i (lowest first) is 1 when node i of the element is not in the surface list.
/// Elements with more than 64 nodes do not exist.
std::uint64_t node_map_bits(std::span<const NodeIndex> nodes, const std::vector<bool>& is_surface_node);

}  // namespace feelem
