// SPDX-License-Identifier: Apache-2.0
// The skin as triangles, with maps back to nodes and elements; and results carried onto it.
#pragma once

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace feelem {

enum class PartKind : std::uint8_t {
    Solid,
    Shell,
    Beam,
    Point
};

/// Whether vertices are shared by the elements of a part or belong to one element each.
enum class Domain : std::uint8_t {
    Node,
    ElementNode
};

/// A run of vertices, triangles and edges that belong to one part of the mesh and are of one kind.
struct SurfacePart {
    PartIndex part{};
    PartKind kind = PartKind::Solid;
    std::uint32_t first_vertex = 0, vertex_count = 0;
    std::uint32_t first_triangle = 0, triangle_count = 0;
    std::uint32_t first_edge = 0, edge_count = 0;  ///< Line segments between vertices of this part.
};

/// A vertex that no node stands behind (centre of a quad, left-out mid-side node): position and values are
/// the weighted sum of other vertices of its part, summed in double in this order and rounded once.
struct Blend {
    VertexIndex vertex{};
    std::uint32_t first = 0;  ///< Into Surface::blend_sources / blend_weights.
    std::uint32_t count = 0;
};

/// Facets in, kept and dropped, and why: what the certificate says of the skin.
struct SkinReport {
    std::uint64_t solid_facets_in = 0;
    std::uint64_t solid_facets_kept = 0;
    std::uint64_t solid_tri_kept = 0, solid_quad_kept = 0;
    std::uint64_t shell_tri = 0, shell_quad = 0;
    std::uint64_t facets_inner = 0;          ///< Dropped: shared by two elements.
    std::uint64_t facets_many_owners = 0;    ///< Dropped and reported.
    std::uint64_t facets_collapsed = 0;      ///< Fewer than three different corners.
    std::uint64_t facets_of_duplicates = 0;  ///< Of elements set aside as duplicates.
    std::uint64_t unmatched_facets = 0;      ///< Kept and reported.
    std::uint64_t duplicate_elements = 0, inverted_elements = 0;
    std::uint64_t vertices = 0;   ///< Distinct (part, node) on triangles, before crease splits.
    std::uint64_t triangles = 0;  ///< Of solids and shells.
    bool has_solids = false;
    bool closed = false;  ///< Every edge of the solid skin is used equally often both ways.
    double area = 0;      ///< Of all triangles, length units squared.
    double volume = 0;    ///< Enclosed by the solid skin, by the divergence theorem.
};

struct Surface {
    Domain domain = Domain::Node;
    std::vector<SurfacePart> parts;
    std::vector<Point3> positions;  ///< Per vertex, length units.
    std::vector<std::array<float, 3>>
        normals;                               ///< Unit, outward on solids; zero only for a degenerate facet.
    std::vector<NodeIndex> vertex_node;        ///< kNoNode for blended vertices.
    std::vector<ElementIndex> vertex_element;  ///< Domain::ElementNode only, else empty.
    std::vector<std::array<VertexIndex, 3>> triangles;
    std::vector<ElementIndex> triangle_element;
    std::vector<std::array<VertexIndex, 2>> edges;  ///< True element edges, bent through mid-side nodes.
    std::vector<Blend> blends;  ///< In vertex order; sources always have a node themselves.
    std::vector<VertexIndex> blend_sources;
    std::vector<double> blend_weights;
    SkinReport report;
};

/// Mask values of docs/scene-format.md: 0 missing, 1 the solver's, 2 interpolated by us.
enum class Validity : std::uint8_t {
    Missing = 0,
    Solver = 1,
    Interpolated = 2
};

/// A result on the vertices of a Surface.
struct SurfaceField {
    std::uint32_t component_count = 0;
    std::vector<float> values;       ///< vertices x components; NaN = missing.
    std::vector<Validity> validity;  ///< Per vertex.
    std::uint64_t missing = 0;       ///< Vertices with a node but without a value.
    std::uint64_t interpolated =
        0;  ///< Mid-side vertices filled from their corners (blended ones not counted).
};

}  // namespace feelem
