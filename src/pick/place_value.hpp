// SPDX-License-Identifier: Apache-2.0
// What a result is worth at a place of a triangle: barycentric in double, and the solver's value at the
// nearest node. `feelem probe` and the viewer read values with this.
#pragma once

#include "feelem/pick.hpp"
#include "feelem/surface.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace feelem {

struct TrianglePlace {
    Triangle corners{};
    std::array<double, 3> weights{};
};

/// One result on the vertices.
struct FieldView {
    std::span<const float> values;       ///< vertices x width; NaN where the mask says missing.
    std::span<const Validity> validity;  ///< Per vertex.
    std::size_t width = 1;
};

struct PlaceValue {
    std::optional<double> value;         ///< Empty: a corner has none.
    std::optional<float> node_value;     ///< At the nearest node, bit for bit.
    std::string_view state = "missing";  ///< solver interpolated missing
};

/// The vertex of the corner of largest weight that has a node, the smallest id on a tie.
std::optional<std::uint32_t> nearest_vertex(
    const TrianglePlace& place, std::span<const std::int64_t> node_ids
);

PlaceValue value_at(
    const TrianglePlace& place,
    std::span<const std::int64_t> node_ids,
    const FieldView& field,
    std::size_t component
);

/// From `origin`, in double.
std::array<double, 3> point_of(
    const TrianglePlace& place, std::span<const Vertex3> positions, const std::array<double, 3>& origin
);

}  // namespace feelem
