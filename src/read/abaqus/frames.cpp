// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/frames.hpp"

#include <cmath>
#include <numbers>

namespace feelem::abaqus {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Point3 minus(const Point3& a, const Point3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Point3& a, const Point3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point3 cross(const Point3& a, const Point3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Of length 1; empty when it has no length worth a direction beside `scale`.
std::optional<Point3> unit(const Point3& a, double scale) {
    const double length = std::sqrt(dot(a, a));
    if (!(length > 1e-12 * scale) || !std::isfinite(length)) return {};
    return Point3{a[0] / length, a[1] / length, a[2] / length};
}
double size_of(const Point3& a) {
    return std::sqrt(dot(a, a));
}
Axes from_columns(const Point3& x, const Point3& y, const Point3& z) {
    return {{{x[0], y[0], z[0]}, {x[1], y[1], z[1]}, {x[2], y[2], z[2]}}};
}
Point3 turned(const Axes& axes, const Point3& p) {
    return {dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)};
}
/// Cosines and sines of the angles that people write are exact.
double cosine(double degrees) {
    const double turn = std::fmod(std::abs(degrees), 360);
    if (turn == 90 || turn == 270) return 0;
    return std::cos(turn * kDegree);
}
double sine(double degrees) {
    const double turn = std::fmod(degrees, 360);
    if (turn == 180 || turn == -180) return 0;
    return std::sin(turn * kDegree);
}

/// X along x, Y in the plane of x and y.
std::optional<Axes> axes_of_plane(const Point3& x, const Point3& y) {
    const auto first = unit(x, 0);
    if (!first) return {};
    const auto third = unit(cross(*first, y), size_of(y));
    if (!third) return {};
    return from_columns(*first, cross(*third, *first), *third);
}

}  // namespace

Point3 placed(const Placement& placement, const Point3& point) {
    if (!placement.moves) return point;
    const Point3 p = turned(placement.axes, point);
    return {p[0] + placement.origin[0], p[1] + placement.origin[1], p[2] + placement.origin[2]};
}

Axes times(const Axes& a, const Axes& b) {
    Axes out{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) out[i][j] += a[i][k] * b[k][j];
        }
    }
    return out;
}

Placement combined(const Placement& outer, const Placement& inner) {
    if (!outer.moves) return inner;
    return {times(outer.axes, inner.axes), placed(outer, inner.origin), true};
}

Placement translation(const Point3& by) {
    Placement out;
    out.origin = by;
    out.moves = by != Point3{};
    return out;
}

Placement rotation(const Point3& a, const Point3& b, double degrees) {
    const auto axis = unit(minus(b, a), 0);
    if (!axis || degrees == 0) return {};
    const Point3& n = *axis;
    const double c = cosine(degrees), s = sine(degrees), t = 1 - c;
    Placement out;
    out.axes = {
        {{t * n[0] * n[0] + c, t * n[0] * n[1] - s * n[2], t * n[0] * n[2] + s * n[1]},
         {t * n[0] * n[1] + s * n[2], t * n[1] * n[1] + c, t * n[1] * n[2] - s * n[0]},
         {t * n[0] * n[2] - s * n[1], t * n[1] * n[2] + s * n[0], t * n[2] * n[2] + c}}};
    out.origin = minus(a, turned(out.axes, a));
    out.moves = true;
    return out;
}

Placement system_placement(
    const Point3& origin, const std::optional<Point3>& on_x, const std::optional<Point3>& in_plane
) {
    Placement out = translation(origin);
    if (!on_x) return out;
    Point3 x = minus(*on_x, origin);
    // Without a third point Z stays, and X lies where its projection on the X-Y plane does.
    if (!in_plane) x[2] = 0;
    const Point3 y = in_plane ? minus(*in_plane, origin) : cross({0, 0, 1}, x);
    if (const auto axes = axes_of_plane(x, y)) {
        out.axes = *axes;
        out.moves = true;
    }
    return out;
}

Point3 cartesian(SystemKind kind, const Point3& q) {
    switch (kind) {
    case SystemKind::Cylindrical: return {q[0] * cosine(q[1]), q[0] * sine(q[1]), q[2]};
    case SystemKind::Spherical:
        return {q[0] * cosine(q[1]) * cosine(q[2]), q[0] * sine(q[1]) * cosine(q[2]), q[0] * sine(q[2])};
    case SystemKind::Rectangular: break;
    }
    return q;
}

std::optional<Axes> axes_at(const LocalSystem& system, const Point3& point) {
    if (system.kind == SystemKind::Rectangular) return axes_of_plane(system.a, system.b);
    const Point3 from_a = minus(point, system.a);
    const auto polar = unit(minus(system.b, system.a), 0);
    if (!polar) return {};
    const double along = dot(from_a, *polar);
    const Point3 across{
        from_a[0] - along * (*polar)[0], from_a[1] - along * (*polar)[1], from_a[2] - along * (*polar)[2]};
    const auto radial = unit(across, size_of(from_a));
    if (!radial) return {};
    const Point3 round = cross(*polar, *radial);
    if (system.kind == SystemKind::Cylindrical) return from_columns(*radial, round, *polar);
    // Spherical: outward, round the polar axis, along the meridian.
    const auto outward = unit(from_a, 0);
    return from_columns(*outward, round, cross(*outward, round));
}

}  // namespace feelem::abaqus
