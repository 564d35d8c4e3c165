// SPDX-License-Identifier: Apache-2.0
// When ticks sound: even in time at the rate of the moment. The twin of web/src/sense/tick-clock.ts, which
// has to plan ahead and take back; here the clock stands in the audio thread and simply asks.
#pragma once

#include <limits>

namespace feelem::viewer {

class TickClock {
public:
    /// Once a frame, with the rate from now on, in seconds of the sound's clock.
    void update(double now, double rate);
    void stop();
    /// Once a sample: true when a tick begins.
    bool begins(double now);

private:
    double rate_ = 0, period_ = 0;
    double last_ = -std::numeric_limits<double>::infinity();
    double next_ = 0;
    double until_ = 0;  ///< Ticks of a caller that has fallen silent end here.
};

}  // namespace feelem::viewer
