// SPDX-License-Identifier: Apache-2.0
// Which result drives which sense, and the range that all its senses share.
#include "convert/scene_target.hpp"
#include "viewer/core/viewer_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

PresentedResult* find_key(Presentation& presentation, std::string_view key) {
    const auto found = std::ranges::find(presentation.results, key, &PresentedResult::key);
    return found == presentation.results.end() ? nullptr : &*found;
}

PresentedEffect* find_effect(Presentation& presentation, Sense sense) {
    const auto found = std::ranges::find(presentation.effects, sense, &PresentedEffect::sense);
    return found == presentation.effects.end() ? nullptr : &*found;
}

std::optional<SceneTarget> find_target(const Scene& scene, const PresentedResult& wanted) {
    std::vector<const SceneResult*> results;
    results.reserve(scene.results.size());
    for (const SceneResult& result : scene.results) results.push_back(&result);
    return find_presented(results, wanted);
}

struct Ends {
    double lo = 0, hi = 0;
};

/// Extremes over the whole model as the scene states them.
std::optional<Ends> stated_ends(const SceneResult& result, const SceneValues& values) {
    if (result.components.size() != 1 || !values.min || !values.max) return std::nullopt;
    return Ends{static_cast<double>(values.min->value), static_cast<double>(values.max->value)};
}

std::optional<Ends> ends_of_all_steps(const SceneResult& result) {
    std::optional<Ends> all;
    for (const SceneValues& values : result.values) {
        const auto one = stated_ends(result, values);
        if (!one) return std::nullopt;
        all = all ? Ends{std::min(all->lo, one->lo), std::max(all->hi, one->hi)} : *one;
    }
    return all;
}

std::optional<Ends> automatic_ends(
    const ViewedModel& model, const PresentedResult& wanted, std::size_t step
) {
    const Scene& scene = model.about();
    const auto target = find_target(scene, wanted);
    if (!target) return std::nullopt;
    const SceneResult& result = scene.results[target->result];
    if (wanted.range_mode == "allSteps") {
        if (const auto all = ends_of_all_steps(result)) return all;
    }
    const auto field = find_field(scene, wanted, step);
    if (!field) return std::nullopt;
    if (const auto stated = stated_ends(result, result.values[field->values])) return stated;
    const auto skin = model.skin_range(*field);
    return skin ? std::optional(Ends{(*skin)[0], (*skin)[1]}) : std::nullopt;
}

}  // namespace

const PresentedEffect* effect_of(const Presentation& presentation, Sense sense) {
    const auto found = std::ranges::find(presentation.effects, sense, &PresentedEffect::sense);
    return found == presentation.effects.end() ? nullptr : &*found;
}

const PresentedResult* result_of(const Presentation& presentation, Sense sense) {
    const PresentedEffect* effect = effect_of(presentation, sense);
    std::string_view key;
    if (sense == Sense::Shape) {
        key = presentation.deformation_result;
    } else if (effect != nullptr) {
        key = effect->result;
    }
    const auto found = std::ranges::find(presentation.results, key, &PresentedResult::key);
    return key.empty() || found == presentation.results.end() ? nullptr : &*found;
}

std::optional<FieldChoice> find_field(const Scene& scene, const PresentedResult& wanted, std::size_t step) {
    const auto target = find_target(scene, wanted);
    if (!target) return std::nullopt;
    const auto& values = scene.results[target->result].values;
    const auto found = std::ranges::find(values, step, &SceneValues::step);
    if (found == values.end()) return std::nullopt;
    return FieldChoice{target->result, static_cast<std::size_t>(found - values.begin()), target->component};
}

std::optional<FieldChoice> find_component(const Scene& scene, const PresentedResult& wanted) {
    const auto target = find_target(scene, wanted);
    if (!target) return std::nullopt;
    return FieldChoice{target->result, kNoValues, target->component};
}

std::optional<std::array<double, 2>> extremes_at(
    const ViewedModel& model, const PresentedResult& result, std::size_t step
) {
    const auto field = find_field(model.about(), result, step);
    if (!field) return std::nullopt;
    const SceneResult& from = model.about().results[field->result];
    if (const auto stated = stated_ends(from, from.values[field->values])) {
        return std::array{stated->lo, stated->hi};
    }
    return model.skin_range(*field);
}

ValueRange range_at(const ViewerState& state, const ViewedModel& model, const PresentedResult& result) {
    ValueRange range{0, 1, result.scale};
    // Ends that only the converter finds, or that nobody has typed, are not there in every file.
    const bool is_typed =
        (result.range_mode == "manual" || result.range_mode == "percentile") && result.lo && result.hi;
    const auto automatic = is_typed ? std::nullopt : automatic_ends(model, result, state.step);
    if (automatic) {
        range.lo = automatic->lo;
        range.hi = automatic->hi;
    } else if (result.lo && result.hi) {
        range.lo = *result.lo;
        range.hi = *result.hi;
    }
    return range;
}

