// SPDX-License-Identifier: Apache-2.0
// Steps, and the shape that they move.
#include "viewer/core/viewer_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace feelem::viewer {
namespace {

bool is_real_vector(const SceneResult& result) {
    const std::array<std::string, 3> axes{"x", "y", "z"};
    return result.complex != Complex::Imaginary && std::ranges::equal(result.components, axes);
}

std::optional<FieldChoice> field_at_step(const Scene& scene, std::size_t result, std::size_t step) {
    const auto& values = scene.results[result].values;
    const auto found = std::ranges::find(values, step, &SceneValues::step);
    if (found == values.end()) return std::nullopt;
    return FieldChoice{result, static_cast<std::size_t>(found - values.begin()), 0};
}

std::optional<double> stated_largest(const Scene& scene, const PresentedResult& shape, std::size_t step) {
    PresentedResult magnitude = shape;
    magnitude.component = "magnitude";
    const auto field = find_field(scene, magnitude, step);
    if (!field || scene.results[field->result].components.size() != 1) return std::nullopt;
    const auto& stated = scene.results[field->result].values[field->values].max;
    return stated ? std::optional(static_cast<double>(stated->value)) : std::nullopt;
}

}  // namespace

void set_step(ViewerState& state, const ViewedModel& model, std::size_t step) {
    if (step >= model.about().steps.size() || step == state.step) return;
    state.step = step;
    state.changed = true;
}

void step_by(ViewerState& state, const ViewedModel& model, int count) {
    const auto steps = static_cast<int>(model.about().steps.size());
    if (steps == 0) return;
    const int at = (static_cast<int>(state.step) + count % steps + steps) % steps;
    set_step(state, model, static_cast<std::size_t>(at));
}

std::optional<FieldChoice> shape_field(const ViewerState& state, const ViewedModel& model) {
    const PresentedResult* wanted = result_of(state.presentation, Sense::Shape);
    if (wanted == nullptr) return std::nullopt;
    const Scene& scene = model.about();
    for (const bool by_id : {false, true}) {
        for (std::size_t i = 0; i < scene.results.size(); ++i) {
            const SceneResult& result = scene.results[i];
            if ((by_id ? result.id : result.quantity) != wanted->name || !is_real_vector(result)) continue;
            return field_at_step(scene, i, state.step);
        }
    }
    return std::nullopt;
}

std::optional<FieldChoice> imaginary_shape(const ViewerState& state, const ViewedModel& model) {
    const auto shape = shape_field(state, model);
    const Scene& scene = model.about();
    if (!shape || scene.results[shape->result].complex != Complex::Real) return std::nullopt;
    for (std::size_t i = 0; i < scene.results.size(); ++i) {
        const SceneResult& result = scene.results[i];
        const bool is_other = result.complex == Complex::Imaginary &&
                              result.quantity == scene.results[shape->result].quantity &&
                              result.components.size() == 3;
        const auto field = is_other ? field_at_step(scene, i, state.step) : std::nullopt;
        if (field) return field;
    }
    return std::nullopt;
}

double automatic_factor(const ViewerState& state, const ViewedModel& model) {
    const auto shape = shape_field(state, model);
    const PresentedResult* wanted = result_of(state.presentation, Sense::Shape);
    if (!shape || wanted == nullptr) return 0;
    const auto stated = stated_largest(model.about(), *wanted, state.step);
    double largest = stated ? *stated : model.longest(*shape);
    if (const auto imaginary = imaginary_shape(state, model)) {
        largest = std::max(largest, model.longest(*imaginary));
    }
    return automatic_deformation_factor(model.largest_side(), largest);
}

double factor_of(const ViewerState& state, const ViewedModel& model) {
    if (state.deformation == Deformation::None || !shape_field(state, model)) return 0;
    if (state.deformation == Deformation::True) return 1;
    return state.deformation == Deformation::Typed ? state.typed_factor : automatic_factor(state, model);
}

bool swings(const ViewerState& state, const ViewedModel& model) {
    const auto& steps = model.about().steps;
    const bool is_mode = state.step < steps.size() && steps[state.step].kind == StepKind::Mode;
    return (is_mode || imaginary_shape(state, model)) && factor_of(state, model) != 0;
}

bool can_play(const ViewerState& state, const ViewedModel& model) {
    return model.about().steps.size() > 1 || swings(state, model);
}

void play(ViewerState& state, const ViewedModel& model, double seconds, double& step_age) {
    if (!state.playing) {
        state.angle = 0;
        step_age = 0;
        return;
    }
    if (swings(state, model)) {
        constexpr double kTurn = 6.283185307179586;
        state.angle = std::fmod(state.angle + kTurn * kSwings * state.speed * seconds, kTurn);
        return;
    }
    state.angle = 0;
    step_age += seconds;
    if (step_age < kStepSeconds / state.speed) return;
    step_age = 0;
    step_by(state, model, 1);
}

}  // namespace feelem::viewer
