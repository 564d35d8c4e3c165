// SPDX-License-Identifier: Apache-2.0
// What is read where the model is pointed at: as feelem::probe() reads it, on the shape that is drawn.
#include "viewer/core/moving_tree.hpp"
#include "viewer/core/scene_in_memory.hpp"

#include "feelem/probe.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <random>

namespace feelem::viewer::test {
namespace {

/// Rays from a sphere round the box towards places in it; always the same.
std::vector<Ray> rays_at(const ViewedModel& model, std::size_t count) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> share(0, 1);
    const auto &low = model.arrays().low, &high = model.arrays().high;
    const glm::vec3 from(low[0], low[1], low[2]), size = glm::vec3(high[0], high[1], high[2]) - from;
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const float up = 2 * share(random) - 1, turn = 2 * std::numbers::pi_v<float> * share(random);
        const float flat = std::sqrt(1 - up * up);
        const glm::vec3 away(flat * std::cos(turn), flat * std::sin(turn), up);
        const glm::vec3 at = from + size * glm::vec3(share(random), share(random), share(random));
        const glm::vec3 eye = from + size / 2.0F + 2 * glm::length(size) * away;
        rays.push_back({eye, glm::normalize(at - eye)});
    }
    return rays;
}

ProbeQuery asked(const Scene& scene, const Ray& ray) {
    ProbeQuery query;
    query.ray.emplace();
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<int>(k);
        (*query.ray)[k] = static_cast<double>(ray.origin[axis]) + scene.origin[k];
        (*query.ray)[3 + k] = static_cast<double>(ray.direction[axis]);
    }
    return query;
}

void expect_same_place(const Probed& ours, const ProbedPlace& theirs) {
    EXPECT_EQ(ours.element_id, theirs.element_id);
    EXPECT_EQ(ours.node_id, theirs.node_id);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(ours.model[k], theirs.point[k], 1e-9);
    ASSERT_LE(ours.readings.size(), theirs.results.size());
    for (std::size_t i = 0; i < ours.readings.size(); ++i) {
        const Reading& mine = ours.readings[i];
        const ProbedValue& other = theirs.results[i];
        EXPECT_EQ(mine.key, other.key);
        EXPECT_EQ(mine.state, other.state);
        ASSERT_EQ(mine.node_value.has_value(), other.node_value.has_value());
        if (mine.node_value) {
            EXPECT_EQ(
                std::bit_cast<std::uint32_t>(*mine.node_value),
                std::bit_cast<std::uint32_t>(*other.node_value)
            );
        }
        ASSERT_EQ(!std::isnan(mine.value), other.value.has_value());
        if (other.value) {
            EXPECT_NEAR(mine.value, *other.value, 1e-11 * (1 + std::abs(*other.value)));
        }
    }
}

TEST(Probe, rays_at_the_boiler_read_what_feelem_probe_reads) {
    Ready ready(boiler_path());
    ready.viewer.state.deformation = Deformation::None;
    ready.show();
    std::size_t hits = 0;
    for (const Ray& ray : rays_at(ready.viewer.model, 250)) {
        const Cast cast = ready.viewer.prober.cast(ray);
        const auto places = feelem::probe(ready.memory.scene(), asked(ready.memory.scene(), ray));
        ASSERT_EQ(cast.hit.has_value(), !places.empty());
        if (!cast.hit) continue;
        ++hits;
        expect_same_place(read_place(ready.viewer.state, ready.viewer.model, *cast.hit), places.front());
        EXPECT_NEAR(cast.hit->distance, places.front().distance, 1e-6 * places.front().distance);
    }
    EXPECT_GT(hits, 80u);
}

TEST(Probe, a_tip_near_the_skin_reads_what_feelem_probe_reads_at_the_nearest_place) {
    Ready ready(boiler_path());
    ready.viewer.state.deformation = Deformation::None;
    ready.show();
    std::size_t near = 0;
    for (const Ray& ray : rays_at(ready.viewer.model, 100)) {
        const Cast cast = ready.viewer.prober.cast(ray);
        if (!cast.hit) continue;
        const glm::vec3 tip = cast.hit->world - 2.0F * ray.direction;
        const auto hit = ready.viewer.prober.near(tip, 3);
        ASSERT_TRUE(hit);
        EXPECT_FALSE(ready.viewer.prober.near(tip, 0.9F * static_cast<float>(hit->distance)));
        ProbeQuery query;
        query.point = Point3{};
        for (std::size_t k = 0; k < 3; ++k) {
            (*query.point)[k] =
                static_cast<double>(tip[static_cast<int>(k)]) + ready.memory.scene().origin[k];
        }
        const auto places = feelem::probe(ready.memory.scene(), query);
        ASSERT_EQ(places.size(), 1u);
        expect_same_place(read_place(ready.viewer.state, ready.viewer.model, *hit), places.front());
        ++near;
    }
    EXPECT_GT(near, 20u);
}

