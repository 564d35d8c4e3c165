// SPDX-License-Identifier: Apache-2.0
// Ticks and earcons: when they come, how high, how loud.
#include "viewer/audio/sound_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace feelem::test {
namespace {

using viewer::SenseEvent;
using viewer::SoundFrame;

constexpr viewer::AudioOptions kLoud{.master = 1, .mono = true};

SoundFrame ticking(double rate) {
    SoundFrame frame;
    frame.tick_rate = rate;
    return frame;
}

TEST(TickSound, a_steady_value_keeps_the_rate_of_the_formula_within_2_percent) {
    double worst = 0;
    for (int i = 0; i <= 10; ++i) {
        const double rate = tick_rate_of(i / 10.0, {0, 1, Scale::Linear}, {});
        Listening listening(kLoud);
        listening.hold_until(6, ticking(rate));
        const std::vector<double> times = onsets(listening.heard().left, 0.05);
        ASSERT_GT(static_cast<double>(times.size()), 6 * rate - 2);
        for (std::size_t k = 1; k < times.size(); ++k) {
            worst = std::max(worst, std::abs((times[k] - times[k - 1]) * rate - 1));
        }
    }
    EXPECT_LE(worst, 0.02);
    printf("measured ticks: steady beats within %.3f %%\n", 100 * worst);
}

TEST(TickSound, whatever_is_asked_ticks_keep_80_ms_apart) {
    std::minstd_rand random(11);
    double rate = 0;
    const std::array<std::function<double(int)>, 4> ways{
        [&](int) { return 1.5 * std::pow(8.0, static_cast<double>(random() % 1000) / 999); },
        [&](int i) {
            if (i % 22 == 0) rate = 1.5 * std::pow(8.0, static_cast<double>(random() % 1000) / 999);
            return rate;
        },
        [](int i) { return i / 3 % 2 ? 12.0 : 0.0; },
        [](int) { return 40.0; },
    };
    for (const auto& way : ways) {
        Listening listening(kLoud);
        int i = 0;
        listening.frames_until(10, [&](double) { return ticking(way(i++)); });
        const std::vector<double> times = onsets(listening.heard().left, 0.03);
        ASSERT_GT(times.size(), 20U);
        for (std::size_t k = 1; k < times.size(); ++k) EXPECT_GE(times[k] - times[k - 1], 0.08 - 2.0 / 48000);
    }
}

TEST(TickSound, ticks_have_the_same_peak_in_both_ears_from_ahead_as_in_mono) {
    Listening ahead({.master = 1}), mono(kLoud);
    ahead.hold_until(1, ticking(8));
    mono.hold_until(1, ticking(8));
    EXPECT_NEAR(decibel(rms(ahead.heard().left) / rms(mono.heard().left)), 0, 1);
    EXPECT_NEAR(peak(mono.heard().left), 0.2 / std::sqrt(2.0), 0.001);
}

TEST(TickSound, the_band_of_the_ticks_is_free_of_the_tone) {
    Listening ticks(kLoud), tone(kLoud);
    ticks.hold_until(1, ticking(8));
    tone.hold_until(1, tone_frame(1));
    const double start = onsets(ticks.heard().left, 0.05).at(3);
    const auto in_band = [&](const Samples& x) {
        Samples band = high_passed(x, 2200);
        const Samples beyond = high_passed(x, 4600);
        for (std::size_t i = 0; i < band.size(); ++i) band[i] -= beyond[i];
        return rms(part(band, start, start + 0.01));
    };
    EXPECT_GE(decibel(in_band(ticks.heard().left) / in_band(tone.heard().left)), 10);
}

/// An event after half a second of silence, and half a second more.
Stereo earcon(SenseEvent event) {
    Listening listening(kLoud);
    listening.listen_until(0.5);
    listening.say(std::nullopt, {event});
    listening.listen_until(1);
    return listening.heard();
}

struct Expected {
    SenseEvent event;
    double decibel, seconds, from, hz;
};

TEST(EarconSound, each_has_its_pitch_its_level_and_its_length_in_both_ears) {
    const double third = std::exp2(4.0 / 12);
    // Beeps start at the step after the event.
    const std::vector<Expected> all{
        {SenseEvent::LimitUp, -14, 0.18, 0.015, 1500},
        {SenseEvent::LimitUp, -14, 0.18, 0.135, 1500},
        {SenseEvent::LimitDown, -14, 0.06, 0.015, 750},
        {SenseEvent::Maximum, -18, 0.18, 0.02, 880},
        {SenseEvent::Maximum, -18, 0.18, 0.11, 880 * third},
        {SenseEvent::Minimum, -18, 0.18, 0.11, 880 / third},
        {SenseEvent::NoValue, -18, 0.06, 0.015, 110},
        {SenseEvent::Enter, -30, 0.03, 0.0125, 500},
    };
    for (const Expected& e : all) {
        const Stereo heard = earcon(e.event);
        EXPECT_EQ(heard.left, heard.right) << "from nowhere";
        const double length = e.event == SenseEvent::Enter ? 0.008 : 0.03;
        const auto steady = part(heard.left, 0.5 + e.from, 0.5 + e.from + length);
        EXPECT_NEAR(decibel(peak(steady)), e.decibel, 0.5) << word(e.event);
        EXPECT_EQ(peak(part(heard.left, 0, 0.5)), 0);
        EXPECT_EQ(peak(part(heard.left, 0.5 + e.seconds + 0.003, 1)), 0) << word(e.event);
        EXPECT_LE(click_level(heard.left), -60) << word(e.event);
        if (e.hz < 300 || length < 0.02) continue;
        EXPECT_GT(amplitude_at(steady, e.hz), 3 * amplitude_at(steady, e.hz * 1.3)) << word(e.event);
        EXPECT_GT(amplitude_at(steady, e.hz), 3 * amplitude_at(steady, e.hz / 1.3)) << word(e.event);
    }
    EXPECT_NEAR(decibel(peak(earcon(SenseEvent::BandUp).left)), -26, 1);
}

TEST(EarconSound, crossing_the_limit_beeps_twice_and_not_again_within_half_a_second) {
    Listening listening(kLoud);
    listening.listen_until(0.5);
    listening.say(std::nullopt, {SenseEvent::LimitUp});
    listening.listen_until(0.8);
    listening.say(std::nullopt, {SenseEvent::LimitUp});
    listening.listen_until(1.2);
    EXPECT_EQ(onsets(listening.heard().left, 0.05).size(), 2U);
    EXPECT_EQ(peak(part(listening.heard().left, 0.75, 1.2)), 0);
    listening.say(std::nullopt, {SenseEvent::LimitUp});
    listening.listen_until(1.6);
    EXPECT_EQ(onsets(listening.heard().left, 0.05).size(), 4U);
}

TEST(EarconSound, one_of_less_weight_gives_way_to_one_that_sounds) {
    Listening both(kLoud);
    both.listen_until(0.5);
    both.say(std::nullopt, {SenseEvent::LimitUp});
    both.listen_until(0.55);
    both.say(std::nullopt, {SenseEvent::NoValue});
    both.listen_until(1);
    EXPECT_EQ(both.heard().left, earcon(SenseEvent::LimitUp).left);
}

TEST(EarconSound, the_tone_steps_back_by_6_decibels_while_one_sounds) {
    Listening with(kLoud), without(kLoud);
    const SoundFrame tone = tone_frame(0);
    for (Listening* listening : {&with, &without}) {
        listening->hold_until(0.5, tone);
        listening->say(
            tone, listening == &with ? std::vector{SenseEvent::Maximum} : std::vector<SenseEvent>{}
        );
        listening->hold_until(1.2, tone);
    }
    const auto tone_at = [&](Listening& listening, double from, double to) {
        return amplitude_at(part(listening.heard().left, from, to), tone.hz);
    };
    EXPECT_NEAR(decibel(tone_at(with, 0.56, 0.67) / tone_at(without, 0.56, 0.67)), -6, 0.5);
    EXPECT_NEAR(decibel(tone_at(with, 1, 1.2) / tone_at(without, 1, 1.2)), 0, 0.1);
}

TEST(EarconSound, what_was_said_before_leaving_is_not_heard_after_it) {
    Listening listening(kLoud);
    listening.listen_until(0.5);
    listening.say(std::nullopt, {SenseEvent::LimitUp});
    listening.engine().stop();
    listening.listen_until(1);
    EXPECT_EQ(peak(listening.heard().left), 0);
}

}  // namespace
}  // namespace feelem::test
