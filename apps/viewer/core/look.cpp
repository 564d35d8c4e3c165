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

/// Whether the level says how wrong it may be of this result at this step.
bool bounds(const SceneLevel& level, const FieldChoice& field) {
    return std::ranges::any_of(level.values, [&](const SceneLevelValues& values) {
        return values.result == field.result && values.values == field.values;
    });
}

std::vector<FieldChoice> drawn_fields(const Look& look) {
    std::vector<FieldChoice> out;
    if (look.field) out.push_back(*look.field);
    if (look.shape) out.push_back(look.shape->field);
    if (look.shape && look.shape->imaginary) out.push_back(*look.shape->imaginary);
    return out;
}

}  // namespace

std::optional<std::size_t> level_within(
    const ViewedModel& model, std::uint64_t budget, std::span<const FieldChoice> drawn
) {
    const auto& levels = model.about().levels;
    if (model.arrays().triangles.size() <= budget) return std::nullopt;
    std::optional<std::size_t> coarsest;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (!std::ranges::all_of(drawn, [&](const FieldChoice& field) { return bounds(levels[i], field); }))
            continue;
        coarsest = i;
        if (levels[i].triangles <= budget) break;
    }
    return coarsest;
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
    look.level = level_within(model, budget, drawn_fields(look));
    look.model_to_world = model_to_world(state, model);
    return look;
}

}  // namespace feelem::viewer
