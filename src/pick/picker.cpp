// SPDX-License-Identifier: Apache-2.0
// Must: hit whatever lies on the ray, shared edges and vertices included, and answer the same everywhere.
// Assumes: finite positions. Algorithm: a hierarchy of boxes split at the median of the triangles' centres;
// rays by the watertight test of Woop, Benthin & Wald (JCGT 2013) in double, whose edge functions have the
// same value, with opposite sign, for both triangles at an edge. Data: two numbers a triangle.
#include "pick/meet.hpp"

#include "feelem/pick.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace feelem {
namespace {

constexpr std::uint32_t kLeaf = 4;

}  // namespace

Hierarchy grow_hierarchy(std::span<const Vertex3> positions, std::span<const Triangle> triangles) {
    Hierarchy tree;
    std::vector<std::uint32_t>& order = tree.order;
    order.resize(triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    if (order.empty()) return tree;
    std::vector<Vertex3> centres(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (const std::uint32_t vertex : triangles[i]) {
            assert(vertex < positions.size());
            for (std::size_t k = 0; k < 3; ++k) centres[i][k] += positions[vertex][k] / 3;
        }
    }
    tree.nodes.push_back({{}, {}, 0, static_cast<std::uint32_t>(order.size())});
    for (std::size_t at = 0; at < tree.nodes.size(); ++at) {
        BoxNode node = tree.nodes[at];
        node.low.fill(std::numeric_limits<float>::infinity());
        node.high.fill(-std::numeric_limits<float>::infinity());
        BoxNode inside = node;  // box of the centres
        const auto begin = order.begin() + node.first;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                for (const std::uint32_t vertex : triangles[order[i]]) {
                    node.low[k] = std::min(node.low[k], positions[vertex][k]);
                    node.high[k] = std::max(node.high[k], positions[vertex][k]);
                }
                inside.low[k] = std::min(inside.low[k], centres[order[i]][k]);
                inside.high[k] = std::max(inside.high[k], centres[order[i]][k]);
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
            const auto left = static_cast<std::uint32_t>(tree.nodes.size());
            tree.nodes.push_back({{}, {}, node.first, half});
            tree.nodes.push_back({{}, {}, node.first + half, node.count - half});
            node.first = left;
            node.count = 0;
        }
        tree.nodes[at] = node;
    }
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
