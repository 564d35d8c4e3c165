// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/panel_model.hpp"

#include "viewer/desktop/keys.hpp"
#include "viewer/ui/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

std::string origin_text(const SceneResult& result) {
    std::string text = result.location == Location::Elemental      ? "of elements"
                       : result.location == Location::ElementNodal ? "at elements' nodes"
                                                                   : "at nodes";
    switch (result.averaging) {
    case Averaging::Solver: text += " · averaged by the solver"; break;
    case Averaging::Part: text += " · averaged in parts"; break;
    case Averaging::All: text += " · averaged across parts"; break;
    case Averaging::None: text += " · not averaged"; break;
    case Averaging::NotApplicable: break;
    }
    if (result.layer != Layer::No) text += fmt::format(" · {}", word(result.layer));
    return text;
}

/// What is drawn may be off by so much: by the level of detail, and by what a compressed scene has rounded.
std::string within_text(
    const Scene& scene, const Look& look, const PresentedResult& shown, const ValueRange& range
) {
    if (!look.field) return {};
    const SceneResult& result = scene.results[look.field->result];
    double bound = result.bound;
    if (look.level) {
        for (const SceneLevelValues& values : scene.levels[*look.level].values)
            if (values.result == look.field->result && values.values == look.field->values)
                bound += values.bound;
    }
    if (!(bound > 0)) return {};
    const std::string own = fmt::format("±{}", bound_text(bound));
    const std::string unit = unit_text(unit_of(scene, shown));
    const double width = std::abs(range.hi - range.lo);
    const std::string in_unit = unit.empty() ? own : fmt::format("{} {}", own, unit);
    if (!(width > 0)) return fmt::format("values within {}", in_unit);
    return fmt::format("values within ±{} % ({})", bound_text(100 * bound / width), in_unit);
}

std::optional<UiLegend> legend_of(const Viewer& viewer, const Look& look, const Snapshot& snapshot) {
    const ViewerState& state = viewer.state;
    const Scene& scene = viewer.model.about();
    const PresentedResult* shown = result_of(state.presentation, Sense::Colour);
    const PresentedEffect* effect = effect_of(state.presentation, Sense::Colour);
    if (shown == nullptr || effect == nullptr || !look.field) return std::nullopt;
    UiLegend legend;
    legend.key = shown->key;
    legend.title = label_of(scene, *shown);
    legend.unit = unit_of(scene, *shown);
    legend.step = scene.steps.empty() ? "" : step_text(scene.steps[state.step]);
    legend.origin = origin_text(scene.results[look.field->result]);
    legend.range = look.range;
    legend.colour = look.colour;
    legend.limit = shown->limit;
    legend.limit_is_upper = shown->limit_is_upper;
    legend.limit_label = shown->limit_label;
    legend.within = within_text(scene, look, *shown, look.range);
    legend.isolines = state.isolines;
    const double factor = factor_of(state, viewer.model);
    legend.deformation = factor == 0 ? "undeformed" : fmt::format("deformation × {}", number_text(factor, 4));
    if (snapshot.probed) {
        for (const Reading& reading : snapshot.probed->readings)
            if (reading.key == shown->key && !std::isnan(reading.value)) legend.probed = reading.value;
    }
    return legend;
}

const PresentedResult* presented(const Presentation& presentation, const std::string& key) {
    const auto found = std::ranges::find(presentation.results, key, &PresentedResult::key);
    return found == presentation.results.end() ? nullptr : &*found;
}

std::string sounding_text(const Snapshot& snapshot) {
    std::vector<std::string> heard;
    if (!snapshot.is_held) return {};
    if (snapshot.sound && snapshot.sound->gain > 0)
        heard.push_back(fmt::format("tone {} Hz", number_text(snapshot.sound->hz, 4)));
    if (snapshot.sound && snapshot.sound->tick_rate > 0)
        heard.push_back(fmt::format("{} ticks/s", number_text(snapshot.sound->tick_rate, 3)));
    for (const auto& touch : snapshot.touch)
        if (touch && touch->rate > 0)
            heard.push_back(fmt::format("{} pulses/s", number_text(touch->rate, 3)));
    return fmt::format("{}", fmt::join(heard, " · "));
}

