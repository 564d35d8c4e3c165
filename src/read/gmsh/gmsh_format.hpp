// SPDX-License-Identifier: Apache-2.0
// gmsh's meshes and post-processing views (.msh), versions 2 and 4, text and binary.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat gmsh_msh_format();

}  // namespace feelem
