// SPDX-License-Identifier: Apache-2.0
// CalculiX results (.frd), text and binary.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat calculix_frd_format();

}  // namespace feelem
