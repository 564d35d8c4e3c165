// SPDX-License-Identifier: Apache-2.0
// How long a netCDF-3 file must be: of one that was cut, the netCDF library gives zeros without a word.
#pragma once

#include <cstdint>
#include <string>

namespace feelem::exchange {

/// Throws std::runtime_error when the file is shorter than its head says. Nothing to say of netCDF-4.
void check_netcdf_size(const std::string& path);

}  // namespace feelem::exchange
