// SPDX-License-Identifier: Apache-2.0
// Rays and points against a part as it is drawn now: positions + factor x displacement. Nothing is rebuilt
// when the factor changes: a box of places and a box of displacements together bound where a node's triangles
// can be.
#pragma once

#include "pick/meet.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace feelem::viewer {

/// How much of a displacement is drawn.
struct Swing {
    std::span<const float> by;  ///< Three floats a vertex, NaN: does not move; empty: nothing does.
    double factor = 0;
};
/// Real and imaginary part.
using DrawnShape = std::array<Swing, 2>;

/// Where a vertex is drawn.
pick::Double3 drawn_at(std::span<const Vertex3> positions, const DrawnShape& shape, std::uint32_t vertex);

/// The arrays are not copied: keep them alive.
class MovingTree {
public:
    MovingTree(std::span<const Vertex3> positions, std::span<const Triangle> triangles);
    void set_shape(const DrawnShape& shape);

    /// Direction of unit length.
    std::optional<Hit> ray(const pick::Double3& origin, const pick::Double3& direction, double reach) const;
    /// Nearest place within `reach` that `keep` takes.
    std::optional<Hit> nearest(
        const pick::Double3& point, double reach, const std::function<bool(const pick::Double3&)>& keep
    ) const;
    pick::Corners3 corners(std::uint32_t triangle) const;

private:
    struct Moves {
        const float* of = nullptr;  ///< What the boxes were made of.
        std::vector<std::array<float, 6>> boxes;
    };
    void ready_boxes() const;
    pick::Box box(std::uint32_t node) const;
    std::vector<std::array<float, 6>> boxes_of(std::span<const float> by) const;

    std::span<const Vertex3> positions_;
    std::span<const Triangle> triangles_;
    Hierarchy tree_;
    DrawnShape shape_;
    mutable std::array<Moves, 2> moves_;  ///< Made when first asked for.
};

}  // namespace feelem::viewer
