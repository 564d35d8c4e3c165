// SPDX-License-Identifier: Apache-2.0
// Pulses on a gamepad.
#include "viewer/desktop/pad_haptics.hpp"

#include <algorithm>
#include <cmath>

namespace feelem::viewer {
namespace {

/// The heavy motor takes longer than a pulse to come up; it lends weight to the strong ones.
constexpr double kHeavyShare = 0.5;
constexpr double kLongestPulse = 200;

}  // namespace

bool PadHaptics::pulse(double amplitude, double milliseconds) {
    const auto strength = static_cast<float>(std::clamp(amplitude, 0.0, 1.0));
    const auto duration =
        static_cast<std::uint32_t>(std::lround(std::clamp(milliseconds, 0.0, kLongestPulse)));
    return window_.rumble(strength * static_cast<float>(kHeavyShare), strength, duration);
}

void PadHaptics::stop() {
    window_.rumble(0, 0, 0);
}

}  // namespace feelem::viewer
