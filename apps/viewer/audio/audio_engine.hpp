// SPDX-License-Identifier: Apache-2.0
// What is heard: one tone, ticks and short earcons, from the snapshot of a frame. The frame's thread calls
// `update` and the setters, one other thread (or the same) calls `render`; neither ever waits for the other.
#pragma once

#include "viewer/core/snapshot.hpp"

#include <memory>
#include <span>
#include <string>

namespace feelem::viewer {

inline constexpr int kSoundRate = 48000;

struct AudioOptions {
    double master = 0.5;  ///< 0..1
    bool mono = false;    ///< The same in both ears.
};

class AudioEngine {
public:
    explicit AudioEngine(const AudioOptions& options = {});
    ~AudioEngine();
    AudioEngine(const AudioEngine&) = delete;
    AudioEngine& operator=(const AudioEngine&) = delete;

    /// Once a frame. Without focus: silence within 50 ms. Without a call for 0.6 s the voices release by
    /// themselves.
    void update(const Snapshot& snapshot, bool is_focused);
    /// Silence within 50 ms: the viewer leaves.
    void stop();
    void set_muted(bool muted);
    void set_master(double master);
    void set_mono(bool mono);

    /// Puts the next samples into `stereo`: left, right, left, right, ... at kSoundRate. Never waits or
    /// allocates.
    void render(std::span<float> stereo);

    /// How directions are made, in words: "HRTF default-48000", "panned", "centred".
    const std::string& directions() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::viewer
