// SPDX-License-Identifier: Apache-2.0
// Which hand feels what.
#include "viewer/haptics/haptics.hpp"

namespace feelem::viewer {

namespace {

constexpr std::array<Side, kSides> kHands{Side::Left, Side::Right};

bool feels_events(const Snapshot& snapshot, Side side) {
    if (!snapshot.touch[static_cast<std::size_t>(side)]) return false;
    if (snapshot.pointer == Pointer::Left) return side == Side::Left;
    if (snapshot.pointer == Pointer::Right) return side == Side::Right;
    return true;
}

}  // namespace

void Haptics::set_sink(Side side, HapticSink* sink) {
    pulsers_[static_cast<std::size_t>(side)].set_sink(sink);
}

bool Haptics::was_refused(Side side) const {
    return pulsers_[static_cast<std::size_t>(side)].was_refused();
}

void Haptics::set_strength(double strength) {
    for (Pulser& pulser : pulsers_) pulser.set_strength(strength);
}

std::vector<SentPulse> Haptics::update(const Snapshot& snapshot) {
    std::vector<SentPulse> sent;
    for (const Side side : kHands) {
        Pulser& pulser = pulsers_[static_cast<std::size_t>(side)];
        pulser.update(snapshot.touch[static_cast<std::size_t>(side)]);
        if (feels_events(snapshot, side)) {
            for (const SenseEvent event : snapshot.events) pulser.event(event);
        }
        if (std::optional<SentPulse> pulse = pulser.tick(snapshot.time)) {
            pulse->side = side;
            sent.push_back(*pulse);
        }
    }
    return sent;
}

void Haptics::stop() {
    for (Pulser& pulser : pulsers_) pulser.stop();
}

}  // namespace feelem::viewer
