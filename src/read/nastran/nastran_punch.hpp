// SPDX-License-Identifier: Apache-2.0
// Nastran's punch file (.pch): results in columns for other programs.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat nastran_punch_format();

}  // namespace feelem
