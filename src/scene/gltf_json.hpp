// SPDX-License-Identifier: Apache-2.0
// A glTF document as JSON text.
#pragma once

#include "scene/gltf.hpp"

#include <string>
#include <string_view>

namespace feelem::gltf {

/// `feelem_extras`: the finished JSON of extras.feelem.
std::string to_json(const Document& document, std::string_view feelem_extras);

}  // namespace feelem::gltf
