// SPDX-License-Identifier: Apache-2.0
// The projection of an eye whose field of view need not be symmetric.
#include "viewer/core/space.hpp"

#include <cmath>

namespace feelem::viewer {

glm::mat4 projection_of(const FieldOfView& field, float near, float far) {
    const float left = std::tan(field.left), right = std::tan(field.right);
    const float down = std::tan(field.down), up = std::tan(field.up);
    glm::mat4 matrix(0.0F);
    matrix[0][0] = 2 / (right - left);
    matrix[1][1] = 2 / (up - down);
    matrix[2][0] = (right + left) / (right - left);
    matrix[2][1] = (up + down) / (up - down);
    matrix[2][2] = -(far + near) / (far - near);
    matrix[2][3] = -1;
    matrix[3][2] = -2 * far * near / (far - near);
    return matrix;
}

}  // namespace feelem::viewer
