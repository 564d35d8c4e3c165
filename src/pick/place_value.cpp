// SPDX-License-Identifier: Apache-2.0
#include "pick/place_value.hpp"

#include <cmath>

namespace feelem {

std::optional<std::uint32_t> nearest_vertex(
    const TrianglePlace& place, std::span<const std::int64_t> node_ids
) {
    std::optional<std::uint32_t> best;
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = place.corners[k];
        const std::int64_t id = node_ids[vertex];
        if (id == 0) continue;
        const double weight = place.weights[k];
        if (best && (weight < most || (weight == most && id >= node_ids[*best]))) continue;
        best = vertex;
        most = weight;
    }
    return best;
}

PlaceValue value_at(
    const TrianglePlace& place,
    std::span<const std::int64_t> node_ids,
    const FieldView& field,
    std::size_t component
) {
    PlaceValue out;
    const auto at = [&](std::uint32_t vertex) { return field.values[vertex * field.width + component]; };
    if (const auto vertex = nearest_vertex(place, node_ids); vertex && !std::isnan(at(*vertex))) {
        out.node_value = at(*vertex);
    }
    double value = 0;
    std::string_view state = "solver";
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = place.corners[k];
        const double weight = place.weights[k];
        if (field.validity[vertex] == Validity::Missing) return out;
        if (weight <= 0) continue;
        const bool has_node = node_ids[vertex] != 0;
        if (field.validity[vertex] == Validity::Interpolated && has_node) state = "interpolated";
        value += weight * static_cast<double>(at(vertex));
    }
    out.value = value;
    out.state = state;
    return out;
}

std::array<double, 3> point_of(
    const TrianglePlace& place, std::span<const Vertex3> positions, const std::array<double, 3>& origin
) {
    std::array<double, 3> out = origin;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vertex3& corner = positions[place.corners[k]];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            out[axis] += place.weights[k] * static_cast<double>(corner[axis]);
        }
    }
    return out;
}

}  // namespace feelem