TEST(Probe, a_model_that_is_carried_and_scaled_reads_the_same_element_at_the_same_place) {
    Ready ready(boiler_path());
    ready.viewer.state.deformation = Deformation::None;
    ready.show();
    const std::vector<Ray> rays = rays_at(ready.viewer.model, 60);
    std::vector<Cast> before;
    for (const Ray& ray : rays) before.push_back(ready.viewer.prober.cast(ray));
    glm::mat4 placement = glm::translate(glm::mat4(1), glm::vec3(0.3F, 1, -1.2F));
    placement = glm::rotate(placement, 0.7F, glm::vec3(0, 1, 0));
    placement = glm::scale(placement, glm::vec3(0.001F));
    ready.viewer.state.placement = placement;
    ready.show();
    std::size_t same = 0, hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const glm::vec3 from(placement * glm::vec4(rays[i].origin, 1));
        const Ray moved{from, glm::normalize(glm::mat3(placement) * rays[i].direction)};
        const Cast cast = ready.viewer.prober.cast(moved);
        if (!before[i].hit || !cast.hit) continue;
        ++hits;
        if (before[i].hit->triangle == cast.hit->triangle) ++same;
        EXPECT_NEAR(glm::distance(cast.hit->world, from), cast.hit->distance, 1e-5);
    }
    EXPECT_GT(hits, 15u);
    // A ray between two triangles may change sides by what float32 rounds away.
    EXPECT_GE(same + 1, hits);
}

/// The same triangles, moved for good.
std::vector<Vertex3> bent(const ModelArrays& arrays, std::span<const float> by, float factor) {
    std::vector<Vertex3> out(arrays.positions.begin(), arrays.positions.end());
    for (std::size_t i = 0; i < out.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const float along = by[3 * i + k];
            if (!std::isnan(along)) out[i][k] += factor * along;
        }
    }
    return out;
}

TEST(Probe, a_swinging_shape_is_met_where_it_is_drawn) {
    Ready ready(boiler_path());
    const ModelArrays& arrays = ready.viewer.model.arrays();
    const auto shape = shape_field(ready.viewer.state, ready.viewer.model);
    ASSERT_TRUE(shape);
    const FieldSpan by = ready.viewer.model.values(*shape);
    const auto part_triangles = arrays.triangles.subspan(0, arrays.parts[0].triangles);
    MovingTree tree(arrays.positions, part_triangles);
    std::size_t hits = 0;
    const auto factor_of_picture =
        static_cast<float>(automatic_factor(ready.viewer.state, ready.viewer.model));
    for (const float swing : {1.0F, -0.5F, 4.0F}) {
        const float factor = swing * factor_of_picture;
        tree.set_shape({Swing{by.values, static_cast<double>(factor)}, Swing{}});
        const std::vector<Vertex3> positions = bent(arrays, by.values, factor);
        const Picker picker(positions, part_triangles);
        for (const Ray& ray : rays_at(ready.viewer.model, 100)) {
            const std::array<double, 3> origin{ray.origin.x, ray.origin.y, ray.origin.z};
            const std::array<double, 3> along{ray.direction.x, ray.direction.y, ray.direction.z};
            const double length = std::sqrt(pick::dot(along, along));
            const auto moving =
                tree.ray(origin, {along[0] / length, along[1] / length, along[2] / length}, 1e9);
            const auto still = picker.ray(origin, along);
            ASSERT_EQ(moving.has_value(), still.has_value());
            if (!moving) continue;
            ++hits;
            EXPECT_NEAR(moving->distance, still->distance, 1e-3);
        }
    }
    EXPECT_GT(hits, 80u);
}

TEST(Probe, a_deformed_square_is_hit_at_its_new_height_and_reads_the_same_value) {
    Scene scene = two_squares();
    scene.parts.pop_back();
    add_result_to(scene, "temperature", {"value"}, {{10, 20, 30, 40}});
    add_result_to(scene, "displacement", {"x", "y", "z"}, {{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}});
    scene.presentation.results = {
        presented("T", "temperature", "value"), presented("U", "displacement", "z")};
    scene.presentation.deformation_result = "U";
    Ready ready(scene);
    ready.viewer.state.deformation = Deformation::Typed;
    ready.viewer.state.typed_factor = 2;
    ready.show();
    const Cast cast = ready.viewer.prober.cast(down_at(0.75F, 0.25F));
    ASSERT_TRUE(cast.hit);
    EXPECT_NEAR(cast.hit->distance, 3, 1e-6);
    EXPECT_NEAR(cast.hit->world.z, 2, 1e-6);
    const Probed probed = read_place(ready.viewer.state, ready.viewer.model, *cast.hit);
    // On triangle 0 1 2: T = 10 + 10 x + 10 y.
    EXPECT_NEAR(probed.readings.at(0).value, 20, 1e-9);
    EXPECT_EQ(probed.model[2], 0) << "the place is that of the undeformed model";
}

