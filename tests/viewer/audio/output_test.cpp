// SPDX-License-Identifier: Apache-2.0
// Sound devices that come and go: SDL's dummy and disk drivers stand for them.
#include "support/paths.hpp"
#include "viewer/audio/audio_output.hpp"
#include "viewer/audio/sound_measures.hpp"

#include <SDL.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <thread>

namespace feelem::test {
namespace {

using viewer::AudioOutput;
using viewer::SoundDevice;

/// A variable of the environment for the length of a test.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
    ~Variable() { unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
};

/// A viewer's loop: frames at 72 a second, of which those with a device take real time.
struct Loop {
    explicit Loop(viewer::SoundOutputOptions options)
        : engine({.master = 1, .mono = true}), output(engine, options) {}

    void frames(int count, bool waits) {
        for (int i = 0; i < count; ++i, ++frame) {
            viewer::Snapshot snapshot;
            snapshot.sound = tone_frame(0.5);
            engine.update(snapshot, true);
            output.update(frame / 72.0);
            if (waits) wait();
            const std::vector<float> taken = output.take();
            EXPECT_EQ(taken.size() % 2, 0U) << "one ear without the other";
            for (std::size_t k = 0; k < taken.size(); k += 2) left.push_back(taken[k]);
        }
    }

    /// From the end of a frame to that of the next, as long as the device takes real time.
    void wait() {
        std::this_thread::sleep_for(std::chrono::milliseconds(14));
        const auto ended = std::chrono::steady_clock::now();
        if (last_ended)
            longest_frame =
                std::max(longest_frame, std::chrono::duration<double>(ended - *last_ended).count());
        last_ended = ended;
    }

    viewer::AudioEngine engine;
    AudioOutput output;
    int frame = 0;
    std::optional<std::chrono::steady_clock::time_point> last_ended;
    double longest_frame = 0;  ///< Seconds; it ought to take 0.014.
    Samples left;
};

/// SDL does not say what an opened device is called: it is the one that plays.
SDL_AudioDeviceID playing_device() {
    for (SDL_AudioDeviceID id = 1; id < 32; ++id) {
        if (SDL_GetAudioDeviceStatus(id) == SDL_AUDIO_PLAYING) return id;
    }
    return 0;
}

TEST(AudioOutput, a_device_plays_the_engine) {
    const Variable driver("SDL_AUDIODRIVER", "dummy");
    Loop loop({.keep = true});
    for (int i = 0; i < 20 && loop.left.size() < 24000; ++i) loop.frames(36, true);
    EXPECT_TRUE(loop.output.is_heard());
    EXPECT_EQ(loop.output.trouble(), "");
    ASSERT_GE(loop.left.size(), 24000U);
    EXPECT_GT(rms(part(loop.left, 0.2, 0.5)), 0.01);
}

TEST(AudioOutput, a_device_that_goes_is_looked_for_every_two_seconds_and_the_sound_goes_on_where_it_is) {
    const Variable driver("SDL_AUDIODRIVER", "dummy");
    Loop loop({.keep = true});
    for (int i = 0; i < 20 && loop.left.size() < 24000; ++i) loop.frames(36, true);
    ASSERT_TRUE(loop.output.is_heard());
    const SDL_AudioDeviceID device = playing_device();
    ASSERT_NE(device, 0U);

    SDL_Event event{};
    event.type = SDL_AUDIODEVICEREMOVED;
    event.adevice.which = device;
    SDL_PushEvent(&event);
    SDL_FlushEvents(
        SDL_FIRSTEVENT, SDL_LASTEVENT
    );  // The window takes its events; ours is seen nevertheless.
    loop.frames(1, false);

    EXPECT_FALSE(loop.output.is_heard());
    EXPECT_NE(loop.output.trouble(), "");
    const std::size_t before = loop.left.size();
    loop.frames(142, false);
    EXPECT_FALSE(loop.output.is_heard()) << "not before two seconds";
    EXPECT_NEAR(static_cast<double>(loop.left.size() - before), 142 / 72.0 * 48000, 48000 / 36.0);
    loop.frames(4, false);
    EXPECT_TRUE(loop.output.is_heard());
    EXPECT_EQ(loop.output.trouble(), "");
    loop.frames(36, true);
    if (loop.longest_frame > 0.3)
        GTEST_SKIP() << "the machine took " << loop.longest_frame << " s for a frame";
    // Not one gap and not one click from the first tone to the end.
    EXPECT_LE(click_level(loop.left), -80);
    for (std::size_t at = 9600; at + 480 < loop.left.size(); at += 480) {
        ASSERT_GT(peak(std::span(loop.left).subspan(at, 480)), 0.01) << at;
    }
}

TEST(AudioOutput, a_machine_without_a_device_goes_on_unheard_until_there_is_one) {
    Loop loop({.keep = true});
    {
        const Variable driver("SDL_AUDIODRIVER", "there-is-no-such-driver");
        loop.frames(72, false);
        EXPECT_FALSE(loop.output.is_heard());
        EXPECT_NE(loop.output.trouble(), "");
        EXPECT_NEAR(static_cast<double>(loop.left.size()), 48000, 48000 / 36.0);
    }
    const Variable driver("SDL_AUDIODRIVER", "dummy");
    loop.frames(71, false);
    EXPECT_FALSE(loop.output.is_heard());
    loop.frames(3, false);
    EXPECT_TRUE(loop.output.is_heard());
}

TEST(AudioOutput, what_reaches_the_device_is_what_was_made) {
    const std::string file = scratch_folder("audio_disk") + "/sound.raw";
    const Variable driver("SDL_AUDIODRIVER", "disk"), name("SDL_DISKAUDIOFILE", file.c_str()),
        delay("SDL_DISKAUDIODELAY", "2");
    Samples made;
    {
        Loop loop({.keep = true});
        for (int i = 0; i < 20 && loop.left.size() < 24000; ++i) loop.frames(36, true);
        made = loop.left;
    }
    const std::string bytes = read_file(file);
    Samples played(bytes.size() / sizeof(float));
    std::memcpy(played.data(), bytes.data(), played.size() * sizeof(float));
    // SDL may play a little silence before it asks for the first time.
    const auto first_sound = [](const Samples& samples) {
        return static_cast<std::size_t>(
            std::find_if(samples.begin(), samples.end(), [](float x) { return x != 0; }) - samples.begin()
        );
    };
    const std::size_t from = first_sound(made), played_from = first_sound(played);
    ASSERT_EQ(played_from % 2, 0U);
    ASSERT_GE(made.size(), 24000U);
    ASSERT_GE(played.size() - played_from, 2 * (made.size() - from));
    for (std::size_t i = from; i < made.size(); ++i)
        ASSERT_EQ(played[played_from + 2 * (i - from)], made[i]) << i;
}

TEST(AudioOutput, without_a_device_the_clock_alone_decides_what_is_made) {
    const auto run = [] {
        Loop loop({.device = SoundDevice::None, .keep = true});
        loop.frames(145, false);
        EXPECT_FALSE(loop.output.is_heard());
        EXPECT_EQ(loop.output.trouble(), "");
        return loop.left;
    };
    const Samples first = run();
    EXPECT_EQ(first, run());
    EXPECT_EQ(first.size(), 96000U);
    // A clock that stands still or leaps makes no sound of its own.
    viewer::AudioEngine engine;
    AudioOutput output(engine, {.device = SoundDevice::None, .keep = true});
    for (const double time : {5.0, 5.0, 1e9, 1e9}) output.update(time);
    EXPECT_EQ(output.take().size(), 48000U) << "half a second at most";
}

}  // namespace
}  // namespace feelem::test
