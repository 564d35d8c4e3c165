// SPDX-License-Identifier: Apache-2.0
// What stock viewers show (colours, the deformed shape, shading), made again from the values of a scene.
#pragma once

#include "scene/scene_file.hpp"

#include "feelem/scene.hpp"

#include <span>
#include <vector>

namespace feelem {

/// Texture coordinates from values and ranges (through normalise(), not through what wrote them), targets
/// from displacement and factor, normals from triangles. Throws Error(BadScene) where arrays do not fit.
std::vector<Claim> check_shown(const SceneFile& file, std::span<const ScenePart> parts);

}  // namespace feelem
