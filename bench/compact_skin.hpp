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
    CompactSkin(std::size_t point_count, std::size_t triangle_count)
        : points(point_count), values(point_count), nodes(point_count), triangles(triangle_count),
          facets(triangle_count) {}

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
