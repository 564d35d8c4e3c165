// SPDX-License-Identifier: Apache-2.0
// The camera of the desk: turns about the world's up axis, zooms to a point, moves in the picture's plane.
// The model stands where a headset finds it too, so that both see the same room.
#pragma once

#include "viewer/core/space.hpp"

#include <glm/vec2.hpp>

#include <array>

namespace feelem::viewer {

struct DeskCamera {
    glm::vec3 target{0, 1, -1.2F};
    float yaw = 0.628318531F, pitch = 0.42F;  ///< Radians.
    float distance = 1.5F;                    ///< Metres from the target.
    float height = 0.785398163F;              ///< Angle of view from bottom to top, radians.
    float aspect = 1.6F;  ///< Width of the window by its height: whoever has the window sets it.
    float radius = 0.5F;  ///< Of what was fitted last: bounds zoom, near and far.
};

/// What FrameInput::head is at the desk.
Pose pose_of(const DeskCamera& camera);
FieldOfView field_of(const DeskCamera& camera);
/// Nearest and furthest distance that is drawn, metres.
std::array<float, 2> range_of(const DeskCamera& camera);
/// The ray through a place of the window: 0 0 its top left corner, 1 1 its bottom right one.
Ray ray_through(const DeskCamera& camera, glm::vec2 at);

/// Radians.
void turn(DeskCamera& camera, float right, float up);
/// Fractions of the window's height, y down.
void pan(DeskCamera& camera, glm::vec2 by);
/// `at` keeps its place in the picture; empty: the target does.
void zoom(DeskCamera& camera, float scale, const glm::vec3* at);
/// The box (world, metres) fills the view, the direction stays.
void fit(DeskCamera& camera, const glm::vec3& low, const glm::vec3& high);

}  // namespace feelem::viewer
