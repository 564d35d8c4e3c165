// SPDX-License-Identifier: Apache-2.0
// Line by line, each flushed.
#include "viewer/record/recording.hpp"

#include "feelem/convert.hpp"
#include "feelem/error.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace feelem::viewer {

namespace {

std::string made_folder(const std::string& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) {
        throw Error(
            Code::WriteFailed, folder, "the folder for the recording cannot be made: " + failed.message()
        );
    }
    return folder;
}

}  // namespace

Recording::Recording(const std::string& folder, const std::string& scene)
    : folder_(made_folder(folder)), lines_(folder + "/session.jsonl", std::ios::binary | std::ios::trunc),
      wav_(folder + "/sound.wav") {
    lines_
        << fmt::format(
               R"({{"format": "feelem-recording", "version": 1, "program": "feelem-xr {}", "scene": {}, "sound": "sound.wav"}})",
               version(),
               json_text(scene)
           )
        << '\n'
        << std::flush;
    if (!lines_) {
        throw Error(
            Code::WriteFailed,
            folder + "/session.jsonl",
            "the recording cannot be written here: is the folder writable?"
        );
    }
}

void Recording::add(
    const FrameInput& input,
    const Snapshot& snapshot,
    std::span<const SentPulse> pulses,
    std::span<const float> sound
) {
    const std::uint64_t heard_before = wav_.frames();
    const bool has_sound = wav_.add(sound);
    if (lines_) {
        std::string line = frame_line(input, snapshot, pulses);
        line.back() = ',';
        lines_ << line << fmt::format(R"( "soundFrom": {}, "soundTo": {}}})", heard_before, wav_.frames())
               << '\n'
               << std::flush;
    }
    if (!trouble_.empty()) return;
    if (!lines_) {
        trouble_ = "The recording in " + folder_ + " is not complete: is the disk full?";
    } else if (!has_sound) {
        trouble_ = "The sound in " + folder_ + " is not complete: the disk or the file is full";
    }
}

}  // namespace feelem::viewer
