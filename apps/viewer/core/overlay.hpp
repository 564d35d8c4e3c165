// SPDX-License-Identifier: Apache-2.0
// Marks and texts in the room: reticle, rays of pointers, notes, extremes, hot spots, the bar and the ring.
#pragma once

#include "viewer/core/interaction.hpp"
#include "viewer/core/snapshot.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::viewer {

struct Overlay {
    std::vector<Mark> marks;
    std::vector<Label> labels;
};

/// A value with its unit as people read it.
using ValueText = std::function<std::string(double value, std::string_view unit)>;

/// What an overlay is made from.
struct OverlaySource {
    const ViewerState& state;
    const ViewedModel& model;
    const Prober& prober;
    const Interaction& interaction;
    const Snapshot& snapshot;
    const FrameInput& input;
    std::span<const HotSpot> spots;
    const ValueText& value_text;
};
Overlay make_overlay(const OverlaySource& source);

}  // namespace feelem::viewer
