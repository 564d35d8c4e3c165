// SPDX-License-Identifier: Apache-2.0
// One call a beat, because the calls of every vibration interface override each other.
#include "viewer/haptics/pulser.hpp"

#include <algorithm>
#include <span>

namespace feelem::viewer {

namespace {

constexpr double kShortestGap = 0.08;
constexpr double kLongestPulse = 200;
constexpr double kLargestDuty = 0.45;
constexpr double kFastestAlarm = 10;
constexpr double kStillAfter = 1.5;
constexpr double kLimitHolds = 0.25;

struct EventPulse {
    double delay;  ///< After the first of its event, seconds.
    double strength, milliseconds;
};
constexpr EventPulse kLimitUpPulses[] = {{0, 1, 60}, {0.12, 1, 60}};
constexpr EventPulse kLimitDownPulses[] = {{0, 0.4, 40}};
constexpr EventPulse kMaximumPulses[] = {{0, 0.8, 80}};
constexpr EventPulse kMinimumPulses[] = {{0, 0.3, 80}};
constexpr EventPulse kBandPulses[] = {{0, 0.35, 20}};
constexpr EventPulse kEnterPulses[] = {{0, 0.2, 15}};

std::span<const EventPulse> pulses_of(SenseEvent event) {
    switch (event) {
    case SenseEvent::LimitUp: return kLimitUpPulses;
    case SenseEvent::LimitDown: return kLimitDownPulses;
    case SenseEvent::Maximum: return kMaximumPulses;
    case SenseEvent::Minimum: return kMinimumPulses;
    case SenseEvent::BandUp:
    case SenseEvent::BandDown: return kBandPulses;
    case SenseEvent::Enter: return kEnterPulses;
    case SenseEvent::NoValue: break;
    }
    return {};
}

bool is_of_limit(SenseEvent event) {
    return event == SenseEvent::LimitUp || event == SenseEvent::LimitDown;
}

}  // namespace

void Pulser::set_sink(HapticSink* sink) {
    if (sink == sink_) return;
    still();
    sink_ = sink;
    was_refused_ = false;
}

void Pulser::set_strength(double strength) {
    strength_ = std::clamp(strength, 0.0, 1.5);
}

void Pulser::update(const std::optional<HapticFrame>& frame) {
    if (!frame || !(frame->rate > 0)) {
        frame_.reset();
        period_ = 0;
        still_since_ = kNever;
        return;
    }
    frame_ = frame;
    if (!frame->still) still_since_ = kNever;
}

void Pulser::event(SenseEvent event) {
    if (pulses_of(event).empty()) return;
    if (!is_of_limit(event) && (event_ || now_ < held_until_)) return;
    event_ = Queued{event, std::nullopt, 0};
}

void Pulser::stop() {
    update(std::nullopt);
    event_.reset();
    held_until_ = -kNever;
    still();
}

void Pulser::still() {
    if (sink_ && may_shake_) sink_->stop();
    may_shake_ = false;
}

std::optional<SentPulse> Pulser::tick(double now) {
    now_ = now;
    std::optional<SentPulse> sent;
    if (tick_event(now, sent) || now < held_until_ || !frame_) return sent;
    const Beat beat = beat_of(*frame_, now);
    if (beat.period != period_) {
        // A new rate counts from the last pulse: it is felt within a frame.
        next_ = period_ == 0 ? now : std::min(next_, last_ + beat.period);
        period_ = beat.period;
    }
    if (now < next_ || now < busy_until_) return sent;
    const double longest = std::min(kLongestPulse, 1000 * kLargestDuty * std::max(beat.period, kShortestGap));
    sent = send(now, frame_->amplitude * beat.share, std::min(frame_->milliseconds, longest), std::nullopt);
    // Adding the period to the planned time, not to this frame's, keeps the rate right on average.
    next_ += beat.period;
    if (next_ < now) next_ = now + beat.period;
    return sent;
}

Pulser::Beat Pulser::beat_of(const HapticFrame& frame, double now) {
    if (frame.still) still_since_ = std::min(still_since_, now);
    if (now - still_since_ >= kStillAfter) return {1, 0.5};
    const double rate =
        frame.alarm ? std::max(frame.rate, std::min(1.25 * frame.rate, kFastestAlarm)) : frame.rate;
    return {1 / rate, 1};
}

bool Pulser::tick_event(double now, std::optional<SentPulse>& sent) {
    if (!event_) return false;
    const SenseEvent event = event_->event;
    if (!event_->start) {
        if (!is_of_limit(event) && now < busy_until_) return false;
        event_->start = now;
        if (is_of_limit(event)) held_until_ = now + kLimitHolds;
    }
    const std::span<const EventPulse> pulses = pulses_of(event);
    const EventPulse& pulse = pulses[event_->sent];
    if (now < *event_->start + pulse.delay) return true;
    sent = send(now, pulse.strength, pulse.milliseconds, event);
    event_->sent++;
    if (event_->sent == pulses.size()) event_.reset();
    return true;
}

std::optional<SentPulse> Pulser::send(
    double now, double strength, double milliseconds, std::optional<SenseEvent> event
) {
    last_ = now;
    busy_until_ = now + std::max(kShortestGap, milliseconds / 1000 / kLargestDuty);
    const double felt = std::min(strength * strength_, 1.0);
    if (!sink_ || !(felt > 0)) return std::nullopt;
    was_refused_ = !sink_->pulse(felt, milliseconds);
    if (was_refused_) return std::nullopt;
    may_shake_ = true;
    return SentPulse{now, Side::Right, felt, milliseconds, event};
}

}  // namespace feelem::viewer
