// SPDX-License-Identifier: Apache-2.0
// Universal files (.unv, .uff): meshes and results of I-deas, NX, Salome, gmsh and test systems.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat unv_format();

}  // namespace feelem
