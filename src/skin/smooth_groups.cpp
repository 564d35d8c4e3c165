// SPDX-License-Identifier: Apache-2.0
// Must: split vertices at creases only, so that a curved quadratic wall stays smooth. Assumes: facets of one
// piece are next to each other. Algorithm: union-find over the facets' points; two facets of an edge are
// joined when the triangles along it meet at no more than the crease angle. Normals weigh each triangle by
// its angle at the point (Thuermer & Wuethrich 1998), so that they do not depend on how a facet is cut. Data:
// 4 or 8 numbers a facet, and while facets are joined the 4 normals along its sides.
#include "skin/smooth_groups.hpp"

#include "base/huge_pages.hpp"
#include "base/parallel.hpp"
#include "skin/corner_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace feelem {
namespace {

/// Facets whose shares in normals wait in the cache to be added.
constexpr std::size_t kShareChunk = 1024;

class Joined {
public:
    explicit Joined(std::size_t count) {
        reserve_big(parent_, count);
        for (std::size_t i = 0; i < count; ++i) parent_.push_back(static_cast<std::uint32_t>(i));
    }

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

    /// The number of each one's group, in order of first use; kNoSide where exists(i) is false. Ends the
    /// joining: the groups take the place of the roots.
    template <class Exists>
    std::vector<std::uint32_t> groups(std::uint32_t& count, Exists exists) && {
        for (std::uint32_t& root : parent_) root = parent_[root];  // Roots come before what hangs on them.
        for (std::uint32_t i = 0; i < parent_.size(); ++i) {
            const std::uint32_t root = parent_[i];
            if (root == i) {
                parent_[i] = exists(i) ? count++ : kNoSide;
            } else if (!exists(i)) {
                parent_[i] = kNoSide;
            } else {
                if (parent_[root] == kNoSide) parent_[root] = count++;
                parent_[i] = parent_[root];
            }
        }
        return std::move(parent_);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// Per side: the sum of the area vectors of the facet's triangles along it.
ZeroedArray<Point3> normals_along_sides(
    std::span<const Outline> facets, std::span<const Point3> coordinates
) {
    ZeroedArray<Point3> along(facets.size() * 4);
    parallel_chunks(facets.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t f = first; f < last; ++f) {
            fetch_places(facets, f, coordinates);
            const FacetPlaces places = places_of(facets[f], coordinates);
            const auto pattern = pattern_of(facets[f]);
            for (std::size_t side = 0; side < facets[f].count; ++side) {
                Point3& sum = along[f * 4 + side];
                for (const std::uint8_t i : pattern_along(facets[f], side)) {
                    const FacetTriangle& t = pattern[i];
                    const Point3 area = area_vector(places[t[0]], places[t[1]], places[t[2]]);
                    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += area[axis];
                }
            }
        }
    });
    return along;
}

bool is_smooth(const Point3& a, const Point3& b, double least_cosine) {
    const double lengths = std::sqrt(dot(a, a) * dot(b, b));
    return lengths > 0 && dot(a, b) >= least_cosine * lengths;
}

void join_sides(
    Joined& joined, std::span<const Outline> facets, std::uint32_t stride, std::uint32_t a, std::uint32_t b
) {
    const Outline& first = facets[a / 4];
    const Outline& second = facets[b / 4];
    const auto i = static_cast<std::uint32_t>(a % 4), k = static_cast<std::uint32_t>(b % 4);
    const auto i_end = static_cast<std::uint32_t>(first.after(i));
    const auto k_end = static_cast<std::uint32_t>(second.after(k));
    joined.join(stride * (a / 4) + i, stride * (b / 4) + k_end);
    joined.join(stride * (a / 4) + i_end, stride * (b / 4) + k);
    if (stride > kFirstMiddle) joined.join(stride * (a / 4) + 4 + i, stride * (b / 4) + 4 + k);
}

void join_across_edges(
    Joined& joined,
    std::span<const Outline> facets,
    std::span<const std::uint32_t> pieces,
    std::uint32_t stride,
    const EdgeTable& edges,
    std::span<const Point3> along,
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
            if (count == 2 && runs_up(facets, a) != runs_up(facets, b) &&
                is_smooth(along[a], along[b], least_cosine))
                join_sides(joined, facets, stride, a, b);
            a = after;
        }
    }
}

