// SPDX-License-Identifier: Apache-2.0
// From the state to how the model is drawn.
#include "viewer/core/viewer_state.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

/// Maps whose neighbours differ in lightness alone: shade would be read as another value, so they get half.
bool is_told_by_lightness(const std::string& map) {
    return map == "cividis" || map == "cool_warm";
}

void fill_colour(Look& look, const ViewerState& state, const ViewedModel& model) {
    const PresentedResult* seen = result_of(state.presentation, Sense::Colour);
    const PresentedEffect* effect = effect_of(state.presentation, Sense::Colour);
    if (seen == nullptr || effect == nullptr) return;
    look.field = find_field(model.about(), *seen, state.step);
    look.range = range_at(state, model, *seen);
    look.colour = effect->colour;
    look.limit = seen->limit;
    look.isolines = state.isolines;
    const auto asked = static_cast<float>(state.shade_floor);
    const float floor = is_told_by_lightness(effect->colour.map) ? (1 + asked) / 2 : asked;
    look.shade_floor = state.shading ? floor : 1;
}

void fill_shape(Look& look, const ViewerState& state, const ViewedModel& model) {
    const double factor = factor_of(state, model);
    const auto field = shape_field(state, model);
    look.ghost = state.ghost && factor != 0;
    if (!field || factor == 0) return;
    Shape shape{*field, imaginary_shape(state, model), 0, 0};
    shape.factor = static_cast<float>(factor * std::cos(state.angle));
    if (shape.imaginary) shape.imaginary_factor = static_cast<float>(-factor * std::sin(state.angle));
    look.shape = shape;
}

}  // namespace

std::optional<std::size_t> level_within(const ViewedModel& model, std::uint64_t budget) {
    const auto& levels = model.about().levels;
    if (model.arrays().triangles.size() <= budget || levels.empty()) return std::nullopt;
    const auto fits = [&](const SceneLevel& level) { return level.triangles <= budget; };
    const auto found = std::ranges::find_if(levels, fits);
    return found == levels.end() ? levels.size() - 1 : static_cast<std::size_t>(found - levels.begin());
}

Look make_look(const ViewerState& state, const ViewedModel& model, bool is_headset) {
    Look look;
    fill_colour(look, state, model);
    fill_shape(look, state, model);
    look.edges = state.edges;
    look.parts = state.parts;
    look.cuts = cuts_of(state);
    const std::uint64_t budget =
        is_headset ? std::min(state.most_triangles, kHeadsetTriangles) : state.most_triangles;
    look.level = level_within(model, budget);
    look.model_to_world = model_to_world(state, model);
    return look;
}

}  // namespace feelem::viewer
