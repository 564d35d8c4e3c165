// SPDX-License-Identifier: Apache-2.0
// The desk's camera keeps what it promises: places under the pointer, whole boxes, directions.
#include "viewer/desktop/camera.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace feelem::viewer {
namespace {

constexpr float kWide = 1.6F;
const WorldBox kBox{{-0.4F, 0.6F, -1.5F}, {0.4F, 1.3F, -0.9F}};

DeskCamera looking_at_the_box() {
    DeskCamera camera;
    fit(camera, kBox, kWide);
    return camera;
}

glm::vec3 corner_of(const WorldBox& box, int corner) {
    return {
        (corner & 1) != 0 ? box.high.x : box.low.x,
        (corner & 2) != 0 ? box.high.y : box.low.y,
        (corner & 4) != 0 ? box.high.z : box.low.z};
}

TEST(DeskCamera, the_ray_through_a_place_meets_what_is_seen_there) {
    const DeskCamera camera = looking_at_the_box();
    for (const glm::vec2 place : {glm::vec2(0.5F, 0.5F), glm::vec2(0.1F, 0.9F), glm::vec2(0.83F, 0.21F)}) {
        const Ray ray = ray_at(camera, place, kWide);
        const auto back = place_of(camera, ray.origin + 2.5F * ray.direction, kWide);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->x, place.x, 1e-5F);
        EXPECT_NEAR(back->y, place.y, 1e-5F);
    }
    EXPECT_NEAR(glm::length(ray_at(camera, {0.5F, 0.5F}, kWide).direction), 1, 1e-6F);
}

TEST(DeskCamera, what_lies_behind_the_eye_is_nowhere_in_the_window) {
    const DeskCamera camera = looking_at_the_box();
    const Ray ray = ray_at(camera, {0.5F, 0.5F}, kWide);
    EXPECT_FALSE(place_of(camera, ray.origin - ray.direction, kWide));
}

TEST(DeskCamera, zoom_keeps_the_place_under_the_pointer) {
    for (const float scale : {0.5F, 0.83F, 1.2F, 3.0F}) {
        DeskCamera camera = looking_at_the_box();
        const glm::vec3 point(0.3F, 1.2F, -0.95F);
        const auto before = place_of(camera, point, kWide);
        zoom(camera, scale, point);
        const auto after = place_of(camera, point, kWide);
        ASSERT_TRUE(before && after);
        EXPECT_NEAR(after->x, before->x, 1e-5F);
        EXPECT_NEAR(after->y, before->y, 1e-5F);
        EXPECT_NEAR(
            glm::distance(pose_of(camera).position, point),
            scale * glm::distance(pose_of(looking_at_the_box()).position, point),
            1e-4F
        );
    }
}

TEST(DeskCamera, zoom_stops_before_the_model_is_lost) {
    DeskCamera camera = looking_at_the_box();
    for (int i = 0; i < 200; ++i) zoom(camera, 0.5F, std::nullopt);
    EXPECT_FLOAT_EQ(camera.distance, camera.radius * 0.01F);
    for (int i = 0; i < 200; ++i) zoom(camera, 2, std::nullopt);
    EXPECT_FLOAT_EQ(camera.distance, camera.radius * 60);
}

TEST(DeskCamera, fit_shows_all_corners_and_fills_the_window) {
    for (const float aspect : {0.4F, 1.0F, 2.4F}) {
        for (const glm::vec3 from : {glm::vec3(1, 0.3F, 1), glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0)}) {
            DeskCamera camera;
            look_from(camera, from);
            fit(camera, kBox, aspect);
            float widest = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const auto place = place_of(camera, corner_of(kBox, corner), aspect);
                ASSERT_TRUE(place);
                const glm::vec2 off = glm::abs(*place - 0.5F) * 2.0F;
                widest = std::max({widest, off.x, off.y});
            }
            EXPECT_LT(widest, 0.95F) << "a corner stands at the window's edge";
            EXPECT_GT(widest, 0.85F) << "the model could be larger";
        }
    }
}

TEST(DeskCamera, what_filled_the_window_fills_another_shape_until_somebody_moves_it) {
    DeskCamera camera = looking_at_the_box();
    reshaped(camera, 0.5F);
    DeskCamera fitted = looking_at_the_box();
    fit(fitted, kBox, 0.5F);
    EXPECT_FLOAT_EQ(camera.distance, fitted.distance);
    turn(camera, 0.1F, 0);
    const float distance = camera.distance;
    reshaped(camera, 2);
    EXPECT_FLOAT_EQ(camera.distance, distance);
}

