// SPDX-License-Identifier: Apache-2.0
// A session on disk: what was pointed at, said, felt and heard, frame by frame (docs/recording.md).
#pragma once

#include "viewer/record/frame_line.hpp"
#include "viewer/record/wav_file.hpp"

#include <cstdint>
#include <fstream>
#include <span>
#include <string>

namespace feelem::viewer {

class Recording {
public:
    /// Makes the folder and, in it, session.jsonl and sound.wav; what they held before is gone. `scene` is
    /// named in the first line. Throws Error(WriteFailed).
    Recording(const std::string& folder, const std::string& scene);

    /// Once a frame. `sound`: what was made since the last call, left, right, left, right, ... Each frame is
    /// with the system before this returns: a program that ends in the next keeps it.
    void add(
        const FrameInput& input,
        const Snapshot& snapshot,
        std::span<const SentPulse> pulses,
        std::span<const float> sound
    );
    /// A sentence when not all could be kept; empty: all is well.
    const std::string& trouble() const { return trouble_; }

private:
    std::string folder_;
    std::ofstream lines_;
    WavFile wav_;
    std::string trouble_;
};

}  // namespace feelem::viewer
