// SPDX-License-Identifier: Apache-2.0
// Axes of a nodal coordinate system as the three angles that Mesh::node_angles holds.
#pragma once

#include "feelem/mesh.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace feelem {

/// Angles about Z, X', Y'' in degrees of a rotation matrix whose columns are the axes. Not unique where Y is
/// along the global Z: then the third angle is 0.
inline NodalAngles nodal_angles_of(const std::array<std::array<double, 3>, 3>& axes) {
    // Z(a) X(b) Y(c): the middle column is (-sin a cos b, cos a cos b, sin b), the last row
    // (-cos b sin c, sin b, cos b cos c).
    const double cosine_b = std::hypot(axes[2][0], axes[2][2]);
    const double a =
        cosine_b > 1e-9 ? std::atan2(-axes[0][1], axes[1][1]) : std::atan2(axes[1][0], axes[0][0]);
    const double b = std::atan2(axes[2][1], cosine_b);
    const double c = cosine_b > 1e-9 ? std::atan2(-axes[2][0], axes[2][2]) : 0.0;
    constexpr double kDegrees = 180 / std::numbers::pi;
    // + 0: an angle of -0 is 0.
    return {a * kDegrees + 0.0, b * kDegrees + 0.0, c * kDegrees + 0.0};
}

}  // namespace feelem
