// SPDX-License-Identifier: Apache-2.0
// Something in one hand that can shake: an OpenXR controller, a gamepad, or a list in a test.
#pragma once

namespace feelem::viewer {

class HapticSink {
public:
    virtual ~HapticSink() = default;
    /// Shakes once, in place of what still runs. Amplitude 0..1, at most 200 ms. False: nothing is felt, and
    /// the ear may stand in.
    virtual bool pulse(double amplitude, double milliseconds) = 0;
    /// Still at once.
    virtual void stop() = 0;

protected:
    HapticSink() = default;
    HapticSink(const HapticSink&) = default;
    HapticSink& operator=(const HapticSink&) = default;
};

}  // namespace feelem::viewer
