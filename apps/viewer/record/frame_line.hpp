// SPDX-License-Identifier: Apache-2.0
// A frame as one line of JSON (docs/recording.md).
#pragma once

#include "viewer/core/input.hpp"
#include "viewer/core/snapshot.hpp"
#include "viewer/haptics/pulser.hpp"

#include <span>
#include <string>
#include <string_view>

namespace feelem::viewer {

/// Without the end of the line. Numbers read back to the very bits; no value and no number is null.
std::string frame_line(const FrameInput& input, const Snapshot& snapshot, std::span<const SentPulse> pulses);
/// "text" with its quotes, what JSON asks for escaped.
std::string json_text(std::string_view text);

}  // namespace feelem::viewer
