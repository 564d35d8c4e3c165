// SPDX-License-Identifier: Apache-2.0
// Nastran bulk data: .bdf .dat .nas .fem and the pieces they include.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat nastran_bulk_format();

}  // namespace feelem
