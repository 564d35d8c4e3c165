// SPDX-License-Identifier: Apache-2.0
// Where the skin is smooth: which points of which facets share a vertex, and the normals there.
#pragma once

#include "skin/edge_table.hpp"
#include "skin/outline.hpp"
#include "skin/pattern.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace feelem {

/// Corner k (0..3) or middle k - 4 of facet f has the number stride * f + k.
struct SmoothGroups {
    std::uint32_t stride = 8;  ///< 4 where no facet has middles.
    std::vector<std::uint32_t>
        of_point;  ///< Group of each corner and middle; kNoSide where there is no point.
    std::vector<std::array<float, 3>> normals;  ///< Per group: angle-weighted, unit; 0 where it has no area.
};

/// `pieces`: facet ranges [pieces[i], pieces[i + 1]) that share no vertices with each other. Facets join
/// across an edge that two of them use, in opposite directions, when they meet there at no more than
/// `crease_angle`.
SmoothGroups find_smooth_groups(
    std::span<const Outline> facets,
    std::span<const std::uint32_t> pieces,
    const EdgeTable& edges,
    std::span<const Point3> coordinates,
    double crease_angle
);

std::array<float, 3> unit(const Point3& vector) noexcept;

}  // namespace feelem
