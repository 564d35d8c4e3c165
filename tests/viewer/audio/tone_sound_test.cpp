// SPDX-License-Identifier: Apache-2.0
// The tone as it comes out of the mixer into directions, without a sound card: pitch, loudness, clicks,
// silence.
#include "support/paths.hpp"
#include "viewer/audio/sound_measures.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <set>

namespace feelem::test {
namespace {

using viewer::AudioOptions;
using viewer::SoundFrame;

/// What the ear hears of a sine against 1 kHz at 60 phon, dB (docs/effects.md).
double ear_loss(double hz) {
    constexpr std::array<std::array<double, 2>, 17> kTable{
        {{100, 18.6},
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
         {4000, -2.4}}};
    if (hz <= kTable.front()[0]) return kTable.front()[1];
    for (std::size_t i = 1; i < kTable.size(); ++i) {
        if (hz > kTable[i][0]) continue;
        const double share = std::log(hz / kTable[i - 1][0]) / std::log(kTable[i][0] / kTable[i - 1][0]);
        return kTable[i - 1][1] + share * (kTable[i][1] - kTable[i - 1][1]);
    }
    return kTable.back()[1];
}

/// Loudness of a tone in dB: power of its partials in both ears as the ear weighs them.
double loudness_of(const Stereo& heard, double hz, double from, double to) {
    double power = 0;
    for (int k = 1; k <= 4; ++k) {
        for (const Samples* ear : {&heard.left, &heard.right}) {
            const double amplitude = amplitude_at(part(*ear, from, to), k * hz);
            power += amplitude * amplitude * std::pow(10.0, -ear_loss(k * hz) / 10);
        }
    }
    return 10 * std::log10(power);
}

TEST(ToneSound, pitch_of_each_tone_of_the_contract_is_right_within_two_cents) {
    const auto contract = nlohmann::json::parse(read_file(project_file("tests/contract/senses.json")));
    std::set<double> pitches;
    for (const auto& tone : contract.at("tone")) {
        if (tone.at("gain").get<double>() > 0) pitches.insert(tone.at("hz").get<double>());
    }
    ASSERT_GT(pitches.size(), 50U);
    Listening listening;
    double worst = 0, lowest = 1e9, highest = 0;
    for (const double hz : pitches) {
        SoundFrame frame = tone_frame(0.5);
        frame.hz = hz;
        const double start = listening.time();
        listening.hold_until(start + 0.45, frame);
        const double found = fundamental(part(listening.heard().left, start + 0.25, start + 0.45));
        const double cents = std::abs(1200 * std::log2(found / hz));
        EXPECT_LE(cents, 2) << hz << " Hz sounds as " << found;
        worst = std::max(worst, cents);
        lowest = std::min(lowest, hz);
        highest = std::max(highest, hz);
        listening.say(std::nullopt);
        listening.listen_until(listening.time() + 0.15);
    }
    printf(
        "measured pitch: worst of %zu tones from %.1f to %.1f Hz %.3f cents\n",
        pitches.size(),
        lowest,
        highest,
        worst
    );
}

TEST(ToneSound, all_pitches_from_ahead_are_equally_loud_within_half_a_decibel) {
    double least = 1e9, most = -1e9, least_power = 1e9, most_power = 0;
    for (int i = 0; i <= 36; ++i) {
        const double u = i / 36.0;
        Listening listening;
        listening.hold_until(0.7, tone_frame(u));
        const double loudness = loudness_of(listening.heard(), tone_frame(u).hz, 0.3, 0.7);
        least = std::min(least, loudness);
        most = std::max(most, loudness);
        // The same tone at the same level without equal loudness, for what directions do to the level.
        const double power = rms(part(listening.heard().left, 0.3, 0.7)) / tone_frame(u).gain;
        least_power = std::min(least_power, power);
        most_power = std::max(most_power, power);
    }
    EXPECT_LE(most - least, 0.5);
    EXPECT_LE(decibel(most_power / least_power), 0.5);
    printf(
        "measured loudness: 37 tones from ahead within %.2f dB, RMS within %.2f dB\n",
        most - least,
        decibel(most_power / least_power)
    );
}

TEST(ToneSound, a_tone_from_ahead_is_as_loud_as_the_same_in_both_ears) {
    Listening ahead, mono({.master = 1, .mono = true});
    ahead.hold_until(0.7, tone_frame(0.6));
    mono.hold_until(0.7, tone_frame(0.6));
    const double hz = tone_frame(0.6).hz;
    EXPECT_NEAR(loudness_of(ahead.heard(), hz, 0.3, 0.7), loudness_of(mono.heard(), hz, 0.3, 0.7), 0.3);
    // The page's level: 0.1 of the gain, 0.7071 in each ear.
    const double expected = 0.1 * tone_frame(0.6).gain / std::sqrt(2.0);
    EXPECT_NEAR(decibel(amplitude_at(part(mono.heard().left, 0.3, 0.7), hz) / expected), 0, 0.01);
}

TEST(ToneSound, jumps_of_value_and_of_the_gate_do_not_click) {
    for (const bool mono : {false, true}) {
        std::minstd_rand random(3);
        std::vector<double> us;
        std::vector<bool> open;
        for (int i = 0; i < 101; ++i) {
            us.push_back(static_cast<double>(random() % 1000) / 999);
            open.push_back(random() % 10 < 7);
        }
        Listening listening({.master = 1, .mono = mono});
        listening.frames_until(10, [&](double time) -> std::optional<SoundFrame> {
            const auto i = static_cast<std::size_t>(time * 10);
            if (!open[i]) return std::nullopt;
            return tone_frame(us[i]);
        });
        EXPECT_GT(rms(listening.heard().left), 0.01);
        const double clicks =
            std::max(click_level(listening.heard().left), click_level(listening.heard().right));
        EXPECT_LE(clicks, -80);
        printf("measured clicks: %.1f dBFS, %s\n", clicks, mono ? "mono" : "from ahead");
    }
}

TEST(ToneSound, jumps_of_place_do_not_click) {
    Listening listening;
    std::minstd_rand random(8);
    SoundFrame frame = tone_frame(0.4);
    int told = 0;
    listening.frames_until(6, [&](double) {
        if (told++ % 7 == 0) {
            const auto axis = [&] { return static_cast<float>(random() % 2001) / 1000 - 1; };
            frame.source = {axis(), axis(), axis()};
        }
        return frame;
    });
    EXPECT_GT(rms(listening.heard().left), 0.01);
    const double clicks = std::max(click_level(listening.heard().left), click_level(listening.heard().right));
    EXPECT_LE(clicks, -80);
    printf("measured clicks: %.1f dBFS when the place jumps ten times a second\n", clicks);
}

TEST(ToneSound, release_and_no_value_end_in_exact_silence_within_120_ms) {
    for (const auto& [released, ticks] : {std::pair{true, true}, {false, true}, {true, false}}) {
        Listening listening;
        SoundFrame frame = tone_frame(0.3);
        frame.tick_rate = ticks ? 12 : 0;
        listening.hold_until(0.6, frame);
        EXPECT_GT(peak(part(listening.heard().left, 0.5, 0.6)), 0.01);
        if (released) {
            listening.say(std::nullopt);
        } else {
            listening.say(SoundFrame{});
        }
        listening.listen_until(1.2);
        for (const Samples* ear : {&listening.heard().left, &listening.heard().right}) {
            EXPECT_EQ(peak(part(*ear, 0.6 + 0.12, 1.2)), 0) << released;
            if (!ticks) {
                EXPECT_LE(click_level(*ear), -80);
            }
        }
    }
}

TEST(ToneSound, leaving_ends_in_exact_silence_within_50_ms_and_without_a_click) {
    // One sample after a step began, everything waits longest.
    for (const double late : {0.0, 1.0 / viewer::kSoundRate}) {
        Listening listening;
        SoundFrame frame = tone_frame(0.3);
        frame.source = {1, 0, -1};
        listening.hold_until(0.6, frame);
        const double leaves = 0.6 + late;
        listening.listen_until(leaves);
        listening.engine().update({}, false);
        listening.listen_until(0.8);
        // Without focus nothing is heard, whatever is said.
        viewer::Snapshot snapshot;
        snapshot.sound = frame;
        snapshot.events = {viewer::SenseEvent::LimitUp};
        listening.engine().update(snapshot, false);
        listening.listen_until(1.2);
        // And back.
        listening.hold_until(1.6, frame);
        for (const Samples* ear : {&listening.heard().left, &listening.heard().right}) {
            EXPECT_GT(peak(part(*ear, 0.5, 0.6)), 0.01);
            EXPECT_EQ(peak(part(*ear, leaves + 0.05, 1.2)), 0) << late;
            EXPECT_GT(peak(part(*ear, 1.4, 1.6)), 0.01);
            EXPECT_LE(click_level(*ear), -80);
        }
    }
}

TEST(ToneSound, leaving_silences_ticks_and_earcons_too) {
    Listening listening;
    SoundFrame frame = tone_frame(0.3);
    frame.tick_rate = 12;
    listening.hold_until(0.6, frame);
    listening.say(frame, {viewer::SenseEvent::Maximum});
    listening.listen_until(0.63);
    listening.engine().stop();
    listening.listen_until(1.2);
    EXPECT_GT(peak(part(listening.heard().left, 0.61, 0.63)), 0.05);
    EXPECT_EQ(peak(part(listening.heard().left, 0.63 + 0.05, 1.2)), 0);
}

TEST(ToneSound, coming_back_at_once_does_not_click) {
    for (const double after : {0.003, 0.02, 0.05, 0.07}) {
        Listening listening;
        listening.hold_until(0.6, tone_frame(0.3));
        listening.engine().update({}, false);
        listening.listen_until(0.6 + after);
        listening.hold_until(1, tone_frame(0.3));
        EXPECT_LE(click_level(listening.heard().left), -80) << after;
        EXPECT_GT(peak(part(listening.heard().left, 0.8, 1)), 0.01);
    }
}

TEST(ToneSound, mute_fades_to_exact_silence_within_120_ms_and_back) {
    Listening listening;
    const SoundFrame frame = tone_frame(0.5);
    listening.hold_until(0.5, frame);
    listening.engine().set_muted(true);
    listening.hold_until(1, frame);
    listening.engine().set_muted(false);
    listening.hold_until(1.5, frame);
    const Samples& left = listening.heard().left;
    EXPECT_GT(peak(part(left, 0.4, 0.5)), 0.02);
    EXPECT_EQ(peak(part(left, 0.62, 1)), 0);
    EXPECT_GT(peak(part(left, 1.3, 1.5)), 0.02);
    EXPECT_LE(click_level(left), -80);
}

TEST(ToneSound, a_caller_that_stops_calling_is_silent_after_a_second) {
    for (const double rate : {0, 12}) {
        Listening listening;
        SoundFrame frame = tone_frame(0.3);
        frame.tick_rate = rate;
        listening.hold_until(0.5, frame);
        listening.listen_until(2);
        EXPECT_GT(peak(part(listening.heard().left, 0.6, 0.9)), 0.01);
        EXPECT_EQ(peak(part(listening.heard().left, 1.25, 2)), 0);
        if (rate == 0) {
            EXPECT_LE(click_level(listening.heard().left), -80);
        }
    }
}

TEST(ToneSound, a_tone_that_rests_steps_back_by_18_decibels_and_returns_at_once) {
    Listening listening;
    listening.frames_until(6, [](double time) {
        SoundFrame frame = tone_frame(0.4);
        frame.still = time > 0.5 && time < 5;
        return frame;
    });
    const auto level = [&](double from, double to) {
        return decibel(rms(part(listening.heard().left, from, to)));
    };
    EXPECT_NEAR(level(4.5, 5) - level(1, 2), -18, 0.5);
    EXPECT_NEAR(level(5.1, 5.5) - level(1, 2), 0, 0.5);
    EXPECT_NEAR(level(2.2, 2.4) - level(1, 2), 0, 0.1) << "not before two seconds";
}

TEST(ToneSound, beyond_the_limit_the_tone_flutters_eight_times_a_second) {
    Listening listening;
    SoundFrame frame = tone_frame(0.5);
    frame.tremolo = true;
    listening.hold_until(3, frame);
    Samples levels;
    for (int i = 0; i < 500; ++i) {
        levels.push_back(
            static_cast<float>(rms(part(listening.heard().left, 0.5 + i / 250.0, 0.51 + i / 250.0)))
        );
    }
    // Strongest rate of the level between 2 and 20 Hz, at 250 levels a second.
    double best = 0, most = 0;
    for (double rate = 2; rate < 20; rate += 0.1) {
        const double at = amplitude_at(levels, rate * viewer::kSoundRate / 250);
        if (at > most) {
            most = at;
            best = rate;
        }
    }
    EXPECT_NEAR(best, 8, 0.15);
    const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
    EXPECT_NEAR(*low / *high, 0.5, 0.06);
}

TEST(ToneSound, below_the_range_the_tone_is_dull) {
    Listening listening;
    SoundFrame frame = tone_frame(0.6);
    listening.hold_until(0.6, frame);
    frame.dull = true;
    listening.hold_until(1.2, frame);
    const auto fourth = [&](double from) {
        return amplitude_at(part(listening.heard().left, from, from + 0.3), 4 * frame.hz);
    };
    EXPECT_LT(decibel(fourth(0.8) / fourth(0.25)), -20);
}

TEST(ToneSound, a_negative_value_sounds_hollow) {
    Listening listening;
    SoundFrame frame = tone_frame(0.5);
    frame.negative = true;
    listening.hold_until(1, frame);
    const auto of = [&](double times) {
        return amplitude_at(part(listening.heard().left, 0.4, 1), times * frame.hz);
    };
    EXPECT_LT(decibel(of(2) / of(1)), -25);
    EXPECT_NEAR(of(3) / of(1), 0.45, 0.03);
    EXPECT_GT(of(2.5), 1e-6) << "a breath of noise";
}

TEST(ToneSound, a_jump_of_value_is_within_ten_cents_after_80_ms) {
    Listening listening;
    listening.frames_until(1, [](double time) { return tone_frame(time < 0.5 ? 0.5 : 0.6); });
    const double found = fundamental(part(listening.heard().left, 0.58, 0.64));
    EXPECT_LT(std::abs(1200 * std::log2(found / tone_frame(0.6).hz)), 10);
}

TEST(ToneSound, a_tone_that_starts_anew_starts_at_its_pitch_and_is_never_louder_than_it_will_be) {
    Listening listening;
    listening.hold_until(0.5, tone_frame(0));
    listening.say(std::nullopt);
    listening.listen_until(1);
    listening.hold_until(1.5, tone_frame(1));
    const Samples& left = listening.heard().left;
    EXPECT_EQ(peak(part(left, 0.7, 1)), 0);
    const double found = fundamental(part(left, 1.003, 1.03));
    EXPECT_LT(std::abs(1200 * std::log2(found / tone_frame(1).hz)), 10);
    EXPECT_LE(peak(part(left, 1, 1.2)), 1.02 * peak(part(left, 1.3, 1.5)));
}

TEST(ToneSound, a_new_value_is_heard_within_20_ms_of_its_frame) {
    Listening before, after;
    before.hold_until(0.5, tone_frame(0.5));
    after.frames_until(0.5, [](double time) { return tone_frame(time < 0.25 ? 0.5 : 0.52); });
    std::size_t first = 0;
    while (before.heard().left[first] == after.heard().left[first]) ++first;
    const double late = static_cast<double>(first) / viewer::kSoundRate - 0.25;
    EXPECT_GE(late, 0);
    // 5.3 ms more are the device's, at 256 samples a call.
    EXPECT_LE(late, 0.02 - 0.0053);
}

TEST(ToneSound, nothing_passes_minus_6_decibels_with_everything_at_once) {
    Listening listening;
    std::minstd_rand random(7);
    int told = 0;
    SoundFrame frame;
    for (int i = 0; i < 720; ++i) {
        frame = tone_frame(static_cast<double>(random() % 100) / 99);
        frame.tick_rate = 12;
        frame.tremolo = random() % 3 == 0;
        frame.source = {static_cast<float>(random() % 3) - 1, 0, -0.5F};
        listening.listen_until(i / 72.0);
        std::vector<viewer::SenseEvent> events;
        if (i % 9 == 0) events.push_back(static_cast<viewer::SenseEvent>(told++ % 8));
        listening.say(frame, events);
    }
    const double most = std::max(peak(listening.heard().left), peak(listening.heard().right));
    EXPECT_LE(decibel(most), -6);
    EXPECT_GT(most, 0.1);
    printf("measured peak: %.1f dBFS with every voice and event at full level\n", decibel(most));
}

TEST(ToneSound, the_standard_mix_is_no_louder_than_minus_20_decibels_on_average) {
    Listening listening{AudioOptions{}};
    SoundFrame frame = tone_frame(0);
    frame.tick_rate = 12;
    listening.hold_until(2, frame);
    EXPECT_LE(decibel(rms(part(listening.heard().left, 0.5, 2))), -20);
}

}  // namespace
}  // namespace feelem::test
