// SPDX-License-Identifier: Apache-2.0
// Must: split vertices at creases only, so that a curved quadratic wall stays smooth. Assumes: facets of one
// piece are next to each other. Algorithm: union-find over the facets' points; two facets of an edge are
// joined when the triangles along it meet at no more than the crease angle. Normals weigh each triangle by
// its angle at the point (Thuermer & Wuethrich 1998), so that they do not depend on how a facet is cut. Data:
// 8 numbers a facet.
#include "skin/smooth_groups.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace feelem {
namespace {

class Joined {
public:
    explicit Joined(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    /// The smaller number becomes the root, so that the outcome does not depend on the order.
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a < b) parent_[b] = a;
        if (b < a) parent_[a] = b;
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// Sum of the area vectors of the facet's triangles along a side.
Point3 normal_along(const Outline& facet, std::size_t side, std::span<const Point3> coordinates) {
    const FacetPlaces places = places_of(facet, coordinates);
    const auto pattern = pattern_of(facet);
    Point3 sum{};
    for (const std::uint8_t i : pattern_along(facet, side)) {
        const FacetTriangle& t = pattern[i];
        const Point3 area = area_vector(places[t[0]], places[t[1]], places[t[2]]);
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += area[axis];
    }
    return sum;
}

bool is_smooth(const Point3& a, const Point3& b, double least_cosine) {
    const double lengths = std::sqrt(dot(a, a) * dot(b, b));
    return lengths > 0 && dot(a, b) >= least_cosine * lengths;
}

void join_sides(Joined& joined, std::span<const Outline> facets, std::uint32_t a, std::uint32_t b) {
    const Outline& first = facets[a / 4];
    const Outline& second = facets[b / 4];
    const auto i = static_cast<std::uint32_t>(a % 4), k = static_cast<std::uint32_t>(b % 4);
    const auto i_end = static_cast<std::uint32_t>(first.after(i));
    const auto k_end = static_cast<std::uint32_t>(second.after(k));
    joined.join(8 * (a / 4) + i, 8 * (b / 4) + k_end);
    joined.join(8 * (a / 4) + i_end, 8 * (b / 4) + k);
    joined.join(8 * (a / 4) + 4 + i, 8 * (b / 4) + 4 + k);
}

void join_across_edges(
    Joined& joined,
    std::span<const Outline> facets,
    std::span<const std::uint32_t> pieces,
    const EdgeTable& edges,
    std::span<const Point3> coordinates,
    double least_cosine
) {
    const auto piece_end = [&](std::uint32_t facet) { return *std::ranges::upper_bound(pieces, facet); };
    for (const std::uint32_t first : edges.first) {
        // Sides ascend, so those of one piece follow each other.
        for (std::uint32_t a = first; a != kNoSide;) {
            const std::uint32_t end = piece_end(facet_of_side(a));
            const std::uint32_t b = edges.next[a];
            std::uint32_t count = 1;
            std::uint32_t after = b;
            for (; after != kNoSide && facet_of_side(after) < end; after = edges.next[after]) ++count;
            if (count == 2 && runs_up(facets, a) != runs_up(facets, b)) {
                const Point3 here = normal_along(facets[a / 4], a % 4, coordinates);
                const Point3 there = normal_along(facets[b / 4], b % 4, coordinates);
                if (is_smooth(here, there, least_cosine)) join_sides(joined, facets, a, b);
            }
            a = after;
        }
    }
}

double angle_between(const Point3& a, const Point3& b) {
    const Point3 c = cross(a, b);
    return std::atan2(std::sqrt(dot(c, c)), dot(a, b));
}

}  // namespace

std::array<float, 3> unit(const Point3& vector) noexcept {
    const double length = std::sqrt(dot(vector, vector));
    if (!(length > 0)) return {};
    return {
        static_cast<float>(vector[0] / length),
        static_cast<float>(vector[1] / length),
        static_cast<float>(vector[2] / length)};
}

SmoothGroups find_smooth_groups(
    std::span<const Outline> facets,
    std::span<const std::uint32_t> pieces,
    const EdgeTable& edges,
    std::span<const Point3> coordinates,
    double crease_angle
) {
    // The little that is taken off keeps flat walls whole at an angle of 0.
    const double least_cosine =
        std::cos(std::clamp(crease_angle, 0.0, 180.0) * std::numbers::pi / 180) - 1e-12;
    Joined joined(facets.size() * 8);
    join_across_edges(joined, facets, pieces, edges, coordinates, least_cosine);

    SmoothGroups out;
    out.of_point.assign(facets.size() * 8, kNoSide);
    std::vector<Point3> sums;
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
        const bool has_middles = facets[f].has_middles();
        for (std::uint32_t k = 0; k < 8; ++k) {
            if (k % 4 >= facets[f].count || (k >= 4 && !has_middles)) continue;
            std::uint32_t& group = out.of_point[joined.root(8 * f + k)];
            if (group == kNoSide) {
                group = static_cast<std::uint32_t>(sums.size());
                sums.emplace_back();
            }
            out.of_point[8 * f + k] = group;
        }
    }
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const FacetPlaces at = places_of(facets[f], coordinates);
        for (const FacetTriangle& t : pattern_of(facets[f])) {
            const auto normal = unit(area_vector(at[t[0]], at[t[1]], at[t[2]]));
            for (std::size_t k = 0; k < 3; ++k) {
                if (t[k] == kCentre) continue;
                const Point3& here = at[t[k]];
                const double angle =
                    angle_between(minus(at[t[(k + 1) % 3]], here), minus(at[t[(k + 2) % 3]], here));
                Point3& sum = sums[out.of_point[f * 8 + t[k]]];
                for (std::size_t axis = 0; axis < 3; ++axis)
                    sum[axis] += angle * static_cast<double>(normal[axis]);
            }
        }
    }
    out.normals.reserve(sums.size());
    for (const Point3& sum : sums) out.normals.push_back(unit(sum));
    return out;
}

}  // namespace feelem
