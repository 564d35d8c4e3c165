// SPDX-License-Identifier: Apache-2.0
// Nodes, elements and physical groups of a .msh file -> Mesh.
#pragma once

#include "read/gmsh/gmsh_sections.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

namespace feelem::gmsh {

Mesh read_mesh(const Input& input, const Layout& layout, Diagnostics& diagnostics);

}  // namespace feelem::gmsh
