// SPDX-License-Identifier: Apache-2.0
// Where the engine's sound goes: the sound device, or nobody, and beside either a recording.
#pragma once

#include "viewer/audio/audio_engine.hpp"

#include <memory>
#include <string>
#include <vector>

namespace feelem::viewer {

enum class SoundDevice : std::uint8_t {
    Standard,  ///< The system's; when it goes, another is looked for every 2 s.
    None,      ///< Only the clock of `update` drives the sound: same times, same samples.
};

struct SoundOutputOptions {
    SoundDevice device = SoundDevice::Standard;
    bool keep = false;  ///< For `take`.
};

class AudioOutput {
public:
    /// The engine must outlive it; from now on nobody else may call its `render`.
    explicit AudioOutput(AudioEngine& engine, const SoundOutputOptions& options = {});
    ~AudioOutput();
    AudioOutput(const AudioOutput&) = delete;
    AudioOutput& operator=(const AudioOutput&) = delete;

    /// Once a frame, in seconds of a clock that never goes back: looks after the device; where there is none,
    /// the sound goes on unheard.
    void update(double time);
    /// False: there is no device now.
    bool is_heard() const;
    /// What the system said when it had no device; empty: nothing to tell.
    const std::string& trouble() const;
    /// What has sounded since the last call: left, right, left, right, ...; empty unless `keep`.
    std::vector<float> take();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::viewer
