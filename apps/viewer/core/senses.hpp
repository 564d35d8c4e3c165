// SPDX-License-Identifier: Apache-2.0
// What is to be heard and felt now: made by core from the snapshot of a frame, played by audio and haptics.
#pragma once

#include "viewer/core/input.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace feelem::viewer {

/// The page's SoundFrame (web/src/sense/audio.ts).
struct SoundFrame {
    double hz = 0;
    double gain = 0;        ///< Equal-loudness gain, 0..1; 0: no tone.
    bool negative = false;  ///< The hollow tone.
    double tick_rate = 0;   ///< Hz; 0: none.
    glm::vec3 source{
        0,
        0,
        -1};  ///< Place of what sounds, metres, in the axes of the head. Direction only; carries no value.
    bool tremolo = false;  ///< Beyond the limit.
    bool dull = false;     ///< Below the range.
    bool still = false;    ///< Neither place nor value has changed to speak of.
};

/// The page's HapticFrame (web/src/sense/haptics.ts).
struct HapticFrame {
    double rate = 0;       ///< Pulses a second; 0: none.
    double amplitude = 0;  ///< 0..1
    double milliseconds = 35;
    bool alarm = false;  ///< Beyond the limit: a quarter faster, up to 10 Hz.
    bool still = false;
};

/// Names and weights as web/src/sense/earcons.ts has them.
enum class SenseEvent : std::uint8_t {
    LimitUp,
    LimitDown,
    Maximum,
    Minimum,
    NoValue,
    BandUp,
    BandDown,
    Enter,
};
std::string_view word(SenseEvent event);  ///< "limitUp"

}  // namespace feelem::viewer
