// SPDX-License-Identifier: Apache-2.0
// Rays and points against triangles: which one, where on it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace feelem {

using Vertex3 = std::array<float, 3>;
using Triangle = std::array<std::uint32_t, 3>;

struct Hit {
    std::uint32_t triangle = 0;
    std::array<double, 3> weights{};  ///< Barycentric, of the triangle's three vertices; they add up to 1.
    double distance = 0;              ///< Along the (unit) ray, or from the point.
};

/// A bounding-volume hierarchy over triangles that are not copied: keep them alive.
class Picker {
public:
    Picker(std::span<const Vertex3> positions, std::span<const Triangle> triangles);
    /// First hit of a ray, both sides count; the smaller triangle index on a tie.
    std::optional<Hit> ray(const std::array<double, 3>& origin, const std::array<double, 3>& direction) const;
    /// Nearest place on the surface.
    std::optional<Hit> nearest(const std::array<double, 3>& point) const;

private:
    struct Node {
        std::array<float, 3> low{}, high{};
        std::uint32_t first = 0, count = 0;  ///< Leaf: into order_; inner: count 0, first = left child.
    };
    std::span<const Vertex3> positions_;
    std::span<const Triangle> triangles_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace feelem
