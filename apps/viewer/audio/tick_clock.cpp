// SPDX-License-Identifier: Apache-2.0
// The part of a beat that is still to go keeps its share when the rate changes.
#include "viewer/audio/tick_clock.hpp"

#include <algorithm>

namespace feelem::viewer {

namespace {

constexpr double kAhead = 0.25;             // Longer than a slow frame.
constexpr double kShortestInterval = 0.08;  // Whatever is asked.

}  // namespace

void TickClock::update(double now, double rate) {
    if (!(rate > 0)) {
        stop();
        return;
    }
    if (rate_ == 0) {
        next_ = std::max(now, last_ + kShortestInterval);
    } else if (rate != rate_) {
        const double share = std::clamp((next_ - now) * rate_, 0.0, 1.0);
        next_ = std::max(now + share / rate, last_ + kShortestInterval);
    }
    rate_ = rate;
    period_ = std::max(1 / rate, kShortestInterval);
    next_ = std::max(next_, now);
    until_ = now + kAhead;
}

void TickClock::stop() {
    rate_ = 0;
}

bool TickClock::begins(double now) {
    if (rate_ == 0 || now < next_ || next_ >= until_) return false;
    last_ = next_;
    next_ += period_;
    return true;
}

}  // namespace feelem::viewer
