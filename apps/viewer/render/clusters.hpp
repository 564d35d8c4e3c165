// SPDX-License-Identifier: Apache-2.0
// Runs of neighbouring triangles, so that those that cannot be seen are left out many at a time. No OpenGL.
#pragma once

#include "viewer/scene/loaded_scene.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace feelem::viewer {

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

inline constexpr std::uint32_t kLeastOfCluster = 64, kMostOfCluster = 128;

struct Cluster {
    std::uint32_t first = 0, triangles = 0;  ///< In the list it was made of.
    std::uint32_t part = 0;
    glm::vec3 centre{0};
    float radius = 0;
    /// All normals lie within an angle of `axis` whose sine is `spread`; 2: no such angle below 90 degrees.
    glm::vec3 axis{0, 0, 1};
    float spread = 2;
};

/// The triangles of each part so that neighbours that face the same way follow each other: solvers number
/// elements as they like, and both sides of a thin wall in turn.
std::vector<std::array<std::uint32_t, 3>> clustered_order(const Geometry& geometry, Triangles triangles);

/// In the order of the triangles; a cluster lies in one part. From kLeastOfCluster on it ends where the list
/// jumps.
std::vector<Cluster> make_clusters(const Geometry& geometry, Triangles triangles);

/// How far a vector a vertex moves a cluster: its vectors lie in this sphere.
struct ClusterMove {
    glm::vec3 middle{0};
    float radius = 0;
};
/// `vectors`: three numbers a vertex; those that are not finite count as zero.
std::vector<ClusterMove> cluster_moves(
    Triangles triangles, std::span<const Cluster> clusters, std::span<const float> vectors
);

/// What an eye sees, in the space of the model.
struct SeenFrom {
    std::array<glm::vec4, 6> planes;  ///< Inside: dot(xyz, place) + w >= 0; xyz of unit length.
    glm::vec3 eye{0};
};
/// `clip_from_model`: projection times view times model.
SeenFrom seen_from(const glm::mat4& clip_from_model, const glm::mat4& eye_from_model);

bool is_outside(const SeenFrom& view, const glm::vec3& centre, float radius);
/// All triangles of the cluster turn their backs to the eye.
bool is_turned_away(const SeenFrom& view, const Cluster& cluster);

/// Per part a sum over its edges. Parts whose sums add up to zero enclose volumes together: each edge is used
/// once in each direction. Hashes of 64 bits, so wrong with a chance of one in 2^64. Vertices of the same
/// node are one.
std::vector<std::uint64_t> open_edges(const Geometry& geometry);

}  // namespace feelem::viewer
