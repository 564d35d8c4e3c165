// SPDX-License-Identifier: Apache-2.0
// The vibration engine against a hand that writes down what it feels, and a clock of our own.
#include "viewer/haptics/haptics.hpp"
#include "viewer/haptics/recording_sink.hpp"

#include "feelem/present.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace feelem::test {
namespace {

using viewer::HapticFrame;
using viewer::Pulser;
using viewer::SenseEvent;
using viewer::SentPulse;

HapticFrame frame_at(double u) {
    const Pulse pulse = pulse_of(u, {0, 1, Scale::Linear}, {});
    HapticFrame frame;
    frame.rate = pulse.rate;
    frame.amplitude = pulse.amplitude;
    return frame;
}

struct Rig {
    Pulser pulser;
    RecordingSink sink;
    double hz = 72;
    long frame = 0;
    std::vector<SentPulse> sent;

    Rig() { pulser.set_sink(&sink); }
    double time() const { return static_cast<double>(frame) / hz; }
    std::size_t run(double seconds, const std::optional<HapticFrame>& touch) {
        const std::size_t before = sent.size();
        for (const double end = time() + seconds; time() < end - 1e-9; ++frame) {
            pulser.update(touch);
            if (const auto pulse = pulser.tick(time())) sent.push_back(*pulse);
        }
        return sent.size() - before;
    }
};

TEST(Pulser, steady_values_keep_their_rate_within_two_thousandths_whatever_the_frames) {
    double worst = 0;
    for (const double hz : {72.0, 90.0, 120.0, 60.0}) {
        for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            Rig rig;
            rig.hz = hz;
            rig.run(60, frame_at(u));
            ASSERT_GT(rig.sent.size(), 100U);
            const double rate =
                static_cast<double>(rig.sent.size() - 1) / (rig.sent.back().time - rig.sent[0].time);
            const double error = std::abs(rate / frame_at(u).rate - 1);
            EXPECT_LE(error, 0.002) << hz << " frames a second, u " << u;
            worst = std::max(worst, error);
            for (std::size_t i = 0; i < rig.sent.size(); ++i) {
                const double due = rig.sent[0].time + static_cast<double>(i) / frame_at(u).rate;
                ASSERT_LE(std::abs(rig.sent[i].time - due), 1 / hz + 1e-9);
                ASSERT_EQ(rig.sent[i].strength, frame_at(u).amplitude);
                ASSERT_EQ(rig.sent[i].milliseconds, 35);
            }
        }
    }
    printf("measured pulses: average rate within %.3f %%\n", 100 * worst);
}

TEST(Pulser, stops_within_a_frame_and_begins_again_at_once) {
    Rig rig;
    rig.run(1, frame_at(1));
    EXPECT_EQ(rig.run(1, std::nullopt), 0U);
    const double start = rig.time();
    rig.run(0.1, frame_at(0));
    EXPECT_EQ(rig.sent.back().time, start);

    rig.pulser.event(SenseEvent::LimitUp);
    rig.pulser.stop();
    EXPECT_EQ(rig.sink.stops, 1) << "also what still shakes";
    rig.pulser.stop();
    EXPECT_EQ(rig.sink.stops, 1) << "once is enough";
    EXPECT_EQ(rig.run(1, std::nullopt), 0U);
}

TEST(Pulser, the_limit_is_a_double_pulse_that_nothing_pushes_aside_for_a_quarter_of_a_second) {
    for (int offset = 0; offset < 30; ++offset) {
        Rig rig;
        rig.run(0.5 + offset / 72.0, frame_at(1));
        const std::size_t before = rig.sent.size();
        const double start = rig.time();
        rig.pulser.event(SenseEvent::LimitUp);
        for (int i = 0; i < 18; ++i) {
            rig.pulser.event(SenseEvent::Maximum);
            rig.run(1 / 72.0, frame_at(1));
        }
        ASSERT_EQ(rig.sent.size() - before, 2U);
        EXPECT_EQ(rig.sent[before].time, start) << "without waiting for a rest";
        EXPECT_GE(rig.sent[before + 1].time - start, 0.12);
        EXPECT_LE(rig.sent[before + 1].time - start, 0.12 + 1.0 / 72);
        for (std::size_t i = before; i < rig.sent.size(); ++i) {
            EXPECT_EQ(rig.sent[i].event, SenseEvent::LimitUp);
            EXPECT_EQ(rig.sent[i].strength, 1);
            EXPECT_EQ(rig.sent[i].milliseconds, 60);
        }
        EXPECT_GT(rig.run(0.5, frame_at(1)), 2U);
    }
}

