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

/// A box of a hierarchy. Leaf: `count` entries of Hierarchy::order from `first` on; inner: count 0, children
/// at `first` and behind it, both later than their parent.
struct BoxNode {
    std::array<float, 3> low{}, high{};
    std::uint32_t first = 0, count = 0;
};
struct Hierarchy {
    std::vector<std::uint32_t> order;  ///< Triangles.
    std::vector<BoxNode> nodes;        ///< The root first; empty without triangles.
};
Hierarchy grow_hierarchy(std::span<const Vertex3> positions, std::span<const Triangle> triangles);

/// A bounding-volume hierarchy over triangles that are not copied: keep them alive.
class Picker {
public:
    Picker(std::span<const Vertex3> positions, std::span<const Triangle> triangles);
    /// First hit of a ray, both sides count; the smaller triangle index on a tie.
    std::optional<Hit> ray(const std::array<double, 3>& origin, const std::array<double, 3>& direction) const;
    /// Nearest place on the surface.
    std::optional<Hit> nearest(const std::array<double, 3>& point) const;

private:
    std::array<std::array<double, 3>, 3> corners(std::uint32_t triangle) const;
    std::span<const Vertex3> positions_;
    std::span<const Triangle> triangles_;
    Hierarchy tree_;
};

}  // namespace feelem
