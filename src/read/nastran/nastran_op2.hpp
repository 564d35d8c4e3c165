// SPDX-License-Identifier: Apache-2.0
// Nastran results (.op2), binary.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat nastran_op2_format();

}  // namespace feelem
