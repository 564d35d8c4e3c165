// SPDX-License-Identifier: Apache-2.0
// Hands on the model: one carries it 1:1, two move, turn (about the vertical) and scale it. Maths only.
#pragma once

#include "viewer/core/space.hpp"

#include <array>

namespace feelem::viewer {

/// Smallest and largest scale of the model against its own metres.
inline constexpr std::array<float, 2> kScaleLimits{1e-3F, 1e3F};

/// Placement after a hand that held it at `from` has come to `to`.
glm::mat4 carry(const glm::mat4& placement, const Pose& from, const Pose& to);
/// After two hands have come from one pair of places to another; upright: it turns about the vertical alone.
glm::mat4 carry_with_two(
    const glm::mat4& placement,
    const std::array<glm::vec3, 2>& from,
    const std::array<glm::vec3, 2>& to,
    bool upright
);
/// Degrees to the left that the person turns about their head: the room turns the other way.
glm::mat4 turned_about(const glm::mat4& placement, const glm::vec3& head, float degrees);

}  // namespace feelem::viewer
