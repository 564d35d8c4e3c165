// SPDX-License-Identifier: Apache-2.0
// Exodus and CGNS have scalars alone: of tensors, VTK leaves six of them.
#pragma once

#include "vtk/vtk_readers.hpp"

#include <vector>

namespace feelem::exchange {

/// Where a leaf has stress_xx stress_yy stress_zz stress_xy stress_yz and stress_zx (or stress_xz), in any
/// letter case and with or without the line, they become one array "stress" of six.
void join_tensors(std::vector<Leaf>& leaves);

}  // namespace feelem::exchange
