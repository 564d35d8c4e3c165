// SPDX-License-Identifier: Apache-2.0
// Area and volume of float32 triangles in double, the same way for writing and checking.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace feelem {

using Corners = std::array<std::array<float, 3>, 3>;

inline std::array<double, 3> triangle_normal(const Corners& c) {
    std::array<double, 3> a{}, b{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        a[axis] = static_cast<double>(c[1][axis]) - static_cast<double>(c[0][axis]);
        b[axis] = static_cast<double>(c[2][axis]) - static_cast<double>(c[0][axis]);
    }
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double triangle_area(const Corners& corners) {
    const std::array<double, 3> n = triangle_normal(corners);
    return 0.5 * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

/// Signed volume between the triangle and the origin.
inline double triangle_volume(const Corners& corners) {
    const std::array<double, 3> n = triangle_normal(corners);
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += n[axis] * static_cast<double>(corners[0][axis]);
    return sum / 6;
}

}  // namespace feelem
