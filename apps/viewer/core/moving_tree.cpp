// SPDX-License-Identifier: Apache-2.0
#include "viewer/core/moving_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feelem::viewer {
namespace {

/// A missing displacement moves nothing.
float moved(float by) {
    return std::isnan(by) ? 0 : by;
}

bool is_moving(const Swing& swing) {
    return !swing.by.empty() && swing.factor != 0;
}

}  // namespace

pick::Double3 drawn_at(std::span<const Vertex3> positions, const DrawnShape& shape, std::uint32_t vertex) {
    pick::Double3 at = pick::widened(positions[vertex]);
    for (const Swing& swing : shape) {
        if (!is_moving(swing)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] += swing.factor * static_cast<double>(moved(swing.by[3 * std::size_t{vertex} + k]));
        }
    }
    return at;
}

MovingTree::MovingTree(std::span<const Vertex3> positions, std::span<const Triangle> triangles)
    : positions_(positions), triangles_(triangles), tree_(grow_hierarchy(positions, triangles)) {}

void MovingTree::set_shape(const DrawnShape& shape) {
    shape_ = shape;
}

pick::Corners3 MovingTree::corners(std::uint32_t triangle) const {
    const Triangle& t = triangles_[triangle];
    return {
        drawn_at(positions_, shape_, t[0]),
        drawn_at(positions_, shape_, t[1]),
        drawn_at(positions_, shape_, t[2])};
}

/// Children stand behind their parents: from the last node to the first each is met after its children.
std::vector<std::array<float, 6>> MovingTree::boxes_of(std::span<const float> by) const {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    std::vector<std::array<float, 6>> boxes(tree_.nodes.size(), {kFar, kFar, kFar, -kFar, -kFar, -kFar});
    for (std::size_t at = boxes.size(); at-- > 0;) {
        const BoxNode& node = tree_.nodes[at];
        std::array<float, 6>& box = boxes[at];
        if (node.count == 0) {
            const auto &left = boxes[node.first], &right = boxes[node.first + 1];
            for (std::size_t k = 0; k < 3; ++k) {
                box[k] = std::min(left[k], right[k]);
                box[3 + k] = std::max(left[3 + k], right[3 + k]);
            }
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            for (const std::uint32_t vertex : triangles_[tree_.order[i]]) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const float along = moved(by[3 * std::size_t{vertex} + k]);
                    box[k] = std::min(box[k], along);
                    box[3 + k] = std::max(box[3 + k], along);
                }
            }
        }
    }
    return boxes;
}

void MovingTree::ready_boxes() const {
    for (std::size_t i = 0; i < 2; ++i) {
        if (!is_moving(shape_[i]) || moves_[i].of == shape_[i].by.data()) continue;
        moves_[i].boxes = boxes_of(shape_[i].by);
        moves_[i].of = shape_[i].by.data();
    }
}

pick::Box MovingTree::box(std::uint32_t node) const {
    pick::Box box = pick::box_of(tree_.nodes[node]);
    for (std::size_t i = 0; i < 2; ++i) {
        const double factor = shape_[i].factor;
        if (!is_moving(shape_[i])) continue;
        const std::array<float, 6>& by = moves_[i].boxes[node];
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = factor * static_cast<double>(by[k]);
            const double b = factor * static_cast<double>(by[3 + k]);
            box.low[k] += std::min(a, b);
            box.high[k] += std::max(a, b);
        }
    }
    return box;
}

std::optional<Hit> MovingTree::ray(const pick::Double3& origin, const pick::Double3& direction, double reach)
    const {
    ready_boxes();
    return pick::cast_ray(
        tree_,
        pick::PreparedRay(origin, direction),
        reach,
        [&](std::uint32_t node) { return box(node); },
        [&](std::uint32_t triangle) { return corners(triangle); }
    );
}

std::optional<Hit> MovingTree::nearest(
    const pick::Double3& point, double reach, const std::function<bool(const pick::Double3&)>& keep
) const {
    ready_boxes();
    const auto is_kept = [&](const Hit& hit) {
        const pick::Corners3 at = corners(hit.triangle);
        pick::Double3 place{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) place[k] += hit.weights[i] * at[i][k];
        }
        return keep(place);
    };
    return pick::find_nearest(
        tree_,
        point,
        reach,
        [&](std::uint32_t node) { return box(node); },
        [&](std::uint32_t triangle) { return corners(triangle); },
        is_kept
    );
}

}  // namespace feelem::viewer
