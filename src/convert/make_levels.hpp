// SPDX-License-Identifier: Apache-2.0
// Levels of detail of a scene: which ones, for which results, and that they hold what they promise.
#pragma once

#include "convert/scene_values.hpp"
#include "convert/work.hpp"

#include "feelem/scene.hpp"

#include <cstdint>
#include <string_view>

namespace feelem {

/// What --lod asks for.
struct LevelWish {
    enum class Kind : std::uint8_t {
        Off,
        Auto,       ///< Only for skins that are too large for a headset.
        Triangles,  ///< At most so many.
        Bound       ///< As few triangles as this fraction of the results' ranges allows.
    };
    Kind kind = Kind::Auto;
    std::uint64_t triangles = 0;
    double bound = 0;
};

/// "auto", "off", "200000", "0.5%". Throws Error(BadOption).
LevelWish parse_levels(std::string_view text);

/// Fills contents.levels and contents.level_triangles. A level that the independent checker does not confirm
/// at every original vertex is made more carefully, or left out with a note.
/// With a bound among the options, what a level serves is what the scene holds: rounded places and values.
void make_levels(
    const Work& work,
    const Surface& surface,
    SceneValueStore& store,
    const SceneOptions& options,
    SceneContents& contents
);

}  // namespace feelem
