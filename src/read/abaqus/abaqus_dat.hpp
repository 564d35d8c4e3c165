// SPDX-License-Identifier: Apache-2.0
// Abaqus' printed tables (.dat) as a model source.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat abaqus_dat_format();

}  // namespace feelem
