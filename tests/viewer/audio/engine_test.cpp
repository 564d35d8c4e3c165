// SPDX-License-Identifier: Apache-2.0
// The engine as a machine: same calls, same samples; long use; two threads.
#include "support/memory.hpp"
#include "viewer/audio/hand_over.hpp"
#include "viewer/audio/sound_measures.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

namespace feelem::test {
namespace {

using viewer::SenseEvent;
using viewer::SoundFrame;

SoundFrame busy_frame(double time) {
    SoundFrame frame = tone_frame(0.5 + 0.5 * std::sin(3 * time));
    frame.negative = std::fmod(time, 1) > 0.5;
    frame.tick_rate = 3 + std::fmod(time, 5);
    frame.source = {static_cast<float>(std::sin(time)), 0.2F, static_cast<float>(-std::cos(time))};
    frame.tremolo = std::fmod(time, 0.7) > 0.4;
    return frame;
}

Stereo busy_seconds(std::size_t block) {
    Listening listening({.master = 0.7}, block);
    for (int i = 0; i < 144; ++i) {
        listening.listen_until(i / 72.0);
        listening.say(
            busy_frame(i / 72.0), i % 40 == 0 ? std::vector{SenseEvent::Enter} : std::vector<SenseEvent>{}
        );
    }
    listening.listen_until(2);
    return listening.heard();
}

TEST(AudioEngine, the_same_calls_give_the_same_samples_whatever_the_block) {
    const Stereo first = busy_seconds(256);
    EXPECT_GT(rms(first.left), 0.005);
    for (const std::size_t block : {1U, 7U, 64U, 128U, 256U, 512U, 1000U, 4096U}) {
        const Stereo again = busy_seconds(block);
        EXPECT_EQ(first.left, again.left) << block;
        EXPECT_EQ(first.right, again.right) << block;
    }
}

TEST(AudioEngine, two_engines_do_not_hear_each_other) {
    Listening loud, silent;
    loud.hold_until(0.3, tone_frame(0.5));
    silent.listen_until(0.3);
    loud.hold_until(0.6, tone_frame(0.5));
    silent.listen_until(0.6);
    EXPECT_EQ(peak(silent.heard().left), 0);
    EXPECT_GT(peak(part(loud.heard().left, 0.4, 0.6)), 0.01);
}

TEST(AudioEngine, five_minutes_take_no_memory_and_sound_at_the_end_as_at_the_start) {
    viewer::AudioEngine engine({.master = 1});
    viewer::Snapshot snapshot;
    std::vector<float> out(2 * 667);
    const auto seconds = [&](int count, Samples* left) {
        for (int i = 0; i < 72 * count; ++i) {
            snapshot.sound = busy_frame(std::fmod(i / 72.0, 8));
            snapshot.events.clear();
            if (i % 100 == 0) snapshot.events = {static_cast<SenseEvent>(i / 100 % 8)};
            engine.update(snapshot, true);
            engine.render(out);
            if (!left) continue;
            for (std::size_t k = 0; k < out.size(); k += 2) left->push_back(out[k]);
        }
    };
    Samples early, late;
    seconds(8, nullptr);
    seconds(8, &early);
    reset_peak_memory();
    const std::uint64_t before = peak_memory();
    seconds(288, nullptr);
    const std::uint64_t after = peak_memory();
    seconds(8, &late);
    if (!kSanitized) {
        EXPECT_LT(after, before + (1U << 20U));
    }
    printf("measured growth: %lld bytes in 288 s of sound\n", static_cast<long long>(after - before));
    EXPECT_NEAR(decibel(rms(late) / rms(early)), 0, 0.05);
    for (const float sample : late) ASSERT_TRUE(std::isfinite(sample));
}

TEST(AudioEngine, one_thread_may_speak_while_another_renders) {
    viewer::AudioEngine engine;
    std::atomic<bool> done = false;
    Samples heard;
    std::thread device([&] {
        std::vector<float> out(512);
        while (!done) {
            engine.render(out);
            heard.insert(heard.end(), out.begin(), out.end());
        }
    });
    viewer::Snapshot snapshot;
    for (int i = 0; i < 3000; ++i) {
        snapshot.sound = busy_frame(i / 72.0);
        snapshot.events = {static_cast<SenseEvent>(i % 8)};
        engine.update(snapshot, i % 500 != 499);
        if (i % 100 == 0) engine.set_muted(i % 200 == 0);
        if (i % 130 == 0) engine.set_mono(i % 260 == 0);
        std::this_thread::yield();
    }
    done = true;
    device.join();
    for (const float sample : heard) ASSERT_LE(std::abs(sample), 0.5012);
}

TEST(AudioEngine, nonsense_is_silent_and_does_no_harm) {
    Listening listening;
    const double nan = std::nan(""), infinite = HUGE_VAL;
    for (const double hz : {nan, infinite, -5.0, 1e-300, 1e300}) {
        for (const double gain : {nan, infinite, 1.0, 1e300}) {
            SoundFrame frame;
            frame.hz = hz;
            frame.gain = gain;
            frame.tick_rate = hz;
            frame.source = {static_cast<float>(hz), static_cast<float>(gain), 0};
            listening.hold_until(listening.time() + 0.1, frame);
        }
    }
    listening.engine().set_master(nan);
    listening.engine().set_master(infinite);
    for (const float sample : listening.heard().left) ASSERT_LE(std::abs(sample), 0.5012);
    // And it goes on as if nothing had been.
    listening.say(std::nullopt);
    listening.listen_until(listening.time() + 1);
    const double start = listening.time();
    listening.hold_until(start + 0.5, tone_frame(0.5));
    const double found = fundamental(part(listening.heard().left, start + 0.3, start + 0.5));
    EXPECT_NEAR(1200 * std::log2(found / tone_frame(0.5).hz), 0, 2);
}

TEST(HandOver, the_newest_is_read_and_never_half_of_it) {
    struct Twice {
        std::uint64_t a = 0, b = 0;
    };
    viewer::Newest<Twice> newest;
    std::thread writer([&] {
        for (std::uint64_t i = 1; i <= 200000; ++i) newest.put({i, i});
    });
    std::uint64_t last = 0;
    while (last < 200000) {
        const Twice& read = newest.get();
        ASSERT_EQ(read.a, read.b);
        ASSERT_GE(read.a, last);
        last = read.a;
    }
    writer.join();
}

TEST(HandOver, a_queue_keeps_order_and_refuses_what_has_no_room) {
    viewer::Queue<int> queue(3);
    EXPECT_TRUE(queue.put(1) && queue.put(2) && queue.put(3));
    EXPECT_FALSE(queue.put(4));
    EXPECT_EQ(queue.take(), 1);
    EXPECT_TRUE(queue.put(5));
    EXPECT_EQ(queue.take(), 2);
    EXPECT_EQ(queue.take(), 3);
    EXPECT_EQ(queue.take(), 5);
    EXPECT_EQ(queue.take(), std::nullopt);
}

}  // namespace
}  // namespace feelem::test
