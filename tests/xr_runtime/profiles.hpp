// SPDX-License-Identifier: Apache-2.0
// Which inputs and outputs the specification gives each controller.
#pragma once

#include <string>

namespace feelem::xr_runtime {

bool is_profile(const std::string& profile);
/// Whether the profile has that path, such as /user/hand/left/input/trigger/value. The last part may be left
/// out.
bool has_path(const std::string& profile, const std::string& path);

}  // namespace feelem::xr_runtime
