// SPDX-License-Identifier: Apache-2.0
// CalculiX' printed tables (.dat): values of *NODE PRINT and *EL PRINT for a mesh that another input brings.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat calculix_dat_format();

}  // namespace feelem
