// SPDX-License-Identifier: Apache-2.0
// What VTK's filter gives, of the facets that we found: points used, with their value and node, and
// triangles.
#pragma once

#include "base/huge_pages.hpp"
#include "skin/outline.hpp"

#include "feelem/mesh.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace bench {

struct CompactSkin {
    /// Room for so many; what is not used is never touched.
    CompactSkin(std::size_t most_points, std::size_t most_triangles)
        : points(most_points), values(most_points), nodes(most_points), triangles(most_triangles),
          facets(most_triangles) {}

    std::size_t point_count = 0, triangle_count = 0;
    feelem::ZeroedArray<std::array<float, 3>> points;
    feelem::ZeroedArray<float> values;
    feelem::ZeroedArray<feelem::NodeIndex> nodes;  ///< Per point, ascending.
    feelem::ZeroedArray<std::array<std::uint32_t, 3>>
        triangles;                              ///< Into points, through middles where there are some.
    feelem::ZeroedArray<std::uint32_t> facets;  ///< Per triangle: into the facets.
};

/// `values`: one per node of the mesh.
CompactSkin compact(
    const feelem::Mesh& mesh, std::span<const feelem::FacetRef> facets, std::span<const float> values
);

/// Area of the triangles and the volume they enclose.
void measure(const CompactSkin& skin, double& area, double& volume);

}  // namespace bench
