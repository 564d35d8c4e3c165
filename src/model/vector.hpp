// SPDX-License-Identifier: Apache-2.0
// The few operations on places and directions that every stage needs.
#pragma once

#include "feelem/mesh.hpp"

#include <cmath>
#include <optional>

namespace feelem {

inline Point3 minus(const Point3& a, const Point3& b) noexcept {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const Point3& a, const Point3& b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point3 cross(const Point3& a, const Point3& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point3& a) noexcept {
    return std::sqrt(dot(a, a));
}
/// Of length 1; empty when `a` is too short beside `scale` to have a direction.
inline std::optional<Point3> direction(const Point3& a, double scale = 0) noexcept {
    const double size = length(a);
    if (!(size > 1e-12 * scale) || !std::isfinite(size)) return {};
    return Point3{a[0] / size, a[1] / size, a[2] / size};
}

}  // namespace feelem
