// SPDX-License-Identifier: Apache-2.0
// Where it comes from: told by both ears, and by nothing else.
#include "viewer/audio/sound_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace feelem::test {
namespace {

using viewer::SoundFrame;

/// Half a second of a tone at `u` from a direction.
Stereo from_direction(double u, const glm::vec3& direction) {
    Listening listening;
    SoundFrame frame = tone_frame(u);
    frame.source = direction;
    listening.hold_until(0.8, frame);
    const auto steady = [](const Samples& ear) {
        const auto kept = part(ear, 0.3, 0.8);
        return Samples(kept.begin(), kept.end());
    };
    return {steady(listening.heard().left), steady(listening.heard().right)};
}

double ear_difference(const Stereo& heard) {
    return decibel(rms(heard.left) / rms(heard.right));
}

double largest_difference(const Samples& a, const Samples& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(static_cast<double>(a[i] - b[i])));
    return most;
}

bool has_directions() {
    return viewer::AudioEngine().directions().starts_with("HRTF");
}

TEST(PlaceSound, the_shipped_ears_are_found) {
    EXPECT_TRUE(has_directions()) << "libopenal-data brings them; directions are "
                                  << viewer::AudioEngine().directions();
}

TEST(PlaceSound, the_nearer_ear_hears_it_louder_and_sooner_and_both_sides_mirror_each_other) {
    if (!has_directions()) GTEST_SKIP() << "no HRTF set is installed";
    const Stereo left = from_direction(0.5, {-1, 0, 0}), right = from_direction(0.5, {1, 0, 0});
    EXPECT_GT(ear_difference(left), 2);
    EXPECT_LT(ear_difference(right), -2);
    EXPECT_GT(lag_of(left.left, left.right), 15);
    EXPECT_LT(lag_of(right.left, right.right), -15);
    EXPECT_LT(largest_difference(left.left, right.right), 1e-5) << "mirrored sample by sample";
    EXPECT_LT(largest_difference(left.right, right.left), 1e-5);
    printf(
        "measured sides: left %+.1f dB, right ear %.0f us later\n",
        ear_difference(left),
        1e6 * lag_of(left.left, left.right) / viewer::kSoundRate
    );
}

TEST(PlaceSound, ahead_behind_and_above_are_the_same_in_both_ears) {
    for (const glm::vec3& direction : {glm::vec3(0, 0, -1), glm::vec3(0, 0, 1), glm::vec3(0, 1, 0)}) {
        const Stereo heard = from_direction(0.5, direction);
        EXPECT_NEAR(ear_difference(heard), 0, 0.01);
        EXPECT_NEAR(lag_of(heard.left, heard.right), 0, 0.01);
    }
}

TEST(PlaceSound, the_way_to_the_far_ear_grows_with_the_angle_and_is_the_same_ahead_and_behind) {
    if (!has_directions()) GTEST_SKIP() << "no HRTF set is installed";
    const auto lag_at = [](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const auto right = static_cast<float>(std::sin(angle)), back = static_cast<float>(-std::cos(angle));
        const Stereo heard = from_direction(0.5, {right, 0, back});
        return lag_of(heard.right, heard.left);
    };
    EXPECT_GT(lag_at(30), 5);
    EXPECT_GT(lag_at(60), lag_at(30) + 5);
    EXPECT_NEAR(lag_at(45), lag_at(135), 2);
}

TEST(PlaceSound, a_place_that_jumps_is_turned_to_within_80_ms_but_not_at_once) {
    if (!has_directions()) GTEST_SKIP() << "no HRTF set is installed";
    Listening listening;
    SoundFrame frame = tone_frame(1);
    frame.source = {-1, 0, 0};
    listening.hold_until(0.5, frame);
    frame.source = {1, 0, 0};
    listening.hold_until(1, frame);
    const auto difference = [&](double from, double to) {
        const Stereo& heard = listening.heard();
        return decibel(rms(part(heard.left, from, to)) / rms(part(heard.right, from, to)));
    };
    EXPECT_GT(difference(0.4, 0.5), 2);
    EXPECT_GT(difference(0.506, 0.51), 0.5) << "still on its way";
    EXPECT_NEAR(difference(0.58, 0.63), difference(0.8, 1), 0.3);
}

TEST(PlaceSound, distance_carries_nothing) {
    const Stereo near = from_direction(0.5, {0.1F, 0, -0.1F}), far = from_direction(0.5, {10, 0, -10});
    EXPECT_NEAR(decibel(rms(near.left) / rms(far.left)), 0, 0.01);
    EXPECT_NEAR(decibel(rms(near.right) / rms(far.right)), 0, 0.01);
}

TEST(PlaceSound, place_does_not_change_how_much_is_heard) {
    double least = 1e9, most = -1e9;
    for (const double u : {0.0, 0.5, 1.0}) {
        Listening listening;
        SoundFrame frame = tone_frame(u);
        const auto energy_from = [&](const glm::vec3& direction) {
            frame.source = direction;
            const double end = listening.time() + 0.4;
            listening.hold_until(end, frame);
            const double left = rms(part(listening.heard().left, end - 0.2, end));
            const double right = rms(part(listening.heard().right, end - 0.2, end));
            return 10 * std::log10(left * left + right * right);
        };
        const double ahead = energy_from({0, 0, -1});
        for (const float height : {-0.6F, 0.0F, 0.7F}) {
            for (int degrees = 0; degrees < 360; degrees += 25) {
                const double angle = degrees * std::numbers::pi / 180;
                const auto right = static_cast<float>(std::sin(angle)),
                           back = static_cast<float>(-std::cos(angle));
                const double change = energy_from({right, height, back}) - ahead;
                EXPECT_NEAR(change, 0, 1.5) << u << " " << degrees << " " << height;
                least = std::min(least, change);
                most = std::max(most, change);
            }
        }
    }
    printf("measured place: energy within %.2f to %.2f dB of ahead over 45 directions\n", least, most);
}

TEST(PlaceSound, mono_is_bit_equal_in_both_ears) {
    Listening listening({.master = 1, .mono = true});
    SoundFrame frame = tone_frame(0.5);
    frame.tick_rate = 8;
    frame.source = {1, 0, 0};
    listening.hold_until(0.7, frame);
    EXPECT_EQ(listening.heard().left, listening.heard().right);
    EXPECT_GT(rms(listening.heard().left), 0.01);
}

TEST(PlaceSound, changing_to_mono_and_back_does_not_click) {
    Listening listening;
    SoundFrame frame = tone_frame(0.5);
    frame.source = {1, 0, 0};
    listening.hold_until(0.5, frame);
    listening.engine().set_mono(true);
    listening.hold_until(1, frame);
    listening.engine().set_mono(false);
    listening.hold_until(1.5, frame);
    const Stereo& heard = listening.heard();
    EXPECT_EQ(
        Samples(part(heard.left, 0.7, 1).begin(), part(heard.left, 0.7, 1).end()),
        Samples(part(heard.right, 0.7, 1).begin(), part(heard.right, 0.7, 1).end())
    );
    EXPECT_LE(std::max(click_level(heard.left), click_level(heard.right)), -80);
}

}  // namespace
}  // namespace feelem::test