TEST(DeskCamera, what_lies_at_the_target_follows_the_pointer_that_pans) {
    DeskCamera camera = looking_at_the_box();
    const glm::vec3 point = camera.target;
    pan(camera, {0.2F, -0.1F});
    const auto place = place_of(camera, point, kWide);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 0.5F + 0.2F / kWide, 1e-5F);
    EXPECT_NEAR(place->y, 0.4F, 1e-5F);
}

TEST(DeskCamera, turning_keeps_the_target_in_the_middle_and_stops_at_the_poles) {
    DeskCamera camera = looking_at_the_box();
    turn(camera, 1, 9);
    EXPECT_NEAR((pose_of(camera).orientation * glm::vec3(0, 0, 1)).y, 1, 1e-5F);
    const auto place = place_of(camera, camera.target, kWide);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 0.5F, 1e-5F);
    EXPECT_NEAR(place->y, 0.5F, 1e-5F);
}

TEST(DeskCamera, turning_to_the_right_brings_the_left_side_into_sight) {
    DeskCamera camera;
    look_from(camera, {0, 0, 1});
    turn(camera, 0.3F, 0);
    EXPECT_LT(pose_of(camera).position.x, camera.target.x);
    turn(camera, 0, 0.3F);
    EXPECT_GT(pose_of(camera).position.y, camera.target.y);
}

TEST(DeskCamera, looks_from_where_it_is_told) {
    DeskCamera camera = looking_at_the_box();
    for (const glm::vec3 from : {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(-1, 2, 0.5F)}) {
        look_from(camera, from);
        const glm::vec3 away = pose_of(camera).orientation * glm::vec3(0, 0, 1);
        EXPECT_NEAR(glm::dot(away, glm::normalize(from)), 1, 1e-5F);
    }
    const float yaw = camera.yaw;
    look_from(camera, {0, 0, 0});
    EXPECT_EQ(camera.yaw, yaw) << "no direction is no wish";
}

TEST(DeskCamera, views_are_along_the_models_own_axes) {
    // The solver's z is up: it becomes the world's y, x stays, y goes into the room.
    const glm::mat3 to_world(glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), glm::vec3(0, 1, 0));
    DeskCamera camera;
    view_from(camera, {0, 0, 1}, 1000.0F * to_world, kBox, kWide);
    EXPECT_NEAR((pose_of(camera).orientation * glm::vec3(0, 0, 1)).y, 1, 1e-5F);
    view_from(camera, {0, 1, 0}, to_world, kBox, kWide);
    EXPECT_NEAR((pose_of(camera).orientation * glm::vec3(0, 0, 1)).z, -1, 1e-5F);
    view_from(camera, {1, 1, 1}, to_world, kBox, kWide);
    const glm::vec3 away = pose_of(camera).orientation * glm::vec3(0, 0, 1);
    EXPECT_GT(away.x, 0.3F);
    EXPECT_GT(away.y, 0.3F) << "from above";
    EXPECT_GT(away.z, 0.3F);
    view_from(camera, {0, 0, 0}, to_world, kBox, kWide);
    EXPECT_FLOAT_EQ(camera.yaw, DeskCamera{}.yaw);
}

TEST(DeskCamera, field_of_view_is_as_wide_as_the_window) {
    DeskCamera camera;
    const FieldOfView field = field_of(camera, 2);
    EXPECT_FLOAT_EQ(std::tan(field.right) / std::tan(field.up), 2);
    EXPECT_FLOAT_EQ(field.left, -field.right);
    EXPECT_FLOAT_EQ(field.down, -field.up);
}

TEST(DeskCamera, depth_holds_the_whole_model_from_near_and_far) {
    DeskCamera camera = looking_at_the_box();
    for (const float scale : {0.02F, 1.0F, 20.0F}) {
        DeskCamera moved = camera;
        zoom(moved, scale, std::nullopt);
        const DepthRange depth = depth_of(moved);
        EXPECT_GT(depth.near, 0);
        EXPECT_LE(depth.near, std::max(moved.distance - moved.radius, moved.distance * 0.01F) * 1.0001F);
        EXPECT_GE(depth.far, moved.distance + moved.radius);
    }
}

}  // namespace
}  // namespace feelem::viewer
