// SPDX-License-Identifier: Apache-2.0
// A turntable: turn about the world's up axis, zoom to a point, pan in the plane of the window.
#include "viewer/desktop/camera.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

constexpr float kHalfTurn = std::numbers::pi_v<float> / 2;
/// Room left round the model.
constexpr float kMargin = 1.12F;
/// Of the radius of what was fitted.
constexpr float kNearest = 0.01F, kFurthest = 60;
constexpr float kSmallestRadius = 1e-9F;

glm::quat orientation_of(const DeskCamera& camera) {
    return glm::angleAxis(camera.yaw, glm::vec3(0, 1, 0)) * glm::angleAxis(-camera.pitch, glm::vec3(1, 0, 0));
}

float half_height(const DeskCamera& camera) {
    return std::tan(camera.height_angle / 2);
}

}  // namespace

Pose pose_of(const DeskCamera& camera) {
    const glm::quat orientation = orientation_of(camera);
    return {camera.target + orientation * glm::vec3(0, 0, camera.distance), orientation};
}

FieldOfView field_of(const DeskCamera& camera, float aspect) {
    const float up = camera.height_angle / 2;
    const float right = std::atan(half_height(camera) * aspect);
    return {.left = -right, .right = right, .up = up, .down = -up};
}

DepthRange depth_of(const DeskCamera& camera) {
    const float near =
        std::max({camera.distance - 3 * camera.radius, camera.distance * 0.01F, camera.radius * 1e-4F});
    return {near, camera.distance + 4 * camera.radius};
}

Ray ray_at(const DeskCamera& camera, glm::vec2 place, float aspect) {
    const float high = half_height(camera);
    const glm::vec3 ahead((2 * place.x - 1) * high * aspect, (1 - 2 * place.y) * high, -1);
    const Pose pose = pose_of(camera);
    return {pose.position, glm::normalize(pose.orientation * ahead)};
}

std::optional<glm::vec2> place_of(const DeskCamera& camera, const glm::vec3& point, float aspect) {
    const Pose pose = pose_of(camera);
    const glm::vec3 seen = glm::conjugate(pose.orientation) * (point - pose.position);
    if (!(seen.z < 0)) return std::nullopt;
    const float high = -seen.z * half_height(camera);
    return glm::vec2((seen.x / (high * aspect) + 1) / 2, (1 - seen.y / high) / 2);
}

void turn(DeskCamera& camera, float radians_right, float radians_down) {
    camera.fitted.reset();
    camera.yaw -= radians_right;
    camera.pitch = std::clamp(camera.pitch + radians_down, -kHalfTurn, kHalfTurn);
}

void pan(DeskCamera& camera, glm::vec2 moved) {
    camera.fitted.reset();
    const float metres = 2 * camera.distance * half_height(camera);
    camera.target += orientation_of(camera) * glm::vec3(-moved.x * metres, moved.y * metres, 0);
}

void zoom(DeskCamera& camera, float scale, const std::optional<glm::vec3>& at) {
    camera.fitted.reset();
    const float next =
        std::clamp(camera.distance * scale, camera.radius * kNearest, camera.radius * kFurthest);
    const float share = next / camera.distance;
    if (at) camera.target = *at + (camera.target - *at) * share;
    camera.distance = next;
}

void fit(DeskCamera& camera, const WorldBox& box, float aspect) {
    camera.fitted = box;
    camera.radius = std::max(glm::length(box.high - box.low) / 2, kSmallestRadius);
    camera.target = (box.low + box.high) / 2.0F;
    const glm::quat back = glm::conjugate(orientation_of(camera));
    const float vertical = half_height(camera);
    float distance = camera.radius * 0.1F;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 place(
            (corner & 1) != 0 ? box.high.x : box.low.x,
            (corner & 2) != 0 ? box.high.y : box.low.y,
            (corner & 4) != 0 ? box.high.z : box.low.z
        );
        const glm::vec3 seen = back * (place - camera.target);
        const float reach =
            std::max(std::abs(seen.x) / (vertical * aspect), std::abs(seen.y) / vertical) * kMargin;
        distance = std::max(distance, reach + seen.z);
    }
    camera.distance = distance;
}

void go_home(DeskCamera& camera, const WorldBox& box, float aspect) {
    const DeskCamera first;
    camera.yaw = first.yaw;
    camera.pitch = first.pitch;
    fit(camera, box, aspect);
}

void look_from(DeskCamera& camera, const glm::vec3& direction) {
    const float length = glm::length(direction);
    if (!(length > 0)) return;
    const glm::vec3 from = direction / length;
    camera.pitch = std::asin(std::clamp(from.y, -1.0F, 1.0F));
    if (std::hypot(from.x, from.z) > 1e-6F) camera.yaw = std::atan2(from.x, from.z);
}

void view_from(
    DeskCamera& camera,
    const glm::vec3& direction,
    const glm::mat3& to_world,
    const WorldBox& box,
    float aspect
) {
    const auto towards = [&](const glm::vec3& axis) { return glm::normalize(to_world * axis); };
    if (direction == glm::vec3(0)) {
        go_home(camera, box, aspect);
        return;
    }
    const bool at_an_angle = direction == glm::vec3(1);
    look_from(
        camera, at_an_angle ? towards(glm::vec3(1, -1, 0)) + glm::vec3(0, 0.75F, 0) : towards(direction)
    );
    fit(camera, box, aspect);
}

void go_to(DeskCamera& camera, const glm::vec3& point, float distance) {
    camera.fitted.reset();
    camera.target = point;
    camera.distance = distance;
}

void reshaped(DeskCamera& camera, float aspect) {
    if (!camera.fitted) return;
    const WorldBox box = *camera.fitted;
    fit(camera, box, aspect);
}

}  // namespace feelem::viewer
