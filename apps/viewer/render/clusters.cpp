// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/clusters.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace feelem::viewer {
namespace {

glm::vec3 place_of(const Geometry& geometry, std::uint32_t vertex) {
    const auto& p = geometry.positions[vertex];
    return {p[0], p[1], p[2]};
}

bool share_corner(const std::array<std::uint32_t, 3>& one, const std::array<std::uint32_t, 3>& two) {
    return std::ranges::any_of(one, [&](std::uint32_t v) {
        return v == two[0] || v == two[1] || v == two[2];
    });
}

/// Of unit length; zero for a triangle without area.
glm::vec3 normal_of(const Geometry& geometry, const std::array<std::uint32_t, 3>& triangle) {
    const glm::dvec3 a = place_of(geometry, triangle[0]);
    const glm::dvec3 across = glm::cross(
        glm::dvec3(place_of(geometry, triangle[1])) - a, glm::dvec3(place_of(geometry, triangle[2])) - a
    );
    const double length = glm::length(across);
    return length > 0 ? glm::vec3(across / length) : glm::vec3(0);
}

void find_sphere(const Geometry& geometry, Triangles own, Cluster& cluster) {
    glm::vec3 low = place_of(geometry, own[0][0]), high = low;
    for (const auto& triangle : own) {
        for (const std::uint32_t vertex : triangle) {
            low = glm::min(low, place_of(geometry, vertex));
            high = glm::max(high, place_of(geometry, vertex));
        }
    }
    cluster.centre = 0.5F * (low + high);
    for (const auto& triangle : own)
        for (const std::uint32_t vertex : triangle)
            cluster.radius =
                std::max(cluster.radius, glm::distance(cluster.centre, place_of(geometry, vertex)));
    // Rounding must not cost a corner its place.
    cluster.radius *= 1.00001F;
}

void find_cone(const Geometry& geometry, Triangles own, Cluster& cluster) {
    std::array<glm::vec3, kMostOfCluster> normals;
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < own.size(); ++i) sum += normals[i] = normal_of(geometry, own[i]);
    if (!(glm::length(sum) > 0)) return;
    cluster.axis = glm::normalize(sum);
    float least = 1;
    for (std::size_t i = 0; i < own.size(); ++i)
        if (normals[i] != glm::vec3(0)) least = std::min(least, glm::dot(cluster.axis, normals[i]));
    least -= 1.0e-4F;
    if (least > 0) cluster.spread = std::sqrt(std::max(1 - least * least, 0.0F));
}

/// splitmix64's last step: every bit of the key reaches every bit of the sum.
std::uint64_t scattered(std::uint64_t key) {
    key += 0x9E3779B97F4A7C15U;
    key = (key ^ key >> 30) * 0xBF58476D1CE4E5B9U;
    key = (key ^ key >> 27) * 0x94D049BB133111EBU;
    return key ^ key >> 31;
}

bool is_in(const PartRange& part, std::uint32_t vertex) {
    return vertex >= part.first_vertex && vertex - part.first_vertex < part.vertices;
}

/// The part of a triangle, near the one before it.
std::uint32_t part_of(const Geometry& geometry, std::uint32_t vertex, std::uint32_t last) {
    if (is_in(geometry.parts[last], vertex)) return last;
    std::uint32_t part = 0;
    while (part + 1 < geometry.parts.size() && !is_in(geometry.parts[part], vertex)) ++part;
    return part;
}

/// Every third bit.
std::uint64_t spread_bits(std::uint64_t number) {
    number &= 0x7FFFF;
    number = (number | number << 32) & 0x1F00000000FFFF;
    number = (number | number << 16) & 0x1F0000FF0000FF;
    number = (number | number << 8) & 0x100F00F00F00F00F;
    number = (number | number << 4) & 0x10C30C30C30C30C3;
    return (number | number << 2) & 0x1249249249249249;
}

/// Which of six ways a triangle faces, then where its middle is along a curve that fills space.
std::uint64_t order_key(const Geometry& geometry, const std::array<std::uint32_t, 3>& triangle) {
    const glm::vec3 a = place_of(geometry, triangle[0]), b = place_of(geometry, triangle[1]),
                    c = place_of(geometry, triangle[2]);
    const glm::vec3 normal = glm::cross(b - a, c - a), size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto way = static_cast<std::uint64_t>(2 * axis + (normal[axis] < 0 ? 1 : 0));
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const float low = geometry.low[i], extent = geometry.high[i] - low;
        const float along = extent > 0 ? ((a[k] + b[k] + c[k]) / 3 - low) / extent : 0;
        constexpr float kMost = 0x7FFFF;
        const float held = std::isfinite(along) ? std::clamp(along * kMost, 0.0F, kMost) : 0;
        key |= spread_bits(static_cast<std::uint64_t>(held)) << k;
    }
    return way << 57 | key;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> clustered_order(const Geometry& geometry, Triangles triangles) {
    std::vector<std::array<std::uint32_t, 3>> out;
    out.reserve(triangles.size());
    std::vector<std::pair<std::uint64_t, std::uint32_t>> run;
    std::uint32_t part = 0;
    for (std::size_t first = 0; first < triangles.size();) {
        part = part_of(geometry, triangles[first][0], part);
        run.clear();
        std::size_t next = first;
        for (; next < triangles.size() && is_in(geometry.parts[part], triangles[next][0]); ++next)
            run.emplace_back(order_key(geometry, triangles[next]), static_cast<std::uint32_t>(next));
        if (next == first) {
            // Of no part: it stays where it is.
            run.emplace_back(0, static_cast<std::uint32_t>(first));
            ++next;
        }
        std::ranges::sort(run);
        for (const auto& [key, triangle] : run) out.push_back(triangles[triangle]);
        first = next;
    }
    return out;
}

