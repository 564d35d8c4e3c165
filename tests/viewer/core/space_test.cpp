// SPDX-License-Identifier: Apache-2.0
// The projection of an eye.
#include "viewer/core/space.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace feelem::viewer {
namespace {

TEST(Space, edges_of_a_lopsided_field_of_view_land_on_the_edges_of_the_picture) {
    const FieldOfView field{-0.9F, 0.7F, 0.8F, -0.6F};
    const glm::mat4 projection = projection_of(field, 0.05F, 100.0F);
    const auto seen_at = [&](float right, float up) {
        const glm::vec4 clip = projection * glm::vec4(2 * std::tan(right), 2 * std::tan(up), -2, 1);
        return glm::vec2(clip) / clip.w;
    };
    EXPECT_NEAR(seen_at(field.left, 0).x, -1, 1e-6);
    EXPECT_NEAR(seen_at(field.right, 0).x, 1, 1e-6);
    EXPECT_NEAR(seen_at(0, field.up).y, 1, 1e-6);
    EXPECT_NEAR(seen_at(0, field.down).y, -1, 1e-6);
}

TEST(Space, a_ray_leaves_a_pose_ahead_of_it) {
    const Pose turned_left{{1, 2, 3}, glm::angleAxis(glm::half_pi<float>(), glm::vec3(0, 1, 0))};
    const Ray ray = ray_of(turned_left);
    EXPECT_NEAR(ray.direction.x, -1, 1e-6);
    EXPECT_EQ(ray.origin, glm::vec3(1, 2, 3));
    const glm::vec4 one_ahead = matrix_of(turned_left) * glm::vec4(0, 0, -1, 1);
    EXPECT_NEAR(one_ahead.x, 0, 1e-6);
    EXPECT_NEAR(one_ahead.z, 3, 1e-6);
}

}  // namespace
}  // namespace feelem::viewer
