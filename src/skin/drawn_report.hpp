// SPDX-License-Identifier: Apache-2.0
// What the report says of the drawn skin.
#pragma once

#include "skin/draw_facets.hpp"
#include "skin/edge_table.hpp"

#include "feelem/mesh.hpp"
#include "feelem/surface.hpp"

namespace feelem {

/// Fills vertices, triangles, closed, area and volume of the surface's report.
void report_drawn(const Mesh& mesh, const FacetsToDraw& drawn, const EdgeTable& edges, Surface& surface);

}  // namespace feelem
