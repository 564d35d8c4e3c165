// SPDX-License-Identifier: Apache-2.0
// Bodies for what has none: beams as thin tubes, points as small octahedra.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"
#include "feelem/surface.hpp"

namespace feelem {

/// Appends a part of tubes for each part of the mesh with beams, and, when there is nothing else to draw, one
/// of octahedra for each part with points (beside other elements they are left out and reported). Every
/// vertex carries the node it stands for, so that its values are the node's. Nothing of it counts in the
/// report.
void add_glyphs(const Mesh& mesh, Surface& surface, Diagnostics& diagnostics);

}  // namespace feelem
