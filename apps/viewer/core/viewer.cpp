// SPDX-License-Identifier: Apache-2.0
// The parts of core put together.
#include "viewer/core/viewer.hpp"

#include "viewer/core/handles.hpp"

#include <fmt/format.h>

#include <cmath>

namespace feelem::viewer {
namespace {

std::string plain_text(double value, std::string_view unit) {
    if (std::isnan(value)) return "no value";
    return unit.empty() ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

}  // namespace

Viewer::Viewer(ModelSource source)
    : model(std::move(source)), state(first_state(model)), prober(model), value_text(plain_text) {}

void update(Viewer& viewer, const FrameInput& input) {
    interact(viewer.interaction, viewer.state, viewer.model, viewer.prober, input);
}

void run(Viewer& viewer, Command command) {
    const auto pointer = leading(viewer.interaction);
    Circumstances now{viewer.interaction.was_headset, viewer.interaction.chosen};
    if (pointer) {
        const auto& hit = viewer.interaction.pointers[static_cast<std::size_t>(*pointer)].hit;
        now.node = node_of(viewer.model, *hit);
    }
    run(viewer.state, viewer.model, command, now);
}

std::optional<glm::vec3> pressable(const Viewer& viewer, const Ray& ray) {
    for (const auto& knob : knobs_of(viewer.state, viewer.model)) {
        if (knob && distance_to_ray(ray, *knob) < knob_reach(ray, *knob, true)) return knob;
    }
    const Cast cast = viewer.prober.cast(ray);
    return cast.hit ? std::optional(cast.hit->world) : std::nullopt;
}

Look look_of(const Viewer& viewer, const FrameInput& input) {
    return make_look(viewer.state, viewer.model, input.is_headset);
}

Snapshot snapshot_of(Viewer& viewer, const FrameInput& input) {
    return make_snapshot(viewer.snapshots, viewer.interaction, viewer.state, viewer.model, input);
}

Overlay overlay_of(Viewer& viewer, const Snapshot& snapshot, const FrameInput& input) {
    std::span<const HotSpot> spots;
    if (viewer.state.hot.shown) spots = viewer.spots.of(viewer.state, viewer.model);
    return make_overlay(
        {viewer.state,
         viewer.model,
         viewer.prober,
         viewer.interaction,
         snapshot,
         input,
         spots,
         viewer.value_text}
    );
}

}  // namespace feelem::viewer
