// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/frames.hpp"

#include "model/vector.hpp"

namespace feelem::abaqus {
namespace {

/// X along x, Y in the plane of x and y.
std::optional<Matrix3> axes_of_plane(const Point3& x, const Point3& y) {
    const auto first = direction(x, 0);
    if (!first) return {};
    const auto third = direction(cross(*first, y), length(y));
    if (!third) return {};
    return from_columns(*first, cross(*third, *first), *third);
}

}  // namespace

Point3 placed(const Placement& placement, const Point3& point) {
    if (!placement.moves) return point;
    const Point3 p = to_global(placement.axes, point);
    return {p[0] + placement.origin[0], p[1] + placement.origin[1], p[2] + placement.origin[2]};
}

Placement combined(const Placement& outer, const Placement& inner) {
    if (!outer.moves) return inner;
    return {product(outer.axes, inner.axes), placed(outer, inner.origin), true};
}

Placement translation(const Point3& by) {
    Placement out;
    out.origin = by;
    out.moves = by != Point3{};
    return out;
}

Placement rotation(const Point3& a, const Point3& b, double degrees) {
    const auto axis = direction(minus(b, a), 0);
    if (!axis || degrees == 0) return {};
    const Point3& n = *axis;
    const auto [s, c] = sine_and_cosine(degrees);
    const double t = 1 - c;
    Placement out;
    out.axes = {
        {{t * n[0] * n[0] + c, t * n[0] * n[1] - s * n[2], t * n[0] * n[2] + s * n[1]},
         {t * n[0] * n[1] + s * n[2], t * n[1] * n[1] + c, t * n[1] * n[2] - s * n[0]},
         {t * n[0] * n[2] - s * n[1], t * n[1] * n[2] + s * n[0], t * n[2] * n[2] + c}}};
    out.origin = minus(a, to_global(out.axes, a));
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
    if (kind == SystemKind::Rectangular) return q;
    const auto [sine, cosine] = sine_and_cosine(q[1]);
    if (kind == SystemKind::Cylindrical) return {q[0] * cosine, q[0] * sine, q[2]};
    const auto [sine_up, cosine_up] = sine_and_cosine(q[2]);
    return {q[0] * cosine * cosine_up, q[0] * sine * cosine_up, q[0] * sine_up};
}

std::optional<Matrix3> axes_at(const LocalSystem& system, const Point3& point) {
    if (system.kind == SystemKind::Rectangular) return axes_of_plane(system.a, system.b);
    const Point3 from_a = minus(point, system.a);
    const auto polar = direction(minus(system.b, system.a), 0);
    if (!polar) return {};
    const double along = dot(from_a, *polar);
    const Point3 across{
        from_a[0] - along * (*polar)[0], from_a[1] - along * (*polar)[1], from_a[2] - along * (*polar)[2]};
    const auto radial = direction(across, length(from_a));
    if (!radial) return {};
    const Point3 round = cross(*polar, *radial);
    if (system.kind == SystemKind::Cylindrical) return from_columns(*radial, round, *polar);
    // Spherical: outward, round the polar axis, along the meridian.
    const auto outward = direction(from_a, 0);
    return from_columns(*outward, round, cross(*outward, round));
}

}  // namespace feelem::abaqus
