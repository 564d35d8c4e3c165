// SPDX-License-Identifier: Apache-2.0
// extras.feelem: what a scene says of itself, and its certificate.
#pragma once

#include "scene/scene_build.hpp"

#include <string>

namespace feelem {

std::string extras_text(const SceneBuild& build);
std::string certificate_text(const SceneBuild& build);

/// Words of docs/scene-format.md where they differ from docs/cli.md's.
std::string_view scene_location(Location location);
std::string_view scene_kind(PartKind kind);
std::string_view scale_word(Scale scale);

}  // namespace feelem
