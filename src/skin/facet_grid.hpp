// SPDX-License-Identifier: Apache-2.0
// Quadratic facets cut finely along their shape functions.
#pragma once

#include "skin/outline.hpp"
#include "skin/pattern.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace feelem {

/// Each edge cut into `pieces` (a power of two, at least 2); triangles as in the coarse pattern, only
/// smaller.
struct FacetGrid {
    struct Point {
        double u = 0, v = 0;     ///< Triangle: weights of corners 1 and 2. Quad: -1..1 along sides 0 and 1.
        std::uint8_t point = 0;  ///< The facet's point that lies here, or kNoPoint.
    };
    static constexpr std::uint8_t kNoPoint = 255;
    std::vector<Point> points;
    std::vector<std::uint32_t> rank;  ///< Per point: how many without a point of the facet come before it.
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Into points.
    std::array<std::vector<std::uint32_t>, 4> sides;      ///< Points along each side, from corner to corner.
};
FacetGrid grid_of(std::size_t corner_count, unsigned pieces);

/// Weights of the facet's nodes at a place of its grid: 6-node triangle, 8-node quad, or 9-node quad where it
/// has a centre node (Zienkiewicz & Taylor, The Finite Element Method, 8.5 and 8.8). A middle that is left
/// out counts as halfway. In the order of node indices, so that neighbours get the same sum at their edge.
WeightedPoints shape_weights(const Outline& facet, double u, double v) noexcept;

}  // namespace feelem
