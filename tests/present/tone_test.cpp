// SPDX-License-Identifier: Apache-2.0
// What is heard and felt: pitch, loudness, ticks, pulses.
#include "feelem/present.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace feelem {
namespace {

constexpr ValueRange kUnit{0, 1, Scale::Linear};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double decibel(double gain) {
    return 20 * std::log10(gain);
}

TEST(Tone, runs_from_c3_to_c6_in_equal_semitones) {
    EXPECT_NEAR(tone_of(0, kUnit, {}).hz, 130.8128, 1e-4);
    EXPECT_NEAR(tone_of(0.25, kUnit, {}).hz, 220, 1e-9);
    EXPECT_NEAR(tone_of(7.0 / 12, kUnit, {}).hz, 440, 1e-9);
    EXPECT_NEAR(tone_of(1, kUnit, {}).hz, 1046.5023, 1e-4);
}

TEST(Tone, A1_pitch_grows_strictly_with_the_value) {
    double last = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double hz = tone_of(i / 1000.0, kUnit, {}).hz;
        EXPECT_GT(hz, last);
        last = hz;
    }
}

TEST(Tone, A2_two_hundredths_of_the_range_are_more_than_one_and_a_half_noticeable_differences) {
    double least = kInfinity;
    for (int i = 0; i <= 980; ++i) {
        const double hz = tone_of(i / 1000.0, kUnit, {}).hz;
        const double step_cents = 1200 * std::log2(tone_of((i + 20) / 1000.0, kUnit, {}).hz / hz);
        const double critical_band = 25 + 75 * std::pow(1 + 1.4 * std::pow(hz / 1000, 2), 0.69);
        const double noticeable_cents = 1200 * std::log2(1 + critical_band / 30 / hz);
        EXPECT_GE(step_cents / noticeable_cents, 1.5) << i;
        least = std::min(least, step_cents / noticeable_cents);
    }
    RecordProperty("measured", fmt::format("{:.3f} noticeable differences", least));
}

TEST(Tone, gain_falls_with_pitch_as_the_ear_grows_keener) {
    EXPECT_NEAR(decibel(tone_of(0, kUnit, {}).gain), 0, 0.05);
    EXPECT_NEAR(decibel(tone_of(0.25, kUnit, {}).gain), -4.5, 0.1);
    EXPECT_NEAR(decibel(tone_of(0.5, kUnit, {}).gain), -7.7, 0.1);
    EXPECT_NEAR(decibel(tone_of(0.75, kUnit, {}).gain), -9.5, 0.1);
    EXPECT_NEAR(decibel(tone_of(1, kUnit, {}).gain), -10.6, 0.1);
}

TEST(Tone, missing_value_is_silent) {
    EXPECT_EQ(tone_of(kNaN, kUnit, {}).gain, 0);
    EXPECT_EQ(tone_of(kNaN, kUnit, {}).hz, 0);
    EXPECT_EQ(tick_rate_of(kNaN, kUnit, {}), 0);
    EXPECT_EQ(pulse_of(kNaN, kUnit, {}).rate, 0);
    EXPECT_EQ(pulse_of(kNaN, kUnit, {}).amplitude, 0);
}

TEST(Tone, inversion_and_gamma_shape_the_curve) {
    PitchEffect inverted;
    inverted.invert = true;
    PitchEffect curved;
    curved.gamma = 2;

    EXPECT_EQ(tone_of(0, kUnit, inverted).hz, tone_of(1, kUnit, {}).hz);
    EXPECT_NEAR(tone_of(0.5, kUnit, curved).hz, tone_of(0.25, kUnit, {}).hz, 1e-9);
}

TEST(Tone, quantised_pitch_lands_on_notes) {
    PitchEffect semitones;
    semitones.quantise = Quantise::Semitone;
    PitchEffect pentatonic;
    pentatonic.quantise = Quantise::Pentatonic;

    EXPECT_NEAR(tone_of(9.4 / 36, kUnit, semitones).hz, 220, 1e-9);
    EXPECT_NEAR(tone_of(5.1 / 36, kUnit, pentatonic).hz, 440 * std::exp2((48 + 4 - 69) / 12.0), 1e-9);
    EXPECT_NEAR(tone_of(11.5 / 36, kUnit, pentatonic).hz, 440 * std::exp2((60 - 69) / 12.0), 1e-9);
}

TEST(Tone, negative_values_of_a_signed_result_sound_hollow_at_the_same_pitch) {
    const ValueRange range{-10, 10, Scale::Signed};

    const Tone tension = tone_of(4, range, {});
    const Tone pressure = tone_of(-4, range, {});

    EXPECT_FALSE(tension.negative);
    EXPECT_TRUE(pressure.negative);
    EXPECT_EQ(tension.hz, pressure.hz);
    EXPECT_FALSE(tone_of(-4, {-10, 10, Scale::Linear}, {}).negative);
    PitchEffect plain;
    plain.sign_timbre = false;
    EXPECT_FALSE(tone_of(-4, range, plain).negative);
}

TEST(Ticks, rate_runs_from_one_and_a_half_to_twelve_by_equal_ratios) {
    EXPECT_DOUBLE_EQ(tick_rate_of(0, kUnit, {}), 1.5);
    EXPECT_DOUBLE_EQ(tick_rate_of(1.0 / 3, kUnit, {}), 3);
    EXPECT_DOUBLE_EQ(tick_rate_of(2.0 / 3, kUnit, {}), 6);
    EXPECT_DOUBLE_EQ(tick_rate_of(1, kUnit, {}), 12);
    EXPECT_DOUBLE_EQ(tick_rate_of(0, kUnit, {.invert = true}), 12);
}

TEST(Pulses, H1_rate_and_strength_grow_strictly_and_a_seventh_of_the_range_is_felt) {
    Pulse last;
    for (int i = 0; i <= 1000; ++i) {
        const Pulse pulse = pulse_of(i / 1000.0, kUnit, {});
        EXPECT_GT(pulse.rate, last.rate);
        EXPECT_GT(pulse.amplitude, last.amplitude);
        last = pulse;
    }
    EXPECT_DOUBLE_EQ(pulse_of(0, kUnit, {}).rate, 2);
    EXPECT_DOUBLE_EQ(pulse_of(1, kUnit, {}).rate, 10);
    EXPECT_DOUBLE_EQ(pulse_of(0, kUnit, {}).amplitude, 0.15);
    EXPECT_DOUBLE_EQ(pulse_of(1, kUnit, {}).amplitude, 1);
    double least = kInfinity;
    for (int i = 0; i <= 850; ++i) {
        const double low = pulse_of(i / 1000.0, kUnit, {}).amplitude;
        const double high = pulse_of(i / 1000.0 + 0.15, kUnit, {}).amplitude;
        EXPECT_GE(decibel(high / low), 2.4);
        least = std::min(least, decibel(high / low));
    }
    RecordProperty("measured", fmt::format("{:.3f} dB", least));
}

}  // namespace
}  // namespace feelem