std::string label_of(const Scene& scene, const PresentedResult& result) {
    const auto target = find_target(scene, result);
    const SceneResult* found = target ? &scene.results[target->result] : nullptr;
    if (found != nullptr && found->components.size() == 1) return found->title;
    std::string text = found != nullptr ? found->title : result.name;
    std::replace(text.begin(), text.end(), '_', ' ');
    return result.component == "value" ? text : text + " " + result.component;
}

std::string unit_of(const Scene& scene, const PresentedResult& result) {
    const auto target = find_target(scene, result);
    const bool is_known = target && !scene.results[target->result].unit.empty();
    return is_known ? scene.results[target->result].unit : result.unit;
}

void assign(ViewerState& state, std::string_view key, Sense sense) {
    const PresentedResult* result = find_key(state.presentation, key);
    if (result == nullptr) return;
    if (result->scale == Scale::Signed && (sense == Sense::Ticks || sense == Sense::Pulses)) {
        state.notice = "A signed result cannot be told by a rate; give it colour or pitch.";
        return;
    }
    state.changed = true;
    if (sense == Sense::Shape) {
        state.presentation.deformation_result = key;
    } else if (PresentedEffect* effect = find_effect(state.presentation, sense)) {
        effect->result = key;
    } else {
        PresentedEffect made;
        made.result = key;
        made.sense = sense;
        state.presentation.effects.push_back(made);
    }
}

void release(ViewerState& state, Sense sense) {
    state.changed = true;
    if (sense == Sense::Shape) {
        state.presentation.deformation_result.clear();
        return;
    }
    std::erase_if(state.presentation.effects, [&](const PresentedEffect& e) { return e.sense == sense; });
}

std::string add_result(ViewerState& state, const Scene& scene, std::size_t result, std::size_t component) {
    const SceneResult& from = scene.results.at(result);
    const std::string& name = from.components.at(component);
    const bool is_alone = name == "value" || from.components.size() == 1;
    const std::string stem = is_alone ? from.id : from.id + "_" + name;
    std::string key = stem;
    for (int n = 2; find_key(state.presentation, key) != nullptr; ++n) {
        key = stem + "_" + std::to_string(n);
    }
    PresentedResult added;
    added.key = key;
    added.name = from.quantity;
    added.component = name;
    added.location = word(from.location);
    if (from.averaging != Averaging::NotApplicable) added.averaging = word(from.averaging);
    if (from.layer != Layer::No) added.layer = word(from.layer);
    added.unit = from.unit;
    state.presentation.results.push_back(added);
    state.changed = true;
    return key;
}

void set_range(ViewerState& state, std::string_view key, std::string_view mode, double lo, double hi) {
    PresentedResult* result = find_key(state.presentation, key);
    if (result == nullptr) return;
    result->range_mode = mode;
    if (mode == "manual") {
        result->lo = std::min(lo, hi);
        result->hi = std::max(lo, hi);
    }
    state.changed = true;
}

namespace {

std::string made_label(const PresentedResult& result) {
    return result.limit ? fmt::format("{} {}", result.key, *result.limit) : std::string();
}

}  // namespace

void set_limit(ViewerState& state, std::string_view key, std::optional<double> limit, bool is_upper) {
    PresentedResult* result = find_key(state.presentation, key);
    if (result == nullptr) return;
    // A label that was made of the number goes with it; a name that somebody gave stays.
    if (result->limit_label == made_label(*result)) result->limit_label.clear();
    result->limit = limit;
    result->limit_is_upper = is_upper;
    // No two limits may have the same label.
    const bool is_taken = std::ranges::any_of(state.presentation.results, [&](const PresentedResult& other) {
        return &other != result && other.limit && other.limit_label == result->limit_label;
    });
    if (limit && (result->limit_label.empty() || is_taken)) {
        result->limit_label = made_label(*result);
    }
    state.changed = true;
}

void set_colour(ViewerState& state, const ColourEffect& effect) {
    if (PresentedEffect* found = find_effect(state.presentation, Sense::Colour)) {
        found->colour = effect;
        state.changed = true;
    }
}

void next_result(ViewerState& state, const ViewedModel& model) {
    std::vector<std::string> keys;
    for (const PresentedResult& result : state.presentation.results) {
        if (find_target(model.about(), result)) keys.push_back(result.key);
    }
    if (keys.empty()) return;
    const PresentedResult* seen = result_of(state.presentation, Sense::Colour);
    const auto at = std::ranges::find(keys, seen != nullptr ? seen->key : std::string());
    const auto behind = at == keys.end() ? keys.begin() : at + 1;
    assign(state, behind == keys.end() ? keys.front() : *behind, Sense::Colour);
}

std::optional<double> utilisation(double value, std::optional<double> limit, bool limit_is_upper) {
    if (!limit || std::isnan(value) || !(*limit > 0)) return std::nullopt;
    if (limit_is_upper) return value / *limit;
    // At least 1.5 wanted, 3 found: half of it is used.
    return value > 0 ? std::optional(*limit / value) : std::nullopt;
}

std::optional<double> utilisation(double value, const PresentedResult& result) {
    return utilisation(value, result.limit, result.limit_is_upper);
}

bool is_past_limit(double value, const PresentedResult& result) {
    return result.limit && (result.limit_is_upper ? value > *result.limit : value < *result.limit);
}

}  // namespace feelem::viewer
