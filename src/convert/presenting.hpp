// SPDX-License-Identifier: Apache-2.0
// The presentation of a scene: read or chosen, tied to the scene's results, its ranges resolved.
#pragma once

#include "convert/scene_values.hpp"

#include "feelem/present.hpp"

#include <string>

namespace feelem {

/// What presenting needs to know of a scene that is being made.
struct SceneInMaking {
    const Mesh& mesh;
    const Surface& surface;
    const ScenePlan& plan;
    SceneValueStore& values;
};

/// The step shown first: what the presentation says, else the last one with the most results that is no mode,
/// else the first mode.
std::size_t choose_shown_step(const ScenePlan& plan, const Presentation& presentation);

/// Throws Error(BadPresentation) when a file's presentation asks for what the scene does not have.
Presentation make_presentation(const SceneInMaking& scene, const std::string& file, const std::string& title);

/// The value of nearest rank: the smallest that at least `percent` % of all do not exceed. Sorts; not empty.
float nearest_rank(std::vector<float>& values, double percent);

/// The solver's values at distinct (part, node), or (element, node) where those differ.
std::vector<float> solver_values(const Surface& surface, const SurfaceField& field, std::size_t component);

}  // namespace feelem
