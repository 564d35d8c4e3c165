// SPDX-License-Identifier: Apache-2.0
// Which results a scene has, and which value of the model stands behind each.
#pragma once

#include "feelem/convert.hpp"
#include "feelem/scene.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace feelem {

/// Where one (scene result, step) comes from.
struct PlannedValues {
    std::size_t source_result = 0;  ///< Into ModelSource::results().
    std::size_t step = 0;           ///< Into ScenePlan::steps.
};

struct PlannedResult {
    SceneResult scene;                    ///< Without values' extremes: they are not known yet.
    std::vector<std::string> components;  ///< Of the model's result (stored or derived), one each.
    std::vector<PlannedValues> values;    ///< As scene.values, by step.
};

struct ScenePlan {
    std::vector<Step> steps;
    std::vector<PlannedResult> results;
    Domain domain = Domain::Node;
};

/// Steps of different inputs with equal step, substep, kind and value become one step of the scene when no
/// result is in both: a thermal and a static analysis of one state are shown together. Results are taken as
/// they are listed: a PreparedSource lists them as averaged.
ScenePlan plan_scene(
    const ModelSource& source, std::span<const std::size_t> steps, std::span<const std::size_t> results
);

/// "von Mises stress", "Temperature", "Displacement magnitude": for people.
std::string title_of(std::string_view quantity, std::string_view component);

}  // namespace feelem
