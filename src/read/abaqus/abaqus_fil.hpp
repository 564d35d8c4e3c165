// SPDX-License-Identifier: Apache-2.0
// Abaqus' results files (.fil), ASCII and binary.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat abaqus_fil_format();

}  // namespace feelem
