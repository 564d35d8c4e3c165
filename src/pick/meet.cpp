// SPDX-License-Identifier: Apache-2.0
// The place of a triangle, and of a box, nearest to a point.
#include "pick/meet.hpp"

namespace feelem::pick {
namespace {

/// Place on the segment from a to b nearest to p, as the weight of b.
double along(const Double3& a, const Double3& b, const Double3& p) {
    const Double3 side = minus(b, a);
    const double length = dot(side, side);
    return length > 0 ? std::clamp(dot(minus(p, a), side) / length, 0.0, 1.0) : 0.0;
}

double distance_at(const Corners3& corners, const Double3& weights, const Double3& point) {
    Double3 sum = minus({0, 0, 0}, point);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) sum[k] += weights[i] * corners[i][k];
    }
    return std::sqrt(dot(sum, sum));
}

}  // namespace

Hit nearest_on(std::uint32_t triangle, const Corners3& corners, const Double3& point) {
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
            return {triangle, weights, distance_at(corners, weights, point)};
        }
    }
    Hit best{triangle, {}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        Double3 weights{};
        weights[next] = along(corners[i], corners[next], point);
        weights[i] = 1 - weights[next];
        const double distance = distance_at(corners, weights, point);
        if (distance < best.distance) best = {triangle, weights, distance};
    }
    return best;
}

double distance_to(const Box& box, const Double3& point) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double outside = std::max({box.low[i] - point[i], point[i] - box.high[i], 0.0});
        sum += outside * outside;
    }
    return std::sqrt(sum);
}

}  // namespace feelem::pick
