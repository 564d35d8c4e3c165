// SPDX-License-Identifier: Apache-2.0
// Core for one scene, and the calls of a frame, in this order: update, look, snapshot, overlay.
//
//     input = device.poll();
//     update(viewer, input);
//     const Look look = look_of(viewer, input);
//     const Snapshot snapshot = snapshot_of(viewer, input);
//     renderer.draw(look, overlay_of(viewer, snapshot, input));
//     audio.update(snapshot); haptics.update(snapshot);
#pragma once

#include "viewer/core/interaction.hpp"
#include "viewer/core/overlay.hpp"
#include "viewer/core/probe.hpp"
#include "viewer/core/snapshot_maker.hpp"
#include "viewer/core/viewer_state.hpp"

namespace feelem::viewer {

/// Not to be moved: its parts know each other. Call prober.grow() before the first frame or on a thread of
/// its own; join that before this ends.
struct Viewer {
    explicit Viewer(ModelSource source);
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    ViewedModel model;
    ViewerState state;
    Prober prober;
    Interaction interaction;
    SnapshotMaker snapshots;
    HotSpotList spots;
    ValueText value_text;  ///< The app may put a better one in.
};

void update(Viewer& viewer, const FrameInput& input);
/// As update() runs those of its input: for panels.
void run(Viewer& viewer, Command command);
/// Where a press of the mouse would take something: the model, or the knob of a plane. World.
std::optional<glm::vec3> pressable(const Viewer& viewer, const Ray& ray);
Look look_of(const Viewer& viewer, const FrameInput& input);
/// Once a frame: events are said once.
Snapshot snapshot_of(Viewer& viewer, const FrameInput& input);
Overlay overlay_of(Viewer& viewer, const Snapshot& snapshot, const FrameInput& input);

}  // namespace feelem::viewer