TEST(Pulser, a_hundred_thousand_random_frames_leave_the_hand_its_rest) {
    std::minstd_rand random(5);
    const auto share = [&] { return static_cast<double>(random() % 10000) / 10000; };
    Pulser pulser;
    RecordingSink sink;
    pulser.set_sink(&sink);
    double time = 0, on = 0, last = -1, u = 0.5;
    std::size_t limits = 0;
    for (int i = 0; i < 100000; ++i) {
        u = std::clamp(u + 0.4 * (share() - 0.5), 0.0, 1.0);
        if (share() < 0.01) pulser.event(static_cast<SenseEvent>(random() % 8));
        std::optional<HapticFrame> frame = frame_at(u);
        frame->milliseconds = 10 + 300 * share();
        frame->alarm = share() < 0.2;
        frame->still = share() < 0.1;
        if (share() < 0.02) frame.reset();
        pulser.update(frame);
        if (const auto sent = pulser.tick(time)) {
            const bool of_limit = sent->event == SenseEvent::LimitUp || sent->event == SenseEvent::LimitDown;
            limits += of_limit ? 1 : 0;
            if (!of_limit) {
                ASSERT_GE(time - last, 0.08 - 1e-9);
            }
            ASSERT_LE(sent->milliseconds, 200);
            ASSERT_LE(sent->strength, 1);
            on += sent->milliseconds / 1000;
            last = time;
        }
        time += (0.5 + share()) / 72;
    }
    EXPECT_GT(limits, 50U);
    EXPECT_LE(on / time, 0.45);
}

TEST(Pulser, a_sink_that_refuses_is_told_and_asked_again_at_the_next_beat) {
    Rig rig;
    rig.sink.refuses = true;
    EXPECT_EQ(rig.run(1, frame_at(1)), 0U) << "what was not felt was not sent";
    EXPECT_TRUE(rig.pulser.was_refused());
    rig.sink.refuses = false;
    EXPECT_GT(rig.run(1, frame_at(1)), 5U);
    EXPECT_FALSE(rig.pulser.was_refused());
}

TEST(Pulser, without_a_sink_nothing_is_sent_and_a_new_one_goes_on) {
    Rig rig;
    rig.run(1, frame_at(1));
    rig.pulser.set_sink(nullptr);
    EXPECT_FALSE(rig.pulser.has_sink());
    EXPECT_EQ(rig.sink.stops, 1) << "the old one is left still";
    EXPECT_EQ(rig.run(1, frame_at(1)), 0U);
    rig.pulser.set_sink(&rig.sink);
    EXPECT_GT(rig.run(1, frame_at(1)), 5U);
}

TEST(Haptics, each_hand_feels_its_own_frame_and_the_pointing_hand_the_events) {
    viewer::Haptics haptics;
    RecordingSink left, right;
    haptics.set_sink(viewer::Side::Left, &left);
    haptics.set_sink(viewer::Side::Right, &right);
    viewer::Snapshot snapshot;
    snapshot.pointer = viewer::Pointer::Left;
    snapshot.touch = {frame_at(0), frame_at(1)};
    snapshot.events = {SenseEvent::LimitUp};

    const auto sent = haptics.update(snapshot);

    ASSERT_EQ(sent.size(), 2U);
    EXPECT_EQ(sent[0].side, viewer::Side::Left);
    EXPECT_EQ(sent[0].event, SenseEvent::LimitUp);
    EXPECT_EQ(sent[1].side, viewer::Side::Right);
    EXPECT_EQ(sent[1].event, std::nullopt);
    EXPECT_EQ(right.calls.at(0).amplitude, 1);
}

TEST(Haptics, a_hand_without_touch_is_left_in_peace_and_a_frame_without_rate_lets_events_through) {
    viewer::Haptics haptics;
    RecordingSink left, right;
    haptics.set_sink(viewer::Side::Left, &left);
    haptics.set_sink(viewer::Side::Right, &right);
    viewer::Snapshot snapshot;
    snapshot.pointer = viewer::Pointer::Mouse;
    snapshot.events = {SenseEvent::LimitUp};
    EXPECT_TRUE(haptics.update(snapshot).empty());

    snapshot.time = 1;
    snapshot.touch[1] = HapticFrame{};
    ASSERT_EQ(haptics.update(snapshot).size(), 1U);
    EXPECT_EQ(right.calls.size(), 1U);
    EXPECT_TRUE(left.calls.empty());

    haptics.stop();
    EXPECT_EQ(right.stops, 1);
    EXPECT_EQ(left.stops, 0) << "there was nothing to stop";
}

}  // namespace
}  // namespace feelem::test
