// SPDX-License-Identifier: Apache-2.0
// The desk's camera: a turntable, as web/src/render/orbit.ts. Plain data and pure functions.
#pragma once

#include "viewer/core/space.hpp"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <numbers>
#include <optional>

namespace feelem::viewer {

/// World metres.
struct WorldBox {
    glm::vec3 low{-0.5F}, high{0.5F};
};

struct DeskCamera {
    glm::vec3 target{0};
    float yaw = std::numbers::pi_v<float> / 5, pitch = 0.42F;  ///< Radians, about +Y and up from the floor.
    float distance = 1;
    float radius = 1;                                           ///< Of what was fitted last; limits the zoom.
    float height_angle = 30 * std::numbers::pi_v<float> / 180;  ///< Of the view, radians.
    std::optional<WorldBox> fitted;                             ///< While nobody has moved the camera since.
};

Pose pose_of(const DeskCamera& camera);
FieldOfView field_of(const DeskCamera& camera, float aspect);
/// `near` and `far` for projection_of.
struct DepthRange {
    float near = 0, far = 0;
};
DepthRange depth_of(const DeskCamera& camera);

/// Through a place of the window: fractions of its width and height from the upper left corner.
Ray ray_at(const DeskCamera& camera, glm::vec2 place, float aspect);
/// Where a world place is seen: fractions as ray_at takes them. Empty: behind the eye.
std::optional<glm::vec2> place_of(const DeskCamera& camera, const glm::vec3& point, float aspect);

void turn(DeskCamera& camera, float radians_right, float radians_down);
/// `moved`: fractions of the window's height, right and down; what lies at the target follows the pointer.
void pan(DeskCamera& camera, glm::vec2 moved);
/// Distance times `scale`. `at` (world) keeps its place in the window; empty: the target does.
void zoom(DeskCamera& camera, float scale, const std::optional<glm::vec3>& at);
/// The whole box fills the view; the direction stays.
void fit(DeskCamera& camera, const WorldBox& box, float aspect);
/// The first direction, and the whole box.
void go_home(DeskCamera& camera, const WorldBox& box, float aspect);
/// From this direction (world axes, any length), the target stays.
void look_from(DeskCamera& camera, const glm::vec3& direction);
/// The whole box, from a direction of the model's axes. (1, 1, 1): at an angle from above; (0, 0, 0): the
/// first one.
void view_from(
    DeskCamera& camera,
    const glm::vec3& direction,
    const glm::mat3& to_world,
    const WorldBox& box,
    float aspect
);
void go_to(DeskCamera& camera, const glm::vec3& point, float distance);
/// The window has another shape: what filled it fills it again.
void reshaped(DeskCamera& camera, float aspect);

}  // namespace feelem::viewer
