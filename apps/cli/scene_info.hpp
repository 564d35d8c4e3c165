// SPDX-License-Identifier: Apache-2.0
// `feelem info SCENE`: what a scene holds, and what its levels of detail promise.
#pragma once

#include <string>

namespace feelem::cli {

void print_scene_info(const std::string& path, bool as_json);

}  // namespace feelem::cli
