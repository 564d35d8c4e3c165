// SPDX-License-Identifier: Apache-2.0
// Ansys' archives of commands: .cdb of CDWRITE, ds.dat of Workbench, .inp of pre-processors.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat ansys_cdb_format();

}  // namespace feelem
