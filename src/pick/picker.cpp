// SPDX-License-Identifier: Apache-2.0
// Must: hit whatever lies on the ray, shared edges and vertices included, and answer the same everywhere.
// Assumes: finite positions. Algorithm: a hierarchy of boxes split at the median of the triangles' centres;
// rays by the watertight test of Woop, Benthin & Wald (JCGT 2013) in double, whose edge functions have the
// same value, with opposite sign, for both triangles at an edge. Data: two numbers a triangle.
#include "feelem/pick.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace feelem {
namespace {

constexpr std::uint32_t kLeaf = 4;
constexpr std::size_t kDeepest = 64;  // The median halves 2^32 triangles 30 times.
/// Distances that differ by less, relatively, are a tie: the smaller triangle index counts.
constexpr double kTie = 1e-12;

using Double3 = std::array<double, 3>;

Double3 minus(const Double3& a, const Double3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Double3& a, const Double3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Double3 widened(const Vertex3& v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
bool is_finite(const Double3& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/// Keeps the best hit: the nearest, of ties the one with the smaller triangle.
struct Best {
    std::optional<Hit> hit;

    double limit() const {
        return hit ? hit->distance + kTie * (1 + hit->distance) : std::numeric_limits<double>::infinity();
    }
    void offer(const Hit& candidate) {
        if (!hit) {
            hit = candidate;
            return;
        }
        const double tie = kTie * (1 + hit->distance);
        const bool nearer = candidate.distance < hit->distance - tie;
        const bool tied = candidate.distance <= hit->distance + tie && candidate.triangle < hit->triangle;
        if (nearer || tied) hit = candidate;
    }
};

/// A ray prepared for the test: axes permuted so that it runs mainly along the last, then sheared onto it.
struct Ray {
    Double3 origin, direction;
    std::array<std::size_t, 3> axis{};
    double shear_x = 0, shear_y = 0, scale = 0;

    Ray(const Double3& from, const Double3& towards) : origin(from), direction(towards) {
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
    template <class Node>
    bool meets(const Node& box, double limit) const {
        double first = 0;
        double last = limit;
        for (std::size_t i = 0; i < 3; ++i) {
            const double low = static_cast<double>(box.low[i]);
            const double high = static_cast<double>(box.high[i]);
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

    std::optional<Hit> meet(std::uint32_t triangle, const Double3& a, const Double3& b, const Double3& c)
        const {
        const Double3 p = sheared(a), q = sheared(b), r = sheared(c);
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

/// Place on the segment from a to b nearest to p, as the weight of b.
double along(const Double3& a, const Double3& b, const Double3& p) {
    const Double3 side = minus(b, a);
    const double length = dot(side, side);
    return length > 0 ? std::clamp(dot(minus(p, a), side) / length, 0.0, 1.0) : 0.0;
}

double distance_to(const std::array<Double3, 3>& corners, const Double3& weights, const Double3& point) {
    Double3 sum = minus({0, 0, 0}, point);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) sum[k] += weights[i] * corners[i][k];
    }
    return std::sqrt(dot(sum, sum));
}

/// Nearest place on a triangle, which may have no area.
Hit nearest_on(std::uint32_t triangle, const std::array<Double3, 3>& corners, const Double3& point) {
    const Double3 ab = minus(corners[1], corners[0]);
    const Double3 ac = minus(corners[2], corners[0]);
    const Double3 ap = minus(point, corners[0]);
    const double bb = dot(ab, ab), bc = dot(ab, ac), cc = dot(ac, ac);
    const double pb = dot(ap, ab), pc = dot(ap, ac);
    const double area = bb * cc - bc * bc;
    if (area > 0) {
        const double v = (cc * pb - bc * pc) / area;
        const double w = (bb * pc - bc * pb) / area;
        if (v >= 0 && w >= 0 && v + w <= 1) {
            const Double3 weights{1 - v - w, v, w};
            return {triangle, weights, distance_to(corners, weights, point)};
        }
    }
    Hit best{triangle, {}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        Double3 weights{};
        weights[next] = along(corners[i], corners[next], point);
        weights[i] = 1 - weights[next];
        const double distance = distance_to(corners, weights, point);
        if (distance < best.distance) best = {triangle, weights, distance};
    }
    return best;
}

template <class Node>
double distance_to_box(const Node& box, const Double3& point) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double low = static_cast<double>(box.low[i]) - point[i];
        const double high = point[i] - static_cast<double>(box.high[i]);
        const double outside = std::max({low, high, 0.0});
        sum += outside * outside;
    }
    return std::sqrt(sum);
}

}  // namespace

Picker::Picker(std::span<const Vertex3> positions, std::span<const Triangle> triangles)
    : positions_(positions), triangles_(triangles), order_(triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (order_.empty()) return;
    std::vector<Vertex3> centres(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (const std::uint32_t vertex : triangles[i]) {
            assert(vertex < positions.size());
            for (std::size_t k = 0; k < 3; ++k) centres[i][k] += positions[vertex][k] / 3;
        }
    }
    nodes_.push_back({{}, {}, 0, static_cast<std::uint32_t>(order_.size())});
    for (std::size_t at = 0; at < nodes_.size(); ++at) {
        Node node = nodes_[at];
        node.low.fill(std::numeric_limits<float>::infinity());
        node.high.fill(-std::numeric_limits<float>::infinity());
        Node inside = node;  // box of the centres
        const auto begin = order_.begin() + node.first;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                for (const std::uint32_t vertex : triangles[order_[i]]) {
                    node.low[k] = std::min(node.low[k], positions[vertex][k]);
                    node.high[k] = std::max(node.high[k], positions[vertex][k]);
                }
                inside.low[k] = std::min(inside.low[k], centres[order_[i]][k]);
                inside.high[k] = std::max(inside.high[k], centres[order_[i]][k]);
            }
        }
        if (node.count > kLeaf) {
            std::size_t widest = 0;
            for (std::size_t k = 1; k < 3; ++k) {
                if (inside.high[k] - inside.low[k] > inside.high[widest] - inside.low[widest]) widest = k;
            }
            const std::uint32_t half = node.count / 2;
            std::nth_element(begin, begin + half, begin + node.count, [&](std::uint32_t a, std::uint32_t b) {
                return centres[a][widest] != centres[b][widest] ? centres[a][widest] < centres[b][widest]
                                                                : a < b;
            });
            const auto left = static_cast<std::uint32_t>(nodes_.size());
            nodes_.push_back({{}, {}, node.first, half});
            nodes_.push_back({{}, {}, node.first + half, node.count - half});
            node.first = left;
            node.count = 0;
        }
        nodes_[at] = node;
    }
}

std::optional<Hit> Picker::ray(const Double3& origin, const Double3& direction) const {
    const double length = std::sqrt(dot(direction, direction));
    if (nodes_.empty() || !is_finite(origin) || !(length > 0) || !std::isfinite(length)) return std::nullopt;
    const Ray ray(origin, {direction[0] / length, direction[1] / length, direction[2] / length});
    Best best;
    std::array<std::uint32_t, kDeepest> stack{};
    std::size_t depth = 1;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (!ray.meets(node, best.limit())) continue;
        if (node.count == 0) {
            stack[depth++] = node.first + 1;
            stack[depth++] = node.first;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Triangle& t = triangles_[order_[i]];
            const auto hit = ray.meet(
                order_[i], widened(positions_[t[0]]), widened(positions_[t[1]]), widened(positions_[t[2]])
            );
            if (hit) best.offer(*hit);
        }
    }
    return best.hit;
}

std::optional<Hit> Picker::nearest(const Double3& point) const {
    if (nodes_.empty() || !is_finite(point)) return std::nullopt;
    Best best;
    std::array<std::uint32_t, kDeepest> stack{};
    std::size_t depth = 1;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (distance_to_box(node, point) > best.limit()) continue;
        if (node.count == 0) {
            // The nearer child comes first off the stack.
            const bool left_is_nearer =
                distance_to_box(nodes_[node.first], point) <= distance_to_box(nodes_[node.first + 1], point);
            stack[depth++] = node.first + (left_is_nearer ? 1 : 0);
            stack[depth++] = node.first + (left_is_nearer ? 0 : 1);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Triangle& t = triangles_[order_[i]];
            best.offer(nearest_on(
                order_[i],
                {widened(positions_[t[0]]), widened(positions_[t[1]]), widened(positions_[t[2]])},
                point
            ));
        }
    }
    return best.hit;
}

}  // namespace feelem