std::vector<Cluster> make_clusters(const Geometry& geometry, Triangles triangles) {
    std::vector<Cluster> out;
    out.reserve(triangles.size() / kLeastOfCluster + geometry.parts.size() + 1);
    std::uint32_t part = 0;
    for (std::uint32_t first = 0; first < triangles.size();) {
        part = part_of(geometry, triangles[first][0], part);
        Cluster cluster{.first = first, .triangles = 1, .part = part};
        for (std::uint32_t next = first + 1; next < triangles.size(); ++next) {
            if (cluster.triangles == kMostOfCluster || !is_in(geometry.parts[part], triangles[next][0]))
                break;
            if (cluster.triangles >= kLeastOfCluster && !share_corner(triangles[next - 1], triangles[next]))
                break;
            ++cluster.triangles;
        }
        const Triangles own = triangles.subspan(first, cluster.triangles);
        find_sphere(geometry, own, cluster);
        find_cone(geometry, own, cluster);
        out.push_back(cluster);
        first += cluster.triangles;
    }
    return out;
}

std::vector<ClusterMove> cluster_moves(
    Triangles triangles, std::span<const Cluster> clusters, std::span<const float> vectors
) {
    std::vector<ClusterMove> out;
    out.reserve(clusters.size());
    const auto vector_of = [&](std::uint32_t vertex) {
        glm::vec3 v(0);
        for (int k = 0; k < 3; ++k) {
            const float number = vectors[3 * std::size_t{vertex} + static_cast<std::size_t>(k)];
            v[k] = std::isfinite(number) ? number : 0;
        }
        return v;
    };
    for (const Cluster& cluster : clusters) {
        const Triangles own = triangles.subspan(cluster.first, cluster.triangles);
        glm::vec3 low = vector_of(own[0][0]), high = low;
        for (const auto& triangle : own) {
            for (const std::uint32_t vertex : triangle) {
                low = glm::min(low, vector_of(vertex));
                high = glm::max(high, vector_of(vertex));
            }
        }
        out.push_back({0.5F * (low + high), 0.50001F * glm::distance(low, high)});
    }
    return out;
}

SeenFrom seen_from(const glm::mat4& clip_from_model, const glm::mat4& eye_from_model) {
    SeenFrom out;
    const glm::mat4 rows = glm::transpose(clip_from_model);
    for (int axis = 0; axis < 3; ++axis) {
        out.planes[2 * static_cast<std::size_t>(axis)] = rows[3] + rows[axis];
        out.planes[2 * static_cast<std::size_t>(axis) + 1] = rows[3] - rows[axis];
    }
    for (glm::vec4& plane : out.planes) {
        const float length = glm::length(glm::vec3(plane));
        if (length > 0) plane /= length;
    }
    out.eye = glm::vec3(glm::inverse(eye_from_model)[3]);
    return out;
}

bool is_outside(const SeenFrom& view, const glm::vec3& centre, float radius) {
    return std::ranges::any_of(view.planes, [&](const glm::vec4& plane) {
        return glm::dot(glm::vec3(plane), centre) + plane.w < -radius;
    });
}

bool is_turned_away(const SeenFrom& view, const Cluster& cluster) {
    if (cluster.spread > 1) return false;
    const glm::vec3 to_centre = cluster.centre - view.eye;
    const float distance = glm::length(to_centre);
    return glm::dot(to_centre, cluster.axis) >= cluster.spread * distance + cluster.radius;
}

std::vector<std::uint64_t> open_edges(const Geometry& geometry) {
    const auto name_of = [&](std::uint32_t vertex) {
        const std::int64_t id = vertex < geometry.node_ids.size() ? geometry.node_ids[vertex] : 0;
        // A vertex without node is itself.
        return id != 0 ? scattered(static_cast<std::uint64_t>(id)) : scattered(vertex ^ 0x5555555500000000U);
    };
    std::vector<std::uint64_t> sums;
    for (const PartRange& part : geometry.parts) {
        std::uint64_t sum = 0;
        for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangles; ++t) {
            std::array<std::uint64_t, 3> names{};
            for (std::size_t k = 0; k < 3; ++k) names[k] = name_of(geometry.triangles[t][k]);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint64_t a = names[k], b = names[(k + 1) % 3];
                const std::uint64_t edge = scattered(std::min(a, b) ^ scattered(std::max(a, b)));
                sum += a < b ? edge : a > b ? ~edge + 1 : 0;
            }
        }
        sums.push_back(sum);
    }
    return sums;
}

}  // namespace feelem::viewer
