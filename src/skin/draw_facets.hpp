// SPDX-License-Identifier: Apache-2.0
// Facets into the vertices, triangles, blends and edges of a Surface.
#pragma once

#include "skin/outline.hpp"

#include "feelem/mesh.hpp"
#include "feelem/surface.hpp"

#include <cstdint>
#include <vector>

namespace feelem {

/// The facets to draw, one piece (part of the mesh, kind) after the other.
struct FacetsToDraw {
    struct Piece {
        PartIndex part{};
        PartKind kind = PartKind::Solid;
    };
    std::vector<Piece> pieces;
    std::vector<std::uint32_t> piece_first;  ///< Into facets, one more than there are pieces.
    std::vector<Outline> facets;
    std::vector<ElementIndex> elements;  ///< Per facet; facets of an element are next to each other.
};

struct DrawOptions {
    double crease_angle = 30;  ///< Degrees.
    unsigned pieces = 2;       ///< Of each edge of a facet with middles: a power of two.
};
/// Appends everything to `surface`, and fills vertices, triangles, closed, area and volume of its report.
void draw_facets(const Mesh& mesh, const FacetsToDraw& drawn, const DrawOptions& options, Surface& surface);

}  // namespace feelem
