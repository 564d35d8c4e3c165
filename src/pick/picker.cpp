// SPDX-License-Identifier: Apache-2.0
// Must: hit whatever lies on the ray, shared edges and vertices included, and answer the same everywhere.
// Assumes: finite positions. Algorithm: a hierarchy of boxes split at the median of the triangles' centres;
// rays by the watertight test of Woop, Benthin & Wald (JCGT 2013) in double, whose edge functions have the
// same value, with opposite sign, for both triangles at an edge. Data: two numbers a triangle.
#include "base/parallel.hpp"
#include "pick/meet.hpp"

#include "feelem/pick.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace feelem {
namespace {

constexpr std::uint32_t kLeaf = 4;
/// Of a level of the hierarchy, for threads to share.
constexpr std::size_t kChunks = 64;
constexpr float kFar = std::numeric_limits<float>::infinity();

/// What splitting looks at, in one place of memory.
struct Centre {
    Vertex3 at{};
    std::uint32_t triangle = 0;
};

std::vector<Centre> centres_of(std::span<const Vertex3> positions, std::span<const Triangle> triangles) {
    std::vector<Centre> centres(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        centres[i].triangle = static_cast<std::uint32_t>(i);
        for (const std::uint32_t vertex : triangles[i]) {
            assert(vertex < positions.size());
            for (std::size_t k = 0; k < 3; ++k) centres[i].at[k] += positions[vertex][k] / 3;
        }
    }
    return centres;
}

/// Halves the centres where they spread most; the smaller triangle index first on a tie.
void halve(std::span<Centre> centres, std::size_t half) {
    Vertex3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
    for (const Centre& centre : centres) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], centre.at[k]);
            high[k] = std::max(high[k], centre.at[k]);
        }
    }
    std::size_t widest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (high[k] - low[k] > high[widest] - low[widest]) widest = k;
    }
    const auto middle = centres.begin() + static_cast<std::ptrdiff_t>(half);
    std::nth_element(centres.begin(), middle, centres.end(), [&](const Centre& a, const Centre& b) {
        return a.at[widest] != b.at[widest] ? a.at[widest] < b.at[widest] : a.triangle < b.triangle;
    });
}

/// Children stand behind their parents: from the last node to the first each is met after its children.
void fill_boxes(Hierarchy& tree, std::span<const Vertex3> positions, std::span<const Triangle> triangles) {
    for (std::size_t at = tree.nodes.size(); at-- > 0;) {
        BoxNode& node = tree.nodes[at];
        node.low.fill(kFar);
        node.high.fill(-kFar);
        const auto take = [&](const Vertex3& low, const Vertex3& high) {
            for (std::size_t k = 0; k < 3; ++k) {
                node.low[k] = std::min(node.low[k], low[k]);
                node.high[k] = std::max(node.high[k], high[k]);
            }
        };
        if (node.count == 0) {
            for (const std::uint32_t child : {node.first, node.first + 1}) {
                take(tree.nodes[child].low, tree.nodes[child].high);
            }
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            for (const std::uint32_t vertex : triangles[tree.order[i]])
                take(positions[vertex], positions[vertex]);
        }
    }
}

}  // namespace

Hierarchy grow_hierarchy(std::span<const Vertex3> positions, std::span<const Triangle> triangles) {
    Hierarchy tree;
    if (triangles.empty()) return tree;
    std::vector<Centre> centres = centres_of(positions, triangles);
    tree.nodes.push_back({{}, {}, 0, static_cast<std::uint32_t>(triangles.size())});
    // Level by level: nodes of one have nothing to do with each other.
    struct Split {
        std::uint32_t first = 0, count = 0;
    };
    std::vector<Split> splits;
    for (std::size_t begin = 0; begin < tree.nodes.size();) {
        const std::size_t end = tree.nodes.size();
        splits.clear();
        for (std::size_t at = begin; at < end; ++at) {
            const std::uint32_t first = tree.nodes[at].first, count = tree.nodes[at].count;
            if (count <= kLeaf) continue;
            splits.push_back({first, count});
            tree.nodes[at].first = static_cast<std::uint32_t>(tree.nodes.size());
            tree.nodes[at].count = 0;
            tree.nodes.push_back({{}, {}, first, count / 2});
            tree.nodes.push_back({{}, {}, first + count / 2, count - count / 2});
        }
        const std::size_t chunk = std::max<std::size_t>(splits.size() / kChunks, 1);
        parallel_chunks(splits.size(), chunk, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                halve(std::span(centres).subspan(splits[i].first, splits[i].count), splits[i].count / 2);
            }
        });
        begin = end;
    }
    tree.order.reserve(centres.size());
    for (const Centre& centre : centres) tree.order.push_back(centre.triangle);
    fill_boxes(tree, positions, triangles);
    return tree;
}

Picker::Picker(std::span<const Vertex3> positions, std::span<const Triangle> triangles)
    : positions_(positions), triangles_(triangles), tree_(grow_hierarchy(positions, triangles)) {}

std::optional<Hit> Picker::ray(const std::array<double, 3>& origin, const std::array<double, 3>& direction)
    const {
    const double length = std::sqrt(pick::dot(direction, direction));
    if (!pick::is_finite(origin) || !(length > 0) || !std::isfinite(length)) return std::nullopt;
    const pick::PreparedRay ray(
        origin, {direction[0] / length, direction[1] / length, direction[2] / length}
    );
    return pick::cast_ray(
        tree_,
        ray,
        std::numeric_limits<double>::infinity(),
        [&](std::uint32_t node) { return pick::box_of(tree_.nodes[node]); },
        [&](std::uint32_t triangle) { return corners(triangle); }
    );
}

std::optional<Hit> Picker::nearest(const std::array<double, 3>& point) const {
    if (!pick::is_finite(point)) return std::nullopt;
    return pick::find_nearest(
        tree_,
        point,
        std::numeric_limits<double>::infinity(),
        [&](std::uint32_t node) { return pick::box_of(tree_.nodes[node]); },
        [&](std::uint32_t triangle) { return corners(triangle); },
        [](const Hit&) { return true; }
    );
}

std::array<std::array<double, 3>, 3> Picker::corners(std::uint32_t triangle) const {
    const Triangle& t = triangles_[triangle];
    return {
        pick::widened(positions_[t[0]]), pick::widened(positions_[t[1]]), pick::widened(positions_[t[2]])};
}

}  // namespace feelem
