// SPDX-License-Identifier: Apache-2.0
// Clusters of triangles, what is out of sight, and the lines that show a shape.
#include "viewer/render/clusters.hpp"
#include "viewer/render/drawing.hpp"
#include "viewer/render/feature_edges.hpp"
#include "viewer/render/visible.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <limits>

namespace feelem::viewer::tests {
namespace {

glm::vec3 at(const Geometry& geometry, std::uint32_t vertex) {
    const auto& p = geometry.positions[vertex];
    return {p[0], p[1], p[2]};
}

TEST(Clusters, hold_each_triangle_once_and_lie_in_one_part) {
    SmallModel model = box_model({1, 1, 1}, 9);
    append(model, ball_model(13));
    const auto clusters = make_clusters(model.geometry, model.geometry.triangles);

    std::uint32_t next = 0;
    for (const Cluster& cluster : clusters) {
        EXPECT_EQ(cluster.first, next);
        EXPECT_LE(cluster.triangles, kMostOfCluster);
        next += cluster.triangles;
        const PartRange& part = model.geometry.parts[cluster.part];
        EXPECT_GE(cluster.first, part.first_triangle);
        EXPECT_LE(next, part.first_triangle + part.triangles);
    }
    EXPECT_EQ(next, model.geometry.triangles.size());
}

TEST(Clusters, of_a_thin_wall_face_one_way_however_its_elements_are_numbered) {
    // A thin plate whose front and back are listed in turn, in parts of two plates.
    SmallModel model = box_model({1, 1, 0.01F}, 30);
    auto& triangles = model.geometry.triangles;
    const std::size_t side = triangles.size() / 6;
    std::vector<std::array<std::uint32_t, 3>> mixed;
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t k = 0; k < 6; ++k) mixed.push_back(triangles[(i * 7 + k) % side + k * side]);
    triangles = mixed;
    append(model, SmallModel(model));

    const auto ordered = clustered_order(model.geometry, triangles);
    const auto cones = [&](Triangles list) {
        const auto clusters = make_clusters(model.geometry, list);
        return std::ranges::count_if(clusters, [](const Cluster& cluster) { return cluster.spread < 0.1F; });
    };
    EXPECT_EQ(cones(triangles), 0);
    EXPECT_GT(cones(ordered), static_cast<std::ptrdiff_t>(triangles.size() / kMostOfCluster));
    auto once = ordered, given = triangles;
    std::ranges::sort(once);
    std::ranges::sort(given);
    EXPECT_EQ(once, given);
    for (std::size_t t = 0; t < ordered.size(); ++t)
        EXPECT_EQ(ordered[t][0] >= model.geometry.parts[1].first_vertex, t >= ordered.size() / 2);
}

TEST(Clusters, spheres_and_cones_hold_what_is_in_them) {
    const SmallModel model = ball_model(50);
    const Geometry& geometry = model.geometry;
    int narrow = 0;
    for (const Cluster& cluster : make_clusters(geometry, geometry.triangles)) {
        for (std::uint32_t t = cluster.first; t < cluster.first + cluster.triangles; ++t) {
            const auto& [a, b, c] = geometry.triangles[t];
            for (const std::uint32_t v : {a, b, c})
                EXPECT_LE(glm::distance(at(geometry, v), cluster.centre), cluster.radius);
            const glm::vec3 across =
                glm::cross(at(geometry, b) - at(geometry, a), at(geometry, c) - at(geometry, a));
            if (cluster.spread > 1 || glm::length(across) < 1e-7F) continue;
            const float cosine = glm::dot(glm::normalize(across), cluster.axis);
            EXPECT_GE(cosine * cosine + cluster.spread * cluster.spread, 1 - 1e-4F);
            EXPECT_GT(cosine, 0);
        }
        narrow += cluster.spread < 0.9F;
    }
    EXPECT_GT(narrow, 20);
}

TEST(Clusters, are_left_out_only_when_every_triangle_turns_away_or_stands_outside) {
    const SmallModel model = ball_model(40);
    const Geometry& geometry = model.geometry;
    const auto clusters = make_clusters(geometry, geometry.triangles);
    int away = 0, outside = 0;
    for (const glm::vec3 eye : {glm::vec3(0, 0, 3), glm::vec3(1.2F, 0.8F, 0.5F), glm::vec3(-4, 9, 1)}) {
        const glm::mat4 view = glm::lookAt(eye, glm::vec3(0.3F, 0, 0), glm::vec3(0, 1, 0.1F));
        const glm::mat4 clip = glm::perspective(0.5F, 1.3F, 0.1F, 20.0F) * view;
        const SeenFrom seen = seen_from(clip, view);
        EXPECT_LT(glm::distance(seen.eye, eye), 1e-4F);
        for (const Cluster& cluster : clusters) {
            const bool is_away = is_turned_away(seen, cluster),
                       is_out = is_outside(seen, cluster.centre, cluster.radius);
            away += is_away;
            outside += is_out;
            for (std::uint32_t t = cluster.first; t < cluster.first + cluster.triangles; ++t) {
                const auto& [a, b, c] = geometry.triangles[t];
                const glm::vec3 across =
                    glm::cross(at(geometry, b) - at(geometry, a), at(geometry, c) - at(geometry, a));
                if (is_away) {
                    EXPECT_LE(glm::dot(across, eye - at(geometry, a)), 1e-6F);
                }
                if (!is_out) continue;
                for (const std::uint32_t v : {a, b, c}) {
                    const glm::vec4 p = clip * glm::vec4(at(geometry, v), 1);
                    EXPECT_TRUE(std::abs(p.x) > p.w || std::abs(p.y) > p.w || std::abs(p.z) > p.w);
                }
            }
        }
    }
    EXPECT_GT(away, 20);
    EXPECT_GT(outside, 10);
}

TEST(Clusters, hold_what_they_hold_also_when_it_is_moved) {
    const SmallModel model = ball_model(20);
    const Geometry& geometry = model.geometry;
    std::vector<float> vectors;
    for (const auto& [x, y, z] : geometry.positions) vectors.insert(vectors.end(), {y * y, 3 * x, x * z - y});
    vectors[7] = std::numeric_limits<float>::quiet_NaN();
    const auto clusters = make_clusters(geometry, geometry.triangles);
    const auto moves = cluster_moves(geometry.triangles, clusters, vectors);

    ASSERT_EQ(moves.size(), clusters.size());
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const Cluster& cluster = clusters[i];
        for (std::uint32_t t = cluster.first; t < cluster.first + cluster.triangles; ++t) {
            for (const std::uint32_t v : geometry.triangles[t]) {
                const std::size_t at_vector = 3 * std::size_t{v};
                const glm::vec3 move(
                    vectors[at_vector], at_vector == 6 ? 0 : vectors[at_vector + 1], vectors[at_vector + 2]
                );
                EXPECT_LE(glm::distance(move, moves[i].middle), moves[i].radius + 1e-6F);
            }
        }
        // Far enough to be out of sight with the radius at rest, but not with what the shape adds to it.
        const glm::mat4 view = glm::translate(glm::mat4(1), -(cluster.centre + 2.0F * moves[i].middle));
        const float side = cluster.radius + moves[i].radius;
        const SeenFrom seen = seen_from(glm::ortho(side, side + 9, -9.0F, 9.0F, -9.0F, 9.0F) * view, view);
        const VisibleQuestion question{
            .clusters = {&cluster, 1}, .moves = {&moves[i], 1}, .factor = 2, .eyes = {&seen, 1}};
        EXPECT_EQ(find_visible(question).culled, moves[i].radius > 1e-4F ? 0U : 1U);
    }
}

