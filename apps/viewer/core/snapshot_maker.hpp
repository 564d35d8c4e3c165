// SPDX-License-Identifier: Apache-2.0
// From where the pointers are to what is seen, heard and felt: one snapshot a frame.
#pragma once

#include "viewer/core/guidance.hpp"
#include "viewer/core/interaction.hpp"
#include "viewer/core/snapshot.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace feelem::viewer {

/// Watches one result under one pointer. Entering the model beyond the limit counts as crossing it.
class EventWatch {
public:
    /// Beyond the limit now.
    bool beyond() const noexcept { return beyond_; }
    /// Once a frame. NaN: on the model, no value there.
    std::optional<SenseEvent> update(double value, const ValueRange& range, const PresentedResult& result);
    void left() noexcept;

private:
    bool beyond_ = false, missing_ = false;
};

/// Whether a pointer rests: place and values have not changed to speak of.
class Rest {
public:
    bool update(const Probed& probed, double size);

private:
    std::array<double, 3> place_{};
    std::vector<double> values_;
};

/// What is remembered from frame to frame.
struct SnapshotMaker {
    struct Hand {
        std::map<std::string, EventWatch> watches;
        Rest rest;
        bool on_model = false;
        std::optional<int> band;  ///< Of the coloured result, while held.
        bool at_maximum = false, at_minimum = false;
        bool on_top = false;  ///< While the ticks lead to the largest value: it has been said.
    };
    std::array<Hand, kPointers> pointers;  ///< By Pointer.
    std::map<SenseEvent, double> said;     ///< When each event came last.
    RankList ranks;
    std::uint64_t frame = 0;
};

/// The mouse's pulses are the right hand's: a gamepad lies in the other one.
Snapshot make_snapshot(
    SnapshotMaker& maker,
    const Interaction& interaction,
    const ViewerState& state,
    const ViewedModel& model,
    const FrameInput& input
);

}  // namespace feelem::viewer
