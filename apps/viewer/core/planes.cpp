// SPDX-License-Identifier: Apache-2.0
// Cutting planes and parts as a person changes them.
#include "viewer/core/viewer_state.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace feelem::viewer {
namespace {

glm::vec3 axis_normal(std::size_t axis) {
    glm::vec3 normal(0);
    normal[static_cast<int>(axis % 3)] = 1;
    return normal;
}

bool is_across(const CutPlane& plane, std::size_t axis) {
    return std::abs(plane.normal[static_cast<int>(axis)]) > 0.999F;
}

CutPlane through_middle(const ViewedModel& model, const glm::vec3& normal) {
    const auto [from, to] = reach_along(model, normal);
    return {normal, from + (to - from) / 2};
}

}  // namespace

std::array<float, 2> reach_along(const ViewedModel& model, const glm::vec3& normal) {
    const auto& low = model.arrays().low;
    const auto& high = model.arrays().high;
    float from = 0, to = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const float along = normal[static_cast<int>(k)];
        from += std::min(along * low[k], along * high[k]);
        to += std::max(along * low[k], along * high[k]);
    }
    return {from, to};
}

void add_cut(ViewerState& state, const ViewedModel& model) {
    if (state.cuts.size() >= kMostCuts) return;
    std::size_t free = 0;
    while (free < 2 &&
           std::ranges::any_of(state.cuts, [&](const CutState& cut) { return is_across(cut.plane, free); })) {
        ++free;
    }
    state.cuts.push_back({through_middle(model, axis_normal(free)), true});
}

void turn_cut(ViewerState& state, const ViewedModel& model, std::size_t cut, std::size_t axis) {
    if (cut < state.cuts.size()) state.cuts[cut] = {through_middle(model, axis_normal(axis)), true};
}

void flip_cut(ViewerState& state, std::size_t cut) {
    if (cut >= state.cuts.size()) return;
    CutPlane& plane = state.cuts[cut].plane;
    plane = {-plane.normal, -plane.offset};
}

void place_cut(ViewerState& state, const ViewedModel& model, std::size_t cut, float offset) {
    if (cut >= state.cuts.size()) return;
    CutPlane& plane = state.cuts[cut].plane;
    const auto [from, to] = reach_along(model, plane.normal);
    plane.offset = std::clamp(offset, from, to);
}

void move_cut(ViewerState& state, const ViewedModel& model, std::size_t cut, double share) {
    if (cut >= state.cuts.size()) return;
    const CutPlane& plane = state.cuts[cut].plane;
    const auto [from, to] = reach_along(model, plane.normal);
    place_cut(state, model, cut, plane.offset + static_cast<float>(share) * (to - from));
}

void toggle_cuts(ViewerState& state, const ViewedModel& model) {
    if (state.cuts.empty()) {
        add_cut(state, model);
        return;
    }
    const bool on = std::ranges::none_of(state.cuts, &CutState::on);
    for (CutState& cut : state.cuts) cut.on = on;
}

std::vector<CutPlane> cuts_of(const ViewerState& state) {
    std::vector<CutPlane> planes;
    for (const CutState& cut : state.cuts) {
        if (cut.on && planes.size() < kMostCuts) planes.push_back(cut.plane);
    }
    return planes;
}

void set_part(ViewerState& state, std::size_t part, PartLook look) {
    if (part < state.parts.size()) state.parts[part] = look;
}

void isolate_part(ViewerState& state, std::size_t part) {
    if (part >= state.parts.size()) return;
    std::ranges::fill(state.parts, PartLook::Hidden);
    state.parts[part] = PartLook::Shown;
}

}  // namespace feelem::viewer
