// SPDX-License-Identifier: Apache-2.0
// Value -> pitch of a tone that is equally loud everywhere (docs/effects.md 3).
#include "feelem/present.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace feelem {
namespace {

struct LoudnessPoint {
    double hz;
    double decibel;  ///< What a pure tone needs above one of 1 kHz to be as loud, at 60 phon (ISO 226:2003).
};
constexpr std::array<LoudnessPoint, 17> kEqualLoudness{{
    {100, 18.6},
    {125, 15.6},
    {160, 12.5},
    {200, 9.9},
    {250, 7.5},
    {315, 5.4},
    {400, 3.4},
    {500, 2.0},
    {630, 0.8},
    {800, -0.1},
    {1000, 0},
    {1250, 2.1},
    {1600, 3.2},
    {2000, 0},
    {2500, -2.8},
    {3150, -3.6},
    {4000, -2.4},
}};

double equal_loudness(double hz) {
    const double inside = std::clamp(hz, kEqualLoudness.front().hz, kEqualLoudness.back().hz);
    std::size_t i = 1;
    while (i + 1 < kEqualLoudness.size() && kEqualLoudness[i].hz < inside) {
        ++i;
    }
    const auto& [low_hz, low] = kEqualLoudness[i - 1];
    const auto& [high_hz, high] = kEqualLoudness[i];
    return low + (high - low) * std::log2(inside / low_hz) / std::log2(high_hz / low_hz);
}

/// Amplitude that makes the sum of the partials as loud as any other tone, before normalisation.
double loudness_gain(double hz, std::span<const double, 4> partials) {
    double power = 0;
    for (std::size_t i = 0; i < partials.size(); ++i) {
        const double amplitude = partials[i];
        power +=
            amplitude * amplitude * std::pow(10.0, -equal_loudness(hz * static_cast<double>(i + 1)) / 10);
    }
    return std::min(std::pow(10.0, 12.0 / 20), 1 / std::sqrt(power));
}

double hertz(double midi) {
    return 440 * std::exp2((midi - 69) / 12);
}

/// Largest gain of the effect's range: at its ends and on every semitone between them.
double largest_gain(const PitchEffect& effect) {
    const double low = std::clamp(std::min(effect.midi_low, effect.midi_high), 0.0, 127.0);
    const double high = std::clamp(std::max(effect.midi_low, effect.midi_high), 0.0, 127.0);
    double largest = loudness_gain(hertz(high), kTonePartials);
    for (double midi = low; midi < high; midi += 1) {
        largest = std::max(largest, loudness_gain(hertz(midi), kTonePartials));
    }
    return largest;
}

double quantised(double midi, Quantise quantise) {
    switch (quantise) {
    case Quantise::None: return midi;
    case Quantise::Semitone: return std::floor(midi + 0.5);
    case Quantise::Pentatonic: break;
    }
    const double octave = std::floor(midi / 12) * 12;
    double nearest = octave;
    for (const double step : {2.0, 4.0, 7.0, 9.0, 12.0}) {
        if (std::abs(octave + step - midi) < std::abs(nearest - midi)) {
            nearest = octave + step;
        }
    }
    return nearest;
}

}  // namespace

Tone tone_of(double value, const ValueRange& range, const PitchEffect& effect) {
    const Normalised place = normalise(value, range);
    if (place.missing) {
        return {};
    }
    const double share = std::pow(effect.invert ? 1 - place.u : place.u, effect.gamma);
    const double midi = effect.midi_low + (effect.midi_high - effect.midi_low) * share;
    Tone tone;
    tone.hz = hertz(quantised(midi, effect.quantise));
    tone.negative = range.scale == Scale::Signed && effect.sign_timbre && place.sign < 0;
    const double gain = loudness_gain(tone.hz, tone.negative ? kNegativePartials : kTonePartials);
    tone.gain = std::min(1.0, gain / largest_gain(effect));
    return tone;
}

}  // namespace feelem
