// SPDX-License-Identifier: Apache-2.0
// Short sounds with one meaning each (docs/effects.md): limit crossed, no value, largest and smallest value.
// Pitches, levels and weights are those of web/src/sense/earcons.ts.
#pragma once

#include "viewer/audio/glide.hpp"
#include "viewer/core/senses.hpp"

#include <array>
#include <cstddef>

namespace feelem::viewer {

struct Earcon {
    int weight = 0;  ///< Of two at once the heavier sounds.
    double decibel = 0;
    double beep_seconds = 0, gap_seconds = 0;
    std::array<double, 2> pitches{};
    std::size_t beeps = 1;

    double seconds() const {
        const auto count = static_cast<double>(beeps);
        return count * beep_seconds + (count - 1) * gap_seconds;
    }
};
const Earcon& earcon_of(SenseEvent event);

/// Which earcons sound, and their samples.
class EarconPlayer {
public:
    /// False: too soon after the last of its kind, or one of no less weight sounds.
    bool play(SenseEvent event, SoundTime now);
    /// Nothing sounds any more, and nothing has weight.
    void silence(SoundTime now);
    double next(SoundTime now);

private:
    struct Sounding {
        SenseEvent event{};
        SoundTime start = 0, end = 0;
    };
    std::array<Sounding, 8> sounding_{};
    std::size_t count_ = 0;
    std::array<SoundTime, 8> last_{};
    std::array<bool, 8> was_played_{};
    SoundTime ends_ = 0;
    int weight_ = 0;
};

}  // namespace feelem::viewer
