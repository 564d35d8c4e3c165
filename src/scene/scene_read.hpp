// SPDX-License-Identifier: Apache-2.0
// Parts and fields of a scene, one at a time.
#pragma once

#include "scene/scene_file.hpp"

#include "feelem/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace feelem {

struct FieldAddress {
    std::size_t result = 0, values = 0, part = 0;
};

/// Accessor of an attribute. Throws Error(BadScene) when the primitive has none.
int attribute_of(const SceneFile& file, const gltf::Primitive& primitive, std::string_view semantic);
/// Solver's node id of each vertex of a part's skin or edges; 0: none.
std::vector<std::int64_t> read_node_ids(
    const SceneFile& file, const gltf::Primitive& primitive, std::size_t count
);
/// Throws Error(BadScene) when it cannot be read.
Presentation read_presentation(const SceneFile& file);
std::vector<ScenePart> read_parts(const SceneFile& file);
/// Nothing when the part has no value of that result.
std::optional<SceneField> read_field(
    const SceneFile& file, std::span<const ScenePart> parts, const FieldAddress& address
);

}  // namespace feelem
