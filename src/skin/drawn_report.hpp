// SPDX-License-Identifier: Apache-2.0
// What the report says of the drawn skin.
#pragma once

#include "skin/draw_facets.hpp"
#include "skin/edge_table.hpp"

#include "feelem/mesh.hpp"
#include "feelem/surface.hpp"

namespace feelem {

/// Fills vertices and closed of the report, which the facets tell before they are drawn.
void report_facets(const Mesh& mesh, const FacetsToDraw& drawn, const EdgeTable& edges, SkinReport& report);
/// Fills triangles, area and volume of the surface's report.
void report_triangles(Surface& surface);

}  // namespace feelem
