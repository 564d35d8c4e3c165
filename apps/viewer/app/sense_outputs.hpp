// SPDX-License-Identifier: Apache-2.0
// Ear and hand: what a snapshot sounds and feels like, played by whatever is there.
#pragma once

#include "viewer/audio/audio_output.hpp"
#include "viewer/core/viewer_state.hpp"
#include "viewer/haptics/haptics.hpp"

#include <array>
#include <string>
#include <vector>

namespace feelem::viewer {

class SenseOutputs {
public:
    explicit SenseOutputs(const SoundOutputOptions& sound)
        : output_(engine_, sound), wants_device_(sound.device == SoundDevice::Standard) {}

    /// Who shakes in a hand; null: nobody.
    void set_sink(Side side, HapticSink* sink);
    /// Once a frame; gives the pulses that were sent.
    std::vector<SentPulse> play(const Snapshot& snapshot, const ViewerState& state, bool is_focused);
    /// Silence and stillness: the program ends, or the scene goes.
    void stop();
    /// What has sounded since the last call, where SoundOutputOptions::keep was set.
    std::vector<float> take_sound() { return output_.take(); }
    /// Sentences for people; empty: nothing to say.
    std::string sound_trouble() const;
    std::string touch_trouble() const;

private:
    AudioEngine engine_;
    AudioOutput output_;
    bool wants_device_ = true;
    Haptics haptics_;
    std::array<HapticSink*, kSides>
        sinks_{};  ///< One that refused is not asked again until another one comes.
};

}  // namespace feelem::viewer