UiCardRow row_of(const Viewer& viewer, const Reading& reading) {
    const Presentation& presentation = viewer.state.presentation;
    const Scene& scene = viewer.model.about();
    UiCardRow row;
    row.key = reading.key;
    row.value = reading.value;
    row.node_value = reading.node_value;
    row.state = reading.state;
    row.senses = senses_of(presentation, reading.key);
    row.beyond = reading.beyond_limit;
    row.bound = scene.results[reading.field.result].bound;
    if (const PresentedResult* result = presented(presentation, reading.key)) {
        row.label = label_of(scene, *result);
        row.unit = unit_of(scene, *result);
        row.limit = result->limit;
        row.limit_is_upper = result->limit_is_upper;
        row.limit_label = result->limit_label;
    }
    return row;
}

std::optional<UiCard> card_of(const Viewer& viewer, const Snapshot& snapshot) {
    if (!snapshot.probed) return std::nullopt;
    const Probed& probed = *snapshot.probed;
    const Scene& scene = viewer.model.about();
    UiCard card;
    for (const Reading& reading : probed.readings) card.rows.push_back(row_of(viewer, reading));
    // The presentation says what comes first.
    const std::vector<std::string>& order = viewer.state.presentation.card;
    const auto place = [&](const UiCardRow& row) {
        return std::ranges::find(order, row.key) - order.begin();
    };
    std::ranges::stable_sort(card.rows, {}, place);
    card.node = probed.node_id;
    card.element = probed.element_id;
    card.place = probed.model;
    card.length_unit = scene.length_unit ? scene.length_unit->name : "";
    card.sounding = sounding_text(snapshot);
    card.is_pinned = snapshot.pointer == Pointer::Pin;
    return card;
}

std::vector<UiResult> results_of(const Viewer& viewer) {
    const ViewerState& state = viewer.state;
    const Scene& scene = viewer.model.about();
    std::vector<UiResult> results;
    for (const PresentedResult& result : state.presentation.results) {
        UiResult row;
        row.key = result.key;
        row.label = label_of(scene, result);
        row.unit = unit_of(scene, result);
        if (find_field(scene, result, state.step)) row.range = range_at(state, viewer.model, result);
        row.senses = senses_of(state.presentation, result.key);
        row.can_shape = result.name == "displacement";
        row.limit = result.limit;
        row.limit_is_upper = result.limit_is_upper;
        results.push_back(std::move(row));
    }
    return results;
}

UiSteps steps_of(const Viewer& viewer) {
    const Scene& scene = viewer.model.about();
    UiSteps steps;
    for (const Step& step : scene.steps) steps.names.push_back(step_text(step));
    steps.shown = viewer.state.step;
    steps.is_playing = viewer.state.playing;
    steps.is_mode = !scene.steps.empty() && scene.steps[steps.shown].kind == StepKind::Mode;
    return steps;
}

UiDeformation deformation_of(const Viewer& viewer) {
    UiDeformation deformation;
    deformation.is_there = shape_field(viewer.state, viewer.model).has_value();
    if (!deformation.is_there) return deformation;
    deformation.factor = factor_of(viewer.state, viewer.model);
    deformation.automatic = automatic_factor(viewer.state, viewer.model);
    deformation.is_automatic = viewer.state.deformation == Deformation::Automatic;
    return deformation;
}

std::vector<UiPart> parts_of(const Viewer& viewer) {
    std::vector<UiPart> parts;
    const Scene& scene = viewer.model.about();
    for (std::size_t p = 0; p < scene.parts.size(); ++p)
        parts.push_back(
            {scene.parts[p].name,
             scene.parts[p].kind,
             viewer.model.arrays().parts[p].triangles,
             viewer.state.parts[p]}
        );
    return parts;
}

std::vector<UiCut> cuts_shown(const Viewer& viewer) {
    const auto& origin = viewer.model.about().origin;
    std::vector<UiCut> cuts;
    for (const CutState& cut : viewer.state.cuts) {
        const auto [from, to] = reach_along(viewer.model, cut.plane.normal);
        UiCut shown{cut.plane, from, to, cut.on, 0};
        for (int axis = 0; axis < 3; ++axis)
            shown.shift +=
                static_cast<double>(cut.plane.normal[axis]) * origin[static_cast<std::size_t>(axis)];
        cuts.push_back(shown);
    }
    return cuts;
}

