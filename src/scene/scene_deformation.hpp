// SPDX-License-Identifier: Apache-2.0
// The deformed shape: which displacement, how much, and how it moves.
#pragma once

#include "scene/scene_build.hpp"

namespace feelem {

/// From the presentation, when the displacement it names is there; the factor when it leaves it open.
void choose_deformation(SceneBuild& build);
/// Weights of the parts' meshes and one animation for all of them. The parts' nodes must stand.
void write_animation(SceneBuild& build);

}  // namespace feelem
