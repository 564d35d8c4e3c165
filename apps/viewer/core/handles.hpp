// SPDX-License-Identifier: Apache-2.0
// The handles of the model: the bar under it, by which it is carried, and the knobs of the cutting planes.
#pragma once

#include "viewer/core/viewer_state.hpp"

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace feelem::viewer {

/// A ray that passes so near, metres, is on it.
inline constexpr float kBarNear = 0.03F, kKnobNear = 0.035F;

/// Its two ends, world: under the near edge of the box, turned to the eyes.
std::array<glm::vec3, 2> bar_of(const ViewerState& state, const ViewedModel& model, const glm::vec3& eye);
/// Metres along the ray when it is on the bar.
std::optional<float> meet_bar(const Ray& ray, const std::array<glm::vec3, 2>& bar);

/// Of the planes that are on, world; of the others empty.
std::vector<std::optional<glm::vec3>> knobs_of(const ViewerState& state, const ViewedModel& model);
/// How near to a knob takes it, metres: a mouse is finer than a hand.
float knob_reach(const Ray& ray, const glm::vec3& knob, bool is_mouse);
float distance_to_ray(const Ray& ray, const glm::vec3& place);
/// Of the ray's nearest point to the line through the knob along the plane's normal: how far along it, model
/// units.
float along_normal(const Ray& ray, const ViewerState& state, const ViewedModel& model, std::size_t cut);
/// The first plane goes through the hand, square to where it points.
void carry_cut(ViewerState& state, const ViewedModel& model, const Ray& ray);

}  // namespace feelem::viewer
