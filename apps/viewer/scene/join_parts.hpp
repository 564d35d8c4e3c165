// SPDX-License-Identifier: Apache-2.0
// The parts of a scene as one set of arrays, with corners that count over all parts.
#pragma once

#include "scene/scene_file.hpp"
#include "viewer/scene/loaded_scene.hpp"

#include <span>

namespace feelem::viewer {

Geometry join_parts(const SceneFile& file, std::span<const ScenePart> parts);
/// Throws Error(BadScene) when a corner is not a vertex of its part.
std::vector<std::array<std::uint32_t, 3>> join_level(
    const SceneFile& file, const Geometry& geometry, std::size_t level
);

}  // namespace feelem::viewer
