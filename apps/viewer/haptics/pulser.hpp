// SPDX-License-Identifier: Apache-2.0
// The vibration engine of one hand: pulses whose rate and strength say the value. The twin of the page's
// (web/src/sense/haptics.ts): both keep to tests/contract/pulses.json. Time is handed in.
#pragma once

#include "viewer/core/senses.hpp"
#include "viewer/haptics/haptic_sink.hpp"

#include <cstddef>
#include <limits>
#include <optional>

namespace feelem::viewer {

struct SentPulse {
    double time = 0;  ///< Seconds, of the clock of `tick`.
    Side side = Side::Right;
    double strength = 0;  ///< 0..1, the person's own strength applied.
    double milliseconds = 0;
    std::optional<SenseEvent> event;  ///< Empty: a beat of the value.
};

class Pulser {
public:
    /// Who shakes; null: nobody. Not owned.
    void set_sink(HapticSink* sink);
    bool has_sink() const { return sink_ != nullptr; }
    /// Of the last pulse: the sink could not be felt.
    bool was_refused() const { return was_refused_; }
    /// The person's own strength, 0..1.5.
    void set_strength(double strength);

    /// What the next ticks send; empty: nothing.
    void update(const std::optional<HapticFrame>& frame);
    /// Queues an event; those of the limit push aside everything else for 250 ms. NoValue is not felt.
    void event(SenseEvent event);
    /// Once a frame, in seconds of a clock that never goes back. Sends at most one pulse.
    std::optional<SentPulse> tick(double now);
    /// Still at once, nothing more: release, lost focus, end of the session. Once or each frame.
    void stop();

private:
    static constexpr double kNever = std::numeric_limits<double>::infinity();
    struct Queued {
        SenseEvent event;
        std::optional<double> start;
        std::size_t sent = 0;
    };
    struct Beat {
        double period = 0, share = 1;
    };
    Beat beat_of(const HapticFrame& frame, double now);
    /// True: the event has this moment to itself.
    bool tick_event(double now, std::optional<SentPulse>& sent);
    std::optional<SentPulse> send(
        double now, double strength, double milliseconds, std::optional<SenseEvent> event
    );

    void still();

    HapticSink* sink_ = nullptr;
    bool may_shake_ = false;  ///< A pulse was sent since the sink was last told to stop.
    bool was_refused_ = false;
    std::optional<HapticFrame> frame_;
    double strength_ = 1;
    double now_ = -kNever, last_ = -kNever, next_ = -kNever;
    double busy_until_ = -kNever;  ///< Until then only the limit may speak: the hand needs its rest.
    double period_ = 0;
    double still_since_ = kNever;
    double held_until_ = -kNever;
    std::optional<Queued> event_;
};

}  // namespace feelem::viewer