TEST(Clusters, neighbours_that_are_seen_become_one_command) {
    SmallModel model = box_model({1, 1, 1}, 10);
    append(model, SmallModel(model));
    const auto clusters = make_clusters(model.geometry, model.geometry.triangles);
    VisibleQuestion question{.clusters = clusters, .is_culled = false, .instances = 2};

    const Visible all = find_visible(question);
    ASSERT_EQ(all.commands.size(), 2U);
    EXPECT_EQ(all.commands[1].part, 1U);
    EXPECT_EQ(all.commands[1].first, 3 * model.geometry.parts[1].first_triangle);
    EXPECT_EQ(all.commands[1].count, 3 * model.geometry.parts[1].triangles);
    EXPECT_EQ(all.commands[1].instances, 2U);
    EXPECT_EQ(all.triangles, model.geometry.triangles.size());
}

bool is_closed(const Geometry& geometry) {
    std::uint64_t sum = 0;
    for (const std::uint64_t part : open_edges(geometry)) sum += part;
    return sum == 0;
}

TEST(Closed, surfaces_are_told_from_open_ones_and_from_ones_with_a_turned_triangle) {
    SmallModel model = box_model({1, 1, 1}, 3);
    EXPECT_TRUE(is_closed(model.geometry));
    EXPECT_TRUE(is_closed(ball_model(12).geometry));

    std::swap(model.geometry.triangles[7][0], model.geometry.triangles[7][1]);
    EXPECT_FALSE(is_closed(model.geometry));
    std::swap(model.geometry.triangles[7][0], model.geometry.triangles[7][1]);
    --model.geometry.parts[0].triangles;
    EXPECT_FALSE(is_closed(model.geometry));
}

TEST(Closed, parts_that_share_a_side_are_closed_together_and_open_alone) {
    // A ball in two parts: its upper and its lower half.
    SmallModel model = ball_model(12);
    Geometry& g = model.geometry;
    PartRange upper = g.parts[0], lower = g.parts[0];
    upper.triangles = lower.first_triangle = upper.triangles / 2;
    lower.triangles -= upper.triangles;
    g.parts = {upper, lower};

    const auto sums = open_edges(g);
    EXPECT_NE(sums[0], 0U);
    EXPECT_NE(sums[1], 0U);
    EXPECT_EQ(sums[0] + sums[1], 0U);
}

TEST(FeatureEdges, are_a_boxs_twelve_sides_and_the_rim_of_a_hole) {
    SmallModel model = box_model({1, 1, 1}, 4);
    EXPECT_EQ(feature_edges(model.geometry, model.geometry.parts[0]).size(), 12U * 4);
    EXPECT_FLOAT_EQ(typical_edge(model.geometry), 0.25F);

    // Without one square in the middle of a side.
    auto& triangles = model.geometry.triangles;
    triangles.erase(triangles.begin() + 2 * 5, triangles.begin() + 2 * 5 + 2);
    model.geometry.parts[0].triangles -= 2;
    EXPECT_EQ(feature_edges(model.geometry, model.geometry.parts[0]).size(), 12U * 4 + 4);
}

}  // namespace
}  // namespace feelem::viewer::tests
