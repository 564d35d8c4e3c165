// SPDX-License-Identifier: Apache-2.0
// Shape functions: what each node of an element counts at a place inside it. One row an element type, derived
// from the reference coordinates and edges of the element table.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"
#include "feelem/mesh.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace feelem {

/// One weight a node; those beyond the element's own nodes are 0.
using ShapeWeights = std::array<double, kMaxElementNodes>;
struct ShapeSlopes {
    ShapeWeights weights{};
    std::array<Point3, kMaxElementNodes> slopes{};  ///< Per node: by each reference coordinate.
};

/// `at` is in the coordinates of the element table's reference element.
ShapeWeights shape_at(ElementType type, const Point3& at) noexcept;
ShapeSlopes shape_slopes_at(ElementType type, const Point3& at) noexcept;

/// Where nodes may be missing (kNoNode): an edge without its mid-side node counts as straight, half of that
/// node for each of its corners; an element without one of its inner nodes (of a facet or the body) is taken
/// as its kind that has none of them. Missing nodes have the weight 0.
ShapeWeights shape_at(ElementType type, std::span<const NodeIndex> nodes, const Point3& at) noexcept;
ShapeSlopes shape_slopes_at(ElementType type, std::span<const NodeIndex> nodes, const Point3& at) noexcept;

/// Mean of the corners of the reference element.
Point3 reference_centre(ElementType type) noexcept;

/// How far inside the reference element of a solid: distance to the nearest of its facets, negative outside.
double depth_inside(ElementType type, const Point3& at) noexcept;

/// Where in a solid `target` is, by Newton's method; empty when it does not converge, as happens far outside.
std::optional<Point3> find_natural(
    ElementType type, std::span<const NodeIndex> nodes, std::span<const Point3> places, const Point3& target
) noexcept;

}  // namespace feelem
