// SPDX-License-Identifier: Apache-2.0
// Places and views. Metres, right-handed, +Y up, -Z ahead: OpenXR's, also where no headset is there.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace feelem::viewer {

struct Pose {
    glm::vec3 position{0};
    glm::quat orientation{1, 0, 0, 0};  ///< Unit; w, x, y, z.
};

/// Angles from the axis of view, radians: left and down are negative.
struct FieldOfView {
    float left = 0, right = 0, up = 0, down = 0;
};

struct EyeView {
    Pose pose;
    FieldOfView field;
};

struct Ray {
    glm::vec3 origin{0};
    glm::vec3 direction{0, 0, -1};  ///< Unit.
};

inline Ray ray_of(const Pose& pose) {
    return {pose.position, pose.orientation * glm::vec3(0, 0, -1)};
}

/// Pose -> matrix from its own axes to the world's.
inline glm::mat4 matrix_of(const Pose& pose) {
    glm::mat4 matrix = glm::mat4_cast(pose.orientation);
    matrix[3] = glm::vec4(pose.position, 1.0F);
    return matrix;
}

/// Of OpenGL's clip space; `near` and `far` in metres.
glm::mat4 projection_of(const FieldOfView& field, float near, float far);

}  // namespace feelem::viewer
