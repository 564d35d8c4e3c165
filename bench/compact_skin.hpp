// SPDX-License-Identifier: Apache-2.0
// What VTK's filter gives, of the facets that we found: points used, with their value and node, and
// triangles.
#pragma once

#include "skin/outline.hpp"

#include "feelem/mesh.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace bench {

struct CompactSkin {
    std::vector<std::array<float, 3>> points;
    std::vector<float> values;
    std::vector<feelem::NodeIndex> nodes;  ///< Per point, ascending.
    std::vector<std::array<std::uint32_t, 3>>
        triangles;                      ///< Into points, through middles where there are some.
    std::vector<std::uint32_t> facets;  ///< Per triangle: into the facets.
};

/// `values`: one per node of the mesh.
CompactSkin compact(
    const feelem::Mesh& mesh, std::span<const feelem::FacetRef> facets, std::span<const float> values
);

/// Area of the triangles and the volume they enclose.
void measure(const CompactSkin& skin, double& area, double& volume);

}  // namespace bench
