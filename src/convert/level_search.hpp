// SPDX-License-Identifier: Apache-2.0
// The search for levels that hold for every result and step: what is held, what is measured afterwards, and
// what is done when it is too far off.
#pragma once

#include "convert/scene_values.hpp"
#include "convert/work.hpp"

#include "feelem/lod.hpp"
#include "feelem/scene.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace feelem {

/// One result at one step.
struct ServedValues {
    std::size_t result = 0, values = 0;
    double range = 0;  ///< Of the whole result.
    double bound = 0;  ///< Of the whole value, in the result's unit.
    double component_bound = 0;
};

struct LevelSearch {
    const Work& work;
    const LodSurface& surface;
    SceneValueStore& store;
    const std::vector<SceneResult>& results;
    const SceneOptions& scene;
    std::vector<ServedValues> served{};
    std::vector<std::size_t>
        held{};  ///< Of `served`: the simplifier holds these; the others are measured afterwards.
    LodOptions options{};

    std::size_t width(std::size_t i) const { return results[served[i].result].components.size(); }
};

using MadeLevels = std::vector<std::pair<SceneLevel, LodLevel>>;

/// Levels for search.options.targets that are worth having and hold for all that is served. None, with the
/// reason in `why`, when they cannot be had.
MadeLevels search_levels(LevelSearch& search, std::string& why);

}  // namespace feelem
