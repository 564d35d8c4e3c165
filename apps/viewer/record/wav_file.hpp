// SPDX-License-Identifier: Apache-2.0
// Sound into a WAV file that can be played at any moment, even if the program ends in the next.
#pragma once

#include <cstdint>
#include <fstream>
#include <span>
#include <string>

namespace feelem::viewer {

/// Stereo, 48 kHz, 32-bit float: every sample as it was made.
class WavFile {
public:
    /// Throws Error(WriteFailed).
    explicit WavFile(const std::string& path);
    /// Left, right, left, right, ... Puts the header right at once. False: the disk is full, or the file is
    /// at the 4 GiB that its format allows (3 hours); nothing more is kept.
    bool add(std::span<const float> stereo);
    std::uint64_t frames() const { return frames_; }

private:
    void put_header();
    std::ofstream file_;
    std::uint64_t frames_ = 0;
    bool is_full_ = false;
};

}  // namespace feelem::viewer