/// What a triangle adds to the normal of a point's group.
struct Share {
    std::uint32_t group = 0;
    Point3 normal{};
};

Share share_of(std::uint32_t group, double angle, const std::array<float, 3>& normal) {
    Share share;
    share.group = group;
    for (std::size_t axis = 0; axis < 3; ++axis)
        share.normal[axis] = angle * static_cast<double>(normal[axis]);
    return share;
}

/// A quad without middles: four triangles, each with two angles that count.
void add_shares_of_quad(
    const FacetPlaces& at, const std::uint32_t* group_of_point, std::vector<Share>& shares
) {
    EightPairs pairs;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        pairs.set(2 * i, minus(at[next], at[i]), minus(at[kCentre], at[i]));
        pairs.set(2 * i + 1, minus(at[kCentre], at[next]), minus(at[i], at[next]));
    }
    const EightAngles angles = angles_between(pairs);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        const auto normal = unit(area_vector(at[i], at[next], at[kCentre]));
        shares.push_back(share_of(group_of_point[i], angles[2 * i], normal));
        shares.push_back(share_of(group_of_point[next], angles[2 * i + 1], normal));
    }
}

void add_shares(
    const Outline& facet,
    std::span<const Point3> coordinates,
    const std::uint32_t* group_of_point,
    std::vector<Share>& shares
) {
    const FacetPlaces at = places_of(facet, coordinates);
    if (facet.count == 4 && !facet.has_middles()) return add_shares_of_quad(at, group_of_point, shares);
    for (const FacetTriangle& t : pattern_of(facet)) {
        const auto normal = unit(area_vector(at[t[0]], at[t[1]], at[t[2]]));
        for (std::size_t k = 0; k < 3; ++k) {
            if (t[k] == kCentre) continue;
            const Point3& here = at[t[k]];
            const double angle =
                angle_between(minus(at[t[(k + 1) % 3]], here), minus(at[t[(k + 2) % 3]], here));
            shares.push_back(share_of(group_of_point[t[k]], angle, normal));
        }
    }
}

/// Per group. Shares are found by many threads, and added in the order of facets.
ZeroedArray<Point3> sums_of_normals(
    std::span<const Outline> facets,
    std::span<const Point3> coordinates,
    const SmoothGroups& groups,
    std::size_t group_count
) {
    ZeroedArray<Point3> sums(group_count);
    const std::size_t chunks = thread_count() > 1 ? thread_count() * std::size_t{4} : 1;
    std::vector<std::vector<Share>> found(chunks);
    for (std::size_t start = 0; start < facets.size(); start += chunks * kShareChunk) {
        const std::size_t window = std::min(facets.size() - start, chunks * kShareChunk);
        parallel_chunks(window, kShareChunk, [&](std::size_t first, std::size_t last) {
            std::vector<Share>& shares = found[first / kShareChunk];
            for (std::size_t f = start + first; f < start + last; ++f) {
                fetch_places(facets, f, coordinates);
                add_shares(facets[f], coordinates, &groups.of_point[f * groups.stride], shares);
            }
        });
        for (std::vector<Share>& shares : found) {
            for (const Share& share : shares) {
                for (std::size_t axis = 0; axis < 3; ++axis) sums[share.group][axis] += share.normal[axis];
            }
            shares.clear();
        }
    }
    return sums;
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
    SmoothGroups out;
    out.stride = std::ranges::any_of(facets, &Outline::has_middles) ? 8 : 4;
    Joined joined(facets.size() * out.stride);
    {
        const ZeroedArray<Point3> along = normals_along_sides(facets, coordinates);
        join_across_edges(joined, facets, pieces, out.stride, edges, along.span(), least_cosine);
    }
    std::uint32_t count = 0;
    out.of_point = std::move(joined).groups(count, [&](std::uint32_t point) {
        const Outline& facet = facets[point / out.stride];
        const std::uint32_t k = point % out.stride;
        return k % 4 < facet.count && (k < kFirstMiddle || facet.has_middles());
    });
    const ZeroedArray<Point3> sums = sums_of_normals(facets, coordinates, out, count);
    reserve_big(out.normals, sums.size());
    for (const Point3& sum : sums.span()) out.normals.push_back(unit(sum));
    return out;
}

}  // namespace feelem
