// SPDX-License-Identifier: Apache-2.0
// The gamepad's motors as what shakes in a hand.
#pragma once

#include "viewer/desktop/window.hpp"
#include "viewer/haptics/haptic_sink.hpp"

namespace feelem::viewer {

/// The window must outlive it.
class PadHaptics : public HapticSink {
public:
    explicit PadHaptics(Window& window) : window_(window) {}
    bool pulse(double amplitude, double milliseconds) override;
    void stop() override;

private:
    Window& window_;
};

}  // namespace feelem::viewer
