// SPDX-License-Identifier: Apache-2.0
// EnSight's text files against what VTK made of them: of a file that was cut, VTK reads the lines that are
// not there as 0.
#pragma once

#include "vtk/vtk_readers.hpp"

#include <string>
#include <vector>

namespace feelem::exchange {

/// Before VTK, which has waited for ever for a geometry that is not there. Throws std::runtime_error when a
/// file that the case names is missing.
void expect_ensight_files(const std::string& case_path);

/// Throws std::runtime_error when a file that belongs to this time has not as many values as `leaves`.
void check_ensight_files(const std::string& case_path, double time, const std::vector<Leaf>& leaves);

}  // namespace feelem::exchange
