// SPDX-License-Identifier: Apache-2.0
// The handles of the model: the bar under it, and a knob at the middle of each cutting plane.
#include "viewer/core/handles.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

constexpr float kBarLength = 0.2F;
constexpr float kBarBelow = 0.05F, kBarAhead = 0.04F;
/// No nearer to the person, and never under the floor.
constexpr float kBarArm = 0.5F, kBarLowest = 0.15F;

glm::vec3 box_middle(const ModelArrays& arrays) {
    const auto &low = arrays.low, &high = arrays.high;
    return (glm::vec3(low[0], low[1], low[2]) + glm::vec3(high[0], high[1], high[2])) / 2.0F;
}

glm::vec3 at_world(const glm::mat4& matrix, const glm::vec3& place) {
    return glm::vec3(matrix * glm::vec4(place, 1));
}

}  // namespace

std::array<glm::vec3, 2> bar_of(const ViewerState& state, const ViewedModel& model, const glm::vec3& eye) {
    const ModelArrays& arrays = model.arrays();
    const glm::mat4 to_world = model_to_world(state, model);
    glm::vec3 at = at_world(to_world, box_middle(arrays));
    glm::vec3 towards = eye - at;
    towards.y = 0;
    const float far = glm::length(towards);
    towards = far > 1e-6F ? towards / far : glm::vec3(0, 0, 1);
    float lowest = std::numeric_limits<float>::infinity(), nearer = 0;
    for (unsigned i = 0; i < 8; ++i) {
        glm::vec3 corner(0);
        for (std::size_t k = 0; k < 3; ++k) {
            corner[static_cast<int>(k)] = ((i >> k) & 1U) != 0 ? arrays.high[k] : arrays.low[k];
        }
        corner = at_world(to_world, corner);
        lowest = std::min(lowest, corner.y);
        nearer = std::max(nearer, glm::dot(corner - at, towards));
    }
    // A model round the person is taken by its near side, an arm's length away.
    at += towards * std::min(nearer + kBarAhead, std::max(far - kBarArm, 0.0F));
    at.y = std::max(lowest - kBarBelow, kBarLowest);
    const glm::vec3 half = glm::cross(glm::vec3(0, 1, 0), towards) * (kBarLength / 2);
    return {at - half, at + half};
}

std::vector<std::optional<glm::vec3>> knobs_of(const ViewerState& state, const ViewedModel& model) {
    const glm::vec3 middle = box_middle(model.arrays());
    const glm::mat4 to_world = model_to_world(state, model);
    std::vector<std::optional<glm::vec3>> knobs;
    for (const CutState& cut : state.cuts) {
        knobs.emplace_back();
        if (!cut.on) continue;
        const glm::vec3& normal = cut.plane.normal;
        knobs.back() = at_world(to_world, middle + normal * (cut.plane.offset - glm::dot(normal, middle)));
    }
    return knobs;
}

float knob_reach(const Ray& ray, const glm::vec3& knob, bool is_mouse) {
    constexpr float kAngle = 0.02F, kLeast = 0.1F;
    return is_mouse ? kAngle * std::max(glm::distance(ray.origin, knob), kLeast) : kKnobNear;
}

float distance_to_ray(const Ray& ray, const glm::vec3& place) {
    const float along = std::max(glm::dot(place - ray.origin, ray.direction), 0.0F);
    return glm::distance(place, ray.origin + along * ray.direction);
}

std::optional<float> meet_bar(const Ray& ray, const std::array<glm::vec3, 2>& bar) {
    // The bar is short: a few of its places are as good as the nearest one.
    constexpr int kPlaces = 20;
    float nearest = kBarNear;
    std::optional<float> along;
    for (int i = 0; i <= kPlaces; ++i) {
        const glm::vec3 place = glm::mix(bar[0], bar[1], static_cast<float>(i) / kPlaces);
        const float apart = distance_to_ray(ray, place);
        if (apart >= nearest) continue;
        nearest = apart;
        along = glm::distance(place, ray.origin);
    }
    return along;
}

float along_normal(const Ray& ray, const ViewerState& state, const ViewedModel& model, std::size_t cut) {
    const glm::mat4 to_world = model_to_world(state, model);
    const float scale = glm::length(glm::vec3(to_world[0]));
    const glm::vec3 normal = glm::normalize(glm::mat3(to_world) * state.cuts[cut].plane.normal);
    const glm::vec3 aside = ray.origin - at_world(to_world, box_middle(model.arrays()));
    const float b = glm::dot(ray.direction, normal);
    const float square = 1 - b * b;
    // A ray along the normal moves the plane not at all.
    if (square < 1e-3F) return 0;
    return (glm::dot(normal, aside) - b * glm::dot(ray.direction, aside)) / square / scale;
}

void carry_cut(ViewerState& state, const ViewedModel& model, const Ray& ray) {
    const glm::mat4 back = glm::inverse(model_to_world(state, model));
    const glm::vec3 normal = glm::normalize(glm::mat3(back) * ray.direction);
    const float offset = glm::dot(normal, at_world(back, ray.origin));
    if (state.cuts.empty()) state.cuts.emplace_back();
    state.cuts.front() = {{normal, offset}, true};
}

}  // namespace feelem::viewer
