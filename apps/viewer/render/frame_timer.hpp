// SPDX-License-Identifier: Apache-2.0
// How long the card took for a frame, asked some frames later, so that nothing waits for the answer.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace feelem::viewer {

/// All calls with the same OpenGL context current.
class FrameTimer {
public:
    FrameTimer() = default;
    ~FrameTimer();
    FrameTimer(const FrameTimer&) = delete;
    FrameTimer& operator=(const FrameTimer&) = delete;

    void begin();
    void end();
    /// Seconds of a frame that was not yet told; empty: none has come in since.
    std::optional<double> take();

private:
    static constexpr std::size_t kFrames = 4;      ///< That may be on their way.
    std::array<unsigned, 2 * kFrames> queries_{};  ///< Moments: Mesa's software renderer counts no spans.
    std::size_t begun_ = 0, taken_ = 0;
    bool is_open_ = false;
};

}  // namespace feelem::viewer
