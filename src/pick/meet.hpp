// SPDX-License-Identifier: Apache-2.0
// Rays and points against triangles and boxes, in double; and the way through a hierarchy of boxes. What is
// drawn elsewhere than it was built comes in as functions: the box of a node, the corners of a triangle.
#pragma once

#include "feelem/pick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feelem::pick {

/// Distances that differ by less, relatively, are a tie: the smaller triangle index counts.
inline constexpr double kTie = 1e-12;
inline constexpr std::size_t kDeepest = 64;  // The median halves 2^32 triangles 30 times.

using Double3 = std::array<double, 3>;
using Corners3 = std::array<Double3, 3>;

inline Double3 minus(const Double3& a, const Double3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const Double3& a, const Double3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Double3 widened(const Vertex3& v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
inline bool is_finite(const Double3& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/// Keeps the best hit within reach: the nearest, of ties the one with the smaller triangle.
struct Best {
    double reach = std::numeric_limits<double>::infinity();
    std::optional<Hit> hit{};

    double limit() const { return hit ? hit->distance + kTie * (1 + hit->distance) : reach; }
    void offer(const Hit& candidate) {
        if (!hit) {
            if (candidate.distance <= reach) hit = candidate;
            return;
        }
        const double tie = kTie * (1 + hit->distance);
        const bool nearer = candidate.distance < hit->distance - tie;
        const bool tied = candidate.distance <= hit->distance + tie && candidate.triangle < hit->triangle;
        if (nearer || tied) hit = candidate;
    }
};

/// A box in double.
struct Box {
    Double3 low{}, high{};
};
inline Box box_of(const BoxNode& node) {
    return {widened(node.low), widened(node.high)};
}

/// A ray prepared for the test: axes permuted so that it runs mainly along the last, then sheared onto it.
/// The direction is of unit length.
struct PreparedRay {
    Double3 origin, direction;
    std::array<std::size_t, 3> axis{};
    double shear_x = 0, shear_y = 0, scale = 0;

    PreparedRay(const Double3& from, const Double3& towards) : origin(from), direction(towards) {
        std::size_t main = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            if (std::abs(direction[i]) > std::abs(direction[main])) main = i;
        }
        axis = {(main + 1) % 3, (main + 2) % 3, main};
        scale = 1 / direction[main];
        shear_x = direction[axis[0]] * scale;
        shear_y = direction[axis[1]] * scale;
    }

    Double3 sheared(const Double3& point) const {
        const Double3 p = minus(point, origin);
        return {p[axis[0]] - shear_x * p[axis[2]], p[axis[1]] - shear_y * p[axis[2]], scale * p[axis[2]]};
    }

    /// Whether the ray meets the box before `limit`; a little wider than the box, to lose nothing by
    /// rounding.
    bool meets(const Box& box, double limit) const {
        double first = 0;
        double last = limit;
        for (std::size_t i = 0; i < 3; ++i) {
            const double low = box.low[i];
            const double high = box.high[i];
            const double slack = 1e-9 * (std::abs(low) + std::abs(high) + std::abs(origin[i]));
            if (direction[i] == 0) {
                if (origin[i] < low - slack || origin[i] > high + slack) return false;
                continue;
            }
            double near = (low - slack - origin[i]) / direction[i];
            double far = (high + slack - origin[i]) / direction[i];
            if (near > far) std::swap(near, far);
            first = std::max(first, near);
            last = std::min(last, far);
        }
        return first <= last;
    }

    std::optional<Hit> meet(std::uint32_t triangle, const Corners3& corners) const {
        const Double3 p = sheared(corners[0]), q = sheared(corners[1]), r = sheared(corners[2]);
        const double u = r[0] * q[1] - r[1] * q[0];
        const double v = p[0] * r[1] - p[1] * r[0];
        const double w = q[0] * p[1] - q[1] * p[0];
        if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
        const double sum = u + v + w;
        if (sum == 0) return std::nullopt;
        const double distance = (u * p[2] + v * q[2] + w * r[2]) / sum;
        if (!(distance >= 0)) return std::nullopt;
        return Hit{triangle, {u / sum, v / sum, w / sum}, distance};
    }
};

/// Nearest place on a triangle, which may have no area.
Hit nearest_on(std::uint32_t triangle, const Corners3& corners, const Double3& point);
double distance_to(const Box& box, const Double3& point);

/// First hit of a ray before `reach`. `box`: node -> Box, `corners`: triangle -> Corners3.
template <class BoxOf, class CornersOf>
std::optional<Hit> cast_ray(
    const Hierarchy& tree, const PreparedRay& ray, double reach, const BoxOf& box, const CornersOf& corners
) {
    if (tree.nodes.empty()) return std::nullopt;
    Best best{reach};
    std::array<std::uint32_t, kDeepest> stack{};
    std::size_t depth = 1;
    while (depth > 0) {
        const std::uint32_t at = stack[--depth];
        const BoxNode& node = tree.nodes[at];
        if (!ray.meets(box(at), best.limit())) continue;
        if (node.count == 0) {
            stack[depth++] = node.first + 1;
            stack[depth++] = node.first;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const auto hit = ray.meet(tree.order[i], corners(tree.order[i]));
            if (hit) best.offer(*hit);
        }
    }
    return best.hit;
}

/// Nearest place within `reach`; `keep`: whether a candidate counts.
template <class BoxOf, class CornersOf, class Keep>
std::optional<Hit> find_nearest(
    const Hierarchy& tree,
    const Double3& point,
    double reach,
    const BoxOf& box,
    const CornersOf& corners,
    const Keep& keep
) {
    if (tree.nodes.empty()) return std::nullopt;
    Best best{reach};
    std::array<std::uint32_t, kDeepest> stack{};
    std::size_t depth = 1;
    while (depth > 0) {
        const std::uint32_t at = stack[--depth];
        const BoxNode& node = tree.nodes[at];
        if (distance_to(box(at), point) > best.limit()) continue;
        if (node.count == 0) {
            // The nearer child comes first off the stack.
            const bool left_is_nearer =
                distance_to(box(node.first), point) <= distance_to(box(node.first + 1), point);
            stack[depth++] = node.first + (left_is_nearer ? 1 : 0);
            stack[depth++] = node.first + (left_is_nearer ? 0 : 1);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Hit hit = nearest_on(tree.order[i], corners(tree.order[i]), point);
            if (hit.distance <= best.limit() && keep(hit)) best.offer(hit);
        }
    }
    return best.hit;
}

}  // namespace feelem::pick
