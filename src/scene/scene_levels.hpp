// SPDX-License-Identifier: Apache-2.0
// Levels of detail in a scene: one list of triangles a part and level over the part's own vertices, and what
// is promised while they are drawn.
#pragma once

#include "scene/json_text.hpp"
#include "scene/scene_build.hpp"
#include "scene/scene_file.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace feelem {

/// "p0/indices/lod1" and so on: arrays that no primitive uses.
void write_level_triangles(SceneBuild& build);
/// extras.feelem.levels; nothing when there are none.
void write_levels(JsonText& json, const SceneBuild& build);
/// certificate.levels: the worst that is shown of any result.
void write_level_claims(JsonText& json, const SceneBuild& build);

/// Triangles of a level, by part. Throws Error(BadScene) when they are not of the part's vertices.
std::vector<std::vector<std::array<std::uint32_t, 3>>> read_level_triangles(
    const SceneFile& file, std::size_t level, std::span<const ScenePart> parts
);

}  // namespace feelem
