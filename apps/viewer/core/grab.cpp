// SPDX-License-Identifier: Apache-2.0
#include "viewer/core/grab.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

constexpr glm::vec3 kUpwards(0, 1, 0);

glm::quat turn_between(const glm::vec3& from, const glm::vec3& to, bool upright) {
    if (upright) return glm::angleAxis(std::atan2(to.x, to.z) - std::atan2(from.x, from.z), kUpwards);
    const float lengths = glm::length(from) * glm::length(to);
    if (!(lengths > 0)) return {1, 0, 0, 0};
    const glm::quat turn(lengths + glm::dot(from, to), glm::cross(from, to));
    // Exactly opposite: no axis is better than another, it stays as it is.
    return glm::length(turn) > 1e-6F * lengths ? glm::normalize(turn) : glm::quat(1, 0, 0, 0);
}

}  // namespace

glm::mat4 carry(const glm::mat4& placement, const Pose& from, const Pose& to) {
    return matrix_of(to) * glm::inverse(matrix_of(from)) * placement;
}

glm::mat4 carry_with_two(
    const glm::mat4& placement,
    const std::array<glm::vec3, 2>& from,
    const std::array<glm::vec3, 2>& to,
    bool upright
) {
    const glm::vec3 middle_from = (from[0] + from[1]) / 2.0F, middle_to = (to[0] + to[1]) / 2.0F;
    const glm::vec3 span_from = from[1] - from[0], span_to = to[1] - to[0];
    const float before = glm::length(glm::vec3(placement[0]));
    const float wide = glm::length(span_from);
    const float ratio = wide > 1e-6F ? glm::length(span_to) / wide : 1;
    const float scale = std::clamp(before * ratio, kScaleLimits[0], kScaleLimits[1]) / before;
    glm::mat4 matrix = glm::translate(glm::mat4(1), middle_to);
    matrix *= glm::mat4_cast(turn_between(span_from, span_to, upright));
    matrix = glm::scale(matrix, glm::vec3(scale));
    return glm::translate(matrix, -middle_from) * placement;
}

glm::mat4 turned_about(const glm::mat4& placement, const glm::vec3& head, float degrees) {
    glm::mat4 matrix = glm::translate(glm::mat4(1), head);
    matrix = glm::rotate(matrix, -glm::radians(degrees), kUpwards);
    return glm::translate(matrix, -head) * placement;
}

}  // namespace feelem::viewer