/// With the coloured result's value at its node.
UiMarker note_of(const Viewer& viewer, const Marker& marker) {
    UiMarker shown;
    shown.node = marker.node;
    shown.text = marker.text;
    const Scene& scene = viewer.model.about();
    const PresentedResult* seen = result_of(viewer.state.presentation, Sense::Colour);
    const auto field = seen != nullptr ? find_field(scene, *seen, viewer.state.step) : std::nullopt;
    const auto corner = viewer.model.corner_of_node(marker.node);
    if (!field || !corner) return shown;
    const FieldSpan span = viewer.model.values(*field);
    if (span.components == 0) return shown;
    const std::size_t vertex = viewer.model.vertex_at(*corner);
    shown.value = static_cast<double>(span.values[vertex * span.components + field->component]);
    shown.unit = unit_of(scene, *seen);
    return shown;
}

void list_places(Viewer& viewer, UiModel& out) {
    const Scene& scene = viewer.model.about();
    for (const HotSpot& spot : viewer.spots.of(viewer.state, viewer.model)) {
        const PresentedResult* result = presented(viewer.state.presentation, spot.key);
        if (result == nullptr) continue;
        out.hot_spots.push_back(
            {label_of(scene, *result),
             unit_of(scene, *result),
             spot.value,
             spot.utilisation,
             spot.node,
             viewer.state.pin == spot.node}
        );
    }
    for (const Marker& marker : viewer.state.markers) out.markers.push_back(note_of(viewer, marker));
}

std::vector<UiFact> facts_of(const Scene& scene) {
    std::vector<UiFact> facts;
    for (const auto& [name, value] : scene.notes) facts.push_back({name, value});
    for (const InputRecord& input : scene.inputs)
        facts.push_back(
            {input.path,
             input.sha256.empty() ? "no digest was made" : fmt::format("SHA-256 {:.16}…", input.sha256)}
        );
    return facts;
}

std::vector<UiKey> keys_of() {
    std::vector<UiKey> keys;
    for (const KeyBinding& binding : key_bindings())
        keys.push_back({std::string(binding.shown), std::string(binding.text)});
    return keys;
}

}  // namespace

std::vector<Sense> senses_of(const Presentation& presentation, const std::string& key) {
    std::vector<Sense> senses;
    for (const PresentedEffect& effect : presentation.effects)
        if (effect.result == key) senses.push_back(effect.sense);
    if (presentation.deformation_result == key) senses.push_back(Sense::Shape);
    return senses;
}

UiModel panel_model(Viewer& viewer, const Look& look, const Snapshot& snapshot, const DeviceWords& devices) {
    const ViewerState& state = viewer.state;
    const Scene& scene = viewer.model.about();
    UiModel out;
    out.title = scene.title;
    out.theme = devices.theme;
    out.show_help = devices.show_help;
    out.legend = legend_of(viewer, look, snapshot);
    out.card = card_of(viewer, snapshot);
    out.results = results_of(viewer);
    out.steps = steps_of(viewer);
    out.deformation = deformation_of(viewer);
    out.parts = parts_of(viewer);
    out.cuts = cuts_shown(viewer);
    out.cuts_are_on = std::ranges::any_of(state.cuts, &CutState::on);
    out.length_unit = scene.length_unit ? scene.length_unit->name : "";
    list_places(viewer, out);
    out.edges = state.edges;
    out.ghost = state.ghost;
    out.sound = {state.person.master, !state.sound, state.person.mono, devices.sound_trouble, state.guide};
    out.touch = {state.person.strength, !state.touch, devices.touch_trouble};
    out.headset = devices.headset;
    out.certificate = facts_of(scene);
    out.keys = keys_of();
    out.message = state.notice;
    out.trouble = devices.trouble.empty() ? viewer.model.problem() : devices.trouble;
    return out;
}

}  // namespace feelem::viewer
