// SPDX-License-Identifier: Apache-2.0
// Marks and texts in the room: reticle, rays of pointers, notes, extremes, hot spots, the bar and the ring.
#pragma once

#include "viewer/core/interaction.hpp"
#include "viewer/core/snapshot.hpp"

#include <span>
#include <vector>

namespace feelem::viewer {

struct Overlay {
    std::vector<Mark> marks;
    std::vector<Label> labels;
};

Overlay make_overlay(
    const ViewerState& state,
    const ViewedModel& model,
    const Prober& prober,
    const Interaction& interaction,
    const Snapshot& snapshot,
    std::span<const HotSpot> spots,
    const FrameInput& input
);

}  // namespace feelem::viewer
