// SPDX-License-Identifier: Apache-2.0
// Coordinate systems of decks: where nodes are, where instances stand, in which directions results point.
#pragma once

#include "model/rotation.hpp"

#include "feelem/mesh.hpp"

#include <cstdint>
#include <optional>

namespace feelem::abaqus {

enum class SystemKind : std::uint8_t {
    Rectangular,
    Cylindrical,  ///< R, angle in degrees, Z.
    Spherical,    ///< R, longitude and latitude in degrees.
};

/// x' = axes x + origin.
struct Placement {
    Matrix3 axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Point3 origin{};
    bool moves = false;
};
Point3 placed(const Placement& placement, const Point3& point);
/// First `inner`, then `outer`.
Placement combined(const Placement& outer, const Placement& inner);
Placement translation(const Point3& by);
/// About the axis from `a` to `b`, by the right hand; nothing where both are one point.
Placement rotation(const Point3& a, const Point3& b, double degrees);

/// *SYSTEM: the origin, a point on the local X axis, a point in the local X-Y plane. Without the third the
/// Z axis stays; without the second the system is moved only.
Placement system_placement(
    const Point3& origin, const std::optional<Point3>& on_x, const std::optional<Point3>& in_plane
);
Point3 cartesian(SystemKind kind, const Point3& coordinates);

/// *TRANSFORM: directions 1 2 3 at a point.
struct LocalSystem {
    SystemKind kind = SystemKind::Rectangular;
    Point3 a{}, b{};
};
/// Their axes as columns; empty where they are not defined (on the axis, or points in one line).
std::optional<Matrix3> axes_at(const LocalSystem& system, const Point3& point);

}  // namespace feelem::abaqus
