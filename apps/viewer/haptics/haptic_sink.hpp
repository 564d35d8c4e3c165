// SPDX-License-Identifier: Apache-2.0
// Something that can shake: the motor of a controller or of a gamepad.
#pragma once

namespace feelem::viewer {

class HapticSink {
public:
    virtual ~HapticSink() = default;
    /// Amplitude 0..1. Replaces what still runs. False: nothing is felt, and the ear may stand in.
    virtual bool pulse(double amplitude, double milliseconds) = 0;
    virtual void stop() = 0;
};

}  // namespace feelem::viewer
