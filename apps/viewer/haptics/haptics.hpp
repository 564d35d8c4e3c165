// SPDX-License-Identifier: Apache-2.0
// What both hands feel, from the snapshot of a frame.
#pragma once

#include "viewer/core/snapshot.hpp"
#include "viewer/haptics/pulser.hpp"

#include <array>
#include <vector>

namespace feelem::viewer {

class Haptics {
public:
    /// Who shakes in that hand; null: nobody. Not owned. A gamepad's sink may be set for either hand, or
    /// both.
    void set_sink(Side side, HapticSink* sink);
    /// The last pulse of that hand could not be felt: say it once; the ear stands in.
    bool was_refused(Side side) const;
    /// The person's own strength, 0..1.5.
    void set_strength(double strength);

    /// Once a frame; gives what was sent. A hand whose `touch` is empty is left in peace, events included: a
    /// frame with rate 0 lets events through without beats. Events are felt by the hand that points; by
    /// whoever has `touch` when that is no hand.
    std::vector<SentPulse> update(const Snapshot& snapshot);
    /// Still at once: lost focus, end of the session. Once or each frame.
    void stop();

private:
    std::array<Pulser, kSides> pulsers_;
};

}  // namespace feelem::viewer
