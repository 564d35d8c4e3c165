// SPDX-License-Identifier: Apache-2.0
// The state a scene starts in, what each command does to it, and how it is saved.
#include "base/atomic_file.hpp"
#include "viewer/core/viewer_state.hpp"

#include "feelem/presented_view.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>

namespace feelem::viewer {
namespace {

constexpr double kClipStep = 0.01;
/// How near the desk's camera comes to a place that is gone to: a part of the model's size.
constexpr float kNearness = 0.6F;

/// What a scene without a presentation shows: as the converter chooses (docs/effects.md 7).
Presentation default_presentation(const Scene& scene) {
    std::vector<Candidate> candidates;
    for (const SceneResult& result : scene.results) {
        if (result.components.size() != 1) continue;
        candidates.push_back({result.quantity, result.components.front(), result.unit});
    }
    return choose_presentation(candidates, scene.title);
}

std::size_t first_step(const Scene& scene) {
    if (!scene.presentation.step) return 0;
    const auto [input, step, substep] = *scene.presentation.step;
    for (std::size_t i = 0; i < scene.steps.size(); ++i) {
        const Step& s = scene.steps[i];
        if (static_cast<int>(s.input) == input && s.step == step && s.substep == substep) return i;
    }
    return 0;
}

/// Triangles up to which the ghost's lines are looked for unasked.
constexpr std::size_t kGhostUpTo = 300'000;

void take_view(ViewerState& state, const ViewedModel& model, const PresentedView& view) {
    state.isolines = view.isolines;
    state.ghost = view.ghost && model.arrays().triangles.size() < kGhostUpTo;
    state.shade_floor = view.shade_floor;
    state.events.limit = view.limit_events;
    state.events.extremes = view.extreme_events;
    state.events.no_value = view.no_value_events;
    state.events.band_edges = view.band_events;
    state.person.master = view.master;
    state.person.mono = view.mono;
    state.person.captions = view.captions;
}

void toggle_play(ViewerState& state, const ViewedModel& model) {
    state.playing = !state.playing && can_play(state, model);
}

void animate(ViewerState& state, const ViewedModel& model) {
    if (!state.playing && !swings(state, model)) {
        state.notice = "This step is no mode with a shape: there is nothing to swing.";
        return;
    }
    state.playing = !state.playing;
}

/// Lays the room out anew: in a headset at its next frame, before the person as they stand then.
void go_home(ViewerState& state, const ViewedModel& model, bool is_headset) {
    state.stand.reset();
    if (!is_headset) put_on_table(state, model, {});
}

void toggle_guide(ViewerState& state) {
    state.guide = !state.guide;
    state.notice = state.guide ? "Press and sweep: the ticks are fastest at the largest value."
                               : "Ticks mean values again.";
}

void remove_markers(ViewerState& state) {
    state.notice = state.markers.empty() ? "There are no notes." : "All notes are gone.";
    state.markers.clear();
}

}  // namespace

ViewerState first_state(const ViewedModel& model) {
    ViewerState state;
    const Scene& scene = model.about();
    state.presentation = scene.presentation;
    if (state.presentation.results.empty()) state.presentation = default_presentation(scene);
    state.step = first_step(scene);
    state.parts.assign(model.arrays().parts.size(), PartLook::Shown);
    if (const auto factor = state.presentation.deformation_factor) {
        state.deformation = *factor == 1   ? Deformation::True
                            : *factor == 0 ? Deformation::None
                                           : Deformation::Typed;
        state.typed_factor = *factor;
    }
    take_view(state, model, presented_view(state.presentation.json));
    put_on_table(state, model, {});
    state.changed = false;
    return state;
}

void place_marker(ViewerState& state, std::optional<std::int64_t> node) {
    if (!node) {
        state.notice = "Point at a node first, or go to one.";
        return;
    }
    if (std::ranges::find(state.markers, *node, &Marker::node) != state.markers.end()) {
        state.notice = fmt::format("Node {} has a note already.", *node);
        return;
    }
    if (state.markers.size() >= kMostMarkers) {
        state.notice = fmt::format("There is room for {} notes.", kMostMarkers);
        return;
    }
    int id = 1;
    for (const Marker& marker : state.markers) id = std::max(id, marker.id + 1);
    state.markers.push_back({id, *node, {}});
    state.notice = fmt::format("Note {} at node {}.", id, *node);
}

void remove_marker(ViewerState& state, int id) {
    std::erase_if(state.markers, [&](const Marker& marker) { return marker.id == id; });
}

void go_to_node(ViewerState& state, const ViewedModel& model, std::int64_t node) {
    const auto corner = model.corner_of_node(node);
    if (!corner) {
        state.notice = fmt::format("Node {} is not on the skin.", node);
        return;
    }
    state.pin = node;
    const auto& at = model.arrays().positions[model.vertex_at(*corner)];
    const glm::mat4 to_world = model_to_world(state, model);
    const float size = static_cast<float>(model.largest_side()) * glm::length(glm::vec3(to_world[0]));
    state.look_at = {glm::vec3(to_world * glm::vec4(at[0], at[1], at[2], 1)), kNearness * size};
}

void run(ViewerState& state, const ViewedModel& model, Command command, const Circumstances& now) {
    const Stand stand = state.stand.value_or(Stand{});
    switch (command) {
    case Command::Home: go_home(state, model, now.is_headset); break;
    case Command::Fit:  // At the desk the camera does it.
        if (now.is_headset) put_on_table(state, model, stand);
        break;
    case Command::TrueScale: put_at_true_size(state, model, stand); break;
    case Command::NoDeformation: state.deformation = Deformation::None; break;
    case Command::TrueDeformation: state.deformation = Deformation::True; break;
    case Command::NextStep: step_by(state, model, 1); break;
    case Command::PreviousStep: step_by(state, model, -1); break;
    case Command::PlaySteps: toggle_play(state, model); break;
    case Command::NextResult: next_result(state, model); break;
    case Command::ToggleMute: state.sound = !state.sound; break;
    case Command::ToggleStill: state.touch = !state.touch; break;
    case Command::ToggleGuide: toggle_guide(state); break;
    case Command::ToggleClip: toggle_cuts(state, model); break;
    case Command::ClipForward: move_cut(state, model, 0, kClipStep); break;
    case Command::ClipBack: move_cut(state, model, 0, -kClipStep); break;
    case Command::ToggleEdges: state.edges = !state.edges; break;
    case Command::ToggleIsolines:
        state.isolines = !state.isolines;
        state.changed = true;
        break;
    case Command::ToggleGhost: state.ghost = !state.ghost; break;
    case Command::AnimateMode: animate(state, model); break;
    case Command::PlaceMarker: place_marker(state, now.node); break;
    case Command::RemoveMarkers: remove_markers(state); break;
    case Command::NextHotSpot: next_hot_spot(state, model, 1); break;
    case Command::PreviousHotSpot: next_hot_spot(state, model, -1); break;
    case Command::SavePresentation: state.wants_save = true; break;
    case Command::Leave:
        state.leaves = !state.pin;
        state.pin.reset();
        break;
    }
}

void save_presentation(ViewerState& state, const ViewedModel& model, const std::string& path) {
    Presentation saved = state.presentation;
    const auto& steps = model.about().steps;
    if (state.step < steps.size()) {
        const Step& step = steps[state.step];
        saved.step = {static_cast<int>(step.input), step.step, step.substep};
    }
    saved.deformation_factor.reset();
    if (state.deformation == Deformation::True) saved.deformation_factor = 1;
    if (state.deformation == Deformation::None) saved.deformation_factor = 0;
    if (state.deformation == Deformation::Typed) saved.deformation_factor = state.typed_factor;
    const std::string text = presentation_json(saved);
    PresentedView view = presented_view(text);
    view.isolines = state.isolines;
    // A model too large for it at first has not said that nobody wants it.
    if (state.ghost || model.arrays().triangles.size() < kGhostUpTo) view.ghost = state.ghost;
    AtomicFile file(path);
    file.write(with_presented_view(text, view));
    file.commit();
    state.changed = false;
}

}  // namespace feelem::viewer
