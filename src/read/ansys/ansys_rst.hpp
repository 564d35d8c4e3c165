// SPDX-License-Identifier: Apache-2.0
// Ansys' binary results: .rst, .rth, .rmg.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat ansys_rst_format();

}  // namespace feelem
