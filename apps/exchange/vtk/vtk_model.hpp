// SPDX-License-Identifier: Apache-2.0
// The helper's two answers for everything that VTK reads. Throw std::exception with words for the user.
#pragma once

#include "read/exchange/neutral_form.hpp"

#include <string>
#include <vector>

namespace feelem::exchange {

std::string list_vtk(const std::string& format, const std::string& path);
/// The values of results of that list, in the order asked for.
std::string load_vtk(
    const std::string& format, const std::string& path, const std::vector<NeutralResult>& results
);

}  // namespace feelem::exchange
