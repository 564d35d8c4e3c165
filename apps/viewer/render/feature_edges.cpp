// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/feature_edges.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace feelem::viewer {
namespace {

const double kSharpCosine = std::cos(30 * 3.14159265358979323846 / 180);
/// Edges that are looked at for the median.
constexpr std::size_t kSamples = 1000;

/// Nodes of a part's vertices counted from 1; 0: none.
std::vector<std::uint32_t> node_numbers(const Geometry& geometry, const PartRange& part) {
    std::vector<std::uint32_t> order(part.vertices);
    std::iota(order.begin(), order.end(), 0U);
    const auto id_of = [&](std::uint32_t v) { return geometry.node_ids[part.first_vertex + v]; };
    std::ranges::sort(order, {}, [&](std::uint32_t v) { return std::pair(id_of(v), v); });
    std::vector<std::uint32_t> numbers(part.vertices, 0);
    std::uint32_t count = 0;
    std::int64_t last = 0;
    for (const std::uint32_t v : order) {
        if (id_of(v) == 0) continue;
        if (count == 0 || id_of(v) != last) ++count;
        last = id_of(v);
        numbers[v] = count;
    }
    return numbers;
}

glm::dvec3 facet_normal(const Geometry& geometry, std::size_t triangle) {
    std::array<glm::dvec3, 3> at;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& p = geometry.positions[geometry.triangles[triangle][k]];
        at[k] = {p[0], p[1], p[2]};
    }
    const glm::dvec3 across = glm::cross(at[1] - at[0], at[2] - at[0]);
    const double length = glm::length(across);
    return length > 0 ? across / length : across;
}

/// An edge of a triangle, by the numbers of its nodes.
struct NumberedEdge {
    std::uint32_t low = 0, high = 0;
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;
};

}  // namespace

std::vector<std::array<std::uint32_t, 2>> feature_edges(const Geometry& geometry, const PartRange& part) {
    const std::vector<std::uint32_t> numbers = node_numbers(geometry, part);
    std::vector<NumberedEdge> edges;
    edges.reserve(3 * std::size_t{part.triangles});
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangles; ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = numbers[geometry.triangles[t][k] - part.first_vertex];
            const std::uint32_t b = numbers[geometry.triangles[t][(k + 1) % 3] - part.first_vertex];
            if (a != 0 && b != 0 && a != b) edges.push_back({std::min(a, b), std::max(a, b), t, k});
        }
    }
    std::ranges::sort(edges, [](const NumberedEdge& a, const NumberedEdge& b) {
        return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
    });
    std::vector<std::array<std::uint32_t, 2>> kept;
    const auto keep = [&](const NumberedEdge& edge) {
        const auto& corners = geometry.triangles[edge.triangle];
        kept.push_back({corners[edge.corner], corners[(edge.corner + 1) % 3]});
    };
    const auto is_same = [](const NumberedEdge& a, const NumberedEdge& b) {
        return a.low == b.low && a.high == b.high;
    };
    for (std::size_t i = 0; i < edges.size();) {
        if (i + 1 == edges.size() || !is_same(edges[i], edges[i + 1])) {
            keep(edges[i]);
            ++i;
            continue;
        }
        const glm::dvec3 one = facet_normal(geometry, edges[i].triangle);
        if (glm::dot(one, facet_normal(geometry, edges[i + 1].triangle)) < kSharpCosine) keep(edges[i + 1]);
        i += 2;
    }
    return kept;
}

float typical_edge(const Geometry& geometry) {
    std::vector<float> lengths;
    const std::size_t step = std::max<std::size_t>(1, geometry.edges.size() / kSamples);
    for (std::size_t i = 0; i < geometry.edges.size(); i += step) {
        const auto& a = geometry.edge_positions[geometry.edges[i][0]];
        const auto& b = geometry.edge_positions[geometry.edges[i][1]];
        lengths.push_back(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
    if (lengths.empty()) return 0;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

}  // namespace feelem::viewer
