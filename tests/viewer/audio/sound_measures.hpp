// SPDX-License-Identifier: Apache-2.0
// Measures on sampled sound, and what it takes to have some: an engine that is told a frame 72 times a
// second.
#pragma once

#include "viewer/audio/audio_engine.hpp"

#include "feelem/present.hpp"

#include <functional>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace feelem::test {

using Samples = std::vector<float>;

struct Stereo {
    Samples left, right;
};

double decibel(double ratio);
/// From second `from` to second `to`.
std::span<const float> part(std::span<const float> samples, double from, double to);
double peak(std::span<const float> samples);
double rms(std::span<const float> samples);
/// Amplitude of the component at a pitch (Hann window).
double amplitude_at(std::span<const float> samples, double hz);
/// Of a steady tone between 60 and 2200 Hz: autocorrelation, refined over up to 32 periods.
double fundamental(std::span<const float> samples);
/// Fourth-order Butterworth.
Samples high_passed(std::span<const float> samples, double hz);
/// Peak of what is above 12 kHz, where no voice has anything, in dBFS: what a click leaves there.
double click_level(std::span<const float> samples);
/// Seconds at which a burst begins: first sample above the level after 20 ms below it.
std::vector<double> onsets(std::span<const float> samples, double level);
/// Samples by which `right` comes after `left` (cross-correlation, refined); negative: before.
double lag_of(std::span<const float> left, std::span<const float> right);

/// A frame that sounds as a value at `u` of the standard range does, from ahead.
viewer::SoundFrame tone_frame(double u);

/// One engine and what it has put out so far.
class Listening {
public:
    explicit Listening(const viewer::AudioOptions& options = {.master = 1}, std::size_t block = 256);

    viewer::AudioEngine& engine() { return engine_; }
    double time() const { return static_cast<double>(heard_.left.size()) / viewer::kSoundRate; }
    /// Renders up to a time, block by block.
    void listen_until(double time);
    /// Says `frame(time)` 72 times a second from where the time stands; empty: no sound. Renders up to
    /// `time`.
    void frames_until(double time, const std::function<std::optional<viewer::SoundFrame>(double)>& frame);
    /// The same frame all the time.
    void hold_until(double time, const viewer::SoundFrame& frame);
    void say(const std::optional<viewer::SoundFrame>& frame, std::vector<viewer::SenseEvent> events = {});
    const Stereo& heard() const { return heard_; }

private:
    viewer::AudioEngine engine_;
    std::size_t block_;
    std::uint64_t frame_ = 0;
    Stereo heard_;
};

}  // namespace feelem::test
