// SPDX-License-Identifier: Apache-2.0
// Ansys' text lists (NLIST, ELIST, ETLIST, PRNSOL, PRESOL, PRETAB) and Mechanical's exports: all files of a
// model together.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat ansys_lists_format();

}  // namespace feelem