TEST(Probe, hidden_parts_are_passed_and_clear_ones_too_where_something_is_behind) {
    Ready ready(two_squares());
    const auto distance = [&] { return ready.viewer.prober.cast(down_at(0.4F, 0.3F)).hit->distance; };
    EXPECT_NEAR(distance(), 5, 1e-6);
    set_part(ready.viewer.state, 0, PartLook::Clear);
    ready.show();
    EXPECT_NEAR(distance(), 6, 1e-6);
    set_part(ready.viewer.state, 1, PartLook::Hidden);
    ready.show();
    EXPECT_NEAR(distance(), 5, 1e-6) << "a clear part alone is pointed at";
    set_part(ready.viewer.state, 0, PartLook::Hidden);
    ready.show();
    EXPECT_FALSE(ready.viewer.prober.cast(down_at(0.4F, 0.3F)).hit);
}

TEST(Probe, what_a_plane_cuts_away_is_not_met) {
    Ready ready(two_squares());
    ready.viewer.state.cuts = {{{{0, 0, 1}, -0.5F}, true}};
    ready.show();
    const Cast cast = ready.viewer.prober.cast(down_at(0.4F, 0.3F));
    ASSERT_TRUE(cast.hit);
    EXPECT_NEAR(cast.hit->distance, 6, 1e-6);
    EXPECT_FALSE(ready.viewer.prober.near({0.4F, 0.3F, 0.1F}, 0.5F)) << "the nearer square is gone";
    EXPECT_TRUE(ready.viewer.prober.near({0.4F, 0.3F, -0.9F}, 0.5F));
    ready.viewer.state.cuts[0].on = false;
    ready.show();
    EXPECT_NEAR(ready.viewer.prober.cast(down_at(0.4F, 0.3F)).hit->distance, 5, 1e-6);
}

TEST(Probe, material_that_a_plane_opens_has_no_value) {
    Scene solid = two_squares("solid");
    // The lower square is the bottom of a solid: seen from above it shows its inner side.
    for (auto& triangle : solid.parts[1].triangles) std::swap(triangle[1], triangle[2]);
    Ready ready(std::move(solid));
    ready.viewer.state.cuts = {{{{0, 0, 1}, -0.5F}, true}};
    ready.show();
    const Cast cast = ready.viewer.prober.cast(down_at(0.4F, 0.3F));
    EXPECT_FALSE(cast.hit);
    ASSERT_TRUE(cast.inside);
    EXPECT_NEAR(cast.inside->z, -0.5, 1e-6);
}

TEST(Probe, a_corner_without_value_makes_the_place_missing_and_keeps_the_nodes_own_value) {
    Scene scene = two_squares();
    scene.parts.pop_back();
    add_result_to(scene, "temperature", {"value"}, {{10, 20, std::nanf(""), 40}});
    scene.presentation.results = {presented("T", "temperature", "value")};
    Ready ready(scene);
    const Probed probed = read_place(
        ready.viewer.state, ready.viewer.model, *ready.viewer.prober.cast(down_at(0.9F, 0.02F)).hit
    );
    EXPECT_EQ(probed.node_id, 2);
    EXPECT_EQ(probed.readings.at(0).state, "missing");
    EXPECT_TRUE(std::isnan(probed.readings.at(0).value));
    EXPECT_TRUE(probed.readings.at(0).at.missing);
    EXPECT_EQ(probed.readings.at(0).node_value, 20.0F);
}

TEST(Probe, rays_miss_until_the_hierarchies_are_grown) {
    SceneInMemory memory(two_squares());
    const ViewedModel model(memory.source());
    Prober prober(model);
    prober.set_look({});
    EXPECT_FALSE(prober.cast(down_at(0.4F, 0.3F)).hit);
    EXPECT_FALSE(prober.near({0.4F, 0.3F, 0}, 1));
    prober.grow();
    EXPECT_TRUE(prober.cast(down_at(0.4F, 0.3F)).hit);
    const float nan = std::nanf("");
    EXPECT_FALSE(prober.cast({{nan, 0, 0}, {0, 0, -1}}).hit);
    EXPECT_FALSE(prober.cast({{0, 0, 5}, {0, 0, 0}}).hit);
}

}  // namespace
}  // namespace feelem::viewer::test
