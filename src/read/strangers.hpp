// SPDX-License-Identifier: Apache-2.0
// Files that Feelem knows but does not read, and what their owner can do.
#pragma once

#include "base/input.hpp"

#include <string_view>

namespace feelem {

/// What a file is and how to make one of it that is read; empty when Feelem does not know it either.
std::string_view advice_for(const Input& input);

}  // namespace feelem
