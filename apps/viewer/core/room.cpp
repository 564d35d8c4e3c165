// SPDX-License-Identifier: Apache-2.0
// Where the model stands in the room: on an imagined table before the person.
#include "viewer/core/viewer_state.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

struct Sphere {
    glm::vec3 centre{0};
    float radius = 0;
};

/// Round the undeformed box, in the model's own metres.
Sphere sphere_of(const ViewedModel& model) {
    const ModelArrays& arrays = model.arrays();
    const glm::vec3 low(arrays.low[0], arrays.low[1], arrays.low[2]);
    const glm::vec3 high(arrays.high[0], arrays.high[1], arrays.high[2]);
    const glm::vec3 centre(arrays.to_metres * glm::vec4((low + high) / 2.0F, 1));
    return {centre, glm::length(glm::mat3(arrays.to_metres) * (high - low)) / 2};
}

void put_before(ViewerState& state, const ViewedModel& model, const Stand& stand, float scale) {
    const Sphere sphere = sphere_of(model);
    const float radius = sphere.radius * scale;
    // Larger than the table it starts before the person's toes, not around the head.
    const float ahead = kTableDistance + std::max(0.0F, radius + 0.4F - kTableDistance);
    glm::vec3 at = place_before(stand, 0, kTableHeight, ahead);
    at.y = std::max(at.y, radius * 0.6F);
    glm::mat4 matrix = glm::translate(glm::mat4(1), at);
    matrix = glm::rotate(matrix, stand.yaw, glm::vec3(0, 1, 0));
    matrix = glm::scale(matrix, glm::vec3(scale));
    state.placement = glm::translate(matrix, -sphere.centre);
}

}  // namespace

Stand stand_of(const Pose& head) {
    const glm::vec3 ahead = head.orientation * glm::vec3(0, 0, -1);
    return {head.position, std::atan2(-ahead.x, -ahead.z)};
}

glm::vec3 place_before(const Stand& stand, float right, float height, float ahead) {
    const glm::quat turn = glm::angleAxis(stand.yaw, glm::vec3(0, 1, 0));
    return turn * glm::vec3(right, 0, -ahead) + glm::vec3(stand.position.x, height, stand.position.z);
}

void put_on_table(ViewerState& state, const ViewedModel& model, const Stand& stand) {
    const float unit = glm::length(glm::vec3(model.arrays().to_metres[0]));
    const float metres = static_cast<float>(model.largest_side()) * unit;
    put_before(state, model, stand, kTableSize / std::max(metres, 1e-9F));
}

void put_at_true_size(ViewerState& state, const ViewedModel& model, const Stand& stand) {
    put_before(state, model, stand, 1);
}

glm::mat4 model_to_world(const ViewerState& state, const ViewedModel& model) {
    return state.placement * model.arrays().to_metres;
}

}  // namespace feelem::viewer
