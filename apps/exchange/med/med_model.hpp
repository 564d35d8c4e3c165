// SPDX-License-Identifier: Apache-2.0
// The helper's two answers for MED files. Throw std::exception with words for the user.
#pragma once

#include "read/exchange/neutral_form.hpp"

#include <string>
#include <vector>

namespace feelem::exchange {

std::string list_med(const std::string& path);
/// The values of results of that list, in the order asked for.
std::string load_med(const std::string& path, const std::vector<NeutralResult>& results);

}  // namespace feelem::exchange
