// SPDX-License-Identifier: Apache-2.0
// Nastran's print file (.f06): results in pages for people.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat nastran_f06_format();

}  // namespace feelem
