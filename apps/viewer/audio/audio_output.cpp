// SPDX-License-Identifier: Apache-2.0
// SDL asks for sound in a thread of its own; while it does not, the frame's thread asks in its place, so the
// engine's time never stands still and a device that comes back finds the sound where it ought to be.
#include "viewer/audio/audio_output.hpp"

#include "viewer/audio/hand_over.hpp"

#include <SDL.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace feelem::viewer {

namespace {

constexpr int kFramesACall = 256;              // 5.3 ms.
constexpr double kLookAgainAfter = 2;          // Seconds between two attempts to have a device.
constexpr double kLongestGap = 0.5;            // Of frames; sound of a longer one is left out.
constexpr std::size_t kKept = 4 * kSoundRate;  // Four seconds between two calls of `take`.

}  // namespace

struct AudioOutput::State {
    State(AudioEngine& of, const SoundOutputOptions& with)
        : engine(of), options(with), kept(with.keep ? kKept : 1) {}

    AudioEngine& engine;
    SoundOutputOptions options;
    Queue<std::array<float, 2>> kept;  ///< Left and right are put in and taken together.
    SDL_AudioDeviceID device = 0;
    std::atomic<SDL_AudioDeviceID> lost{0};
    bool has_sdl = false;
    std::string trouble;
    std::optional<double> last_time, last_look;
    double owed = 0;  ///< Part of a sample that the clock has gone on.
    std::vector<float> unheard;

    static void SDLCALL sound_wanted(void* state, Uint8* bytes, int count);
    static int SDLCALL event_seen(void* state, SDL_Event* event);
    void look(double time);
    void close_device();
    void go_on_unheard(double time);
    void render(std::span<float> out);
};

void SDLCALL AudioOutput::State::sound_wanted(void* state, Uint8* bytes, int count) {
    // SDL hands out memory that is aligned for the format it was asked for.
    auto* samples = reinterpret_cast<float*>(bytes);  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
    static_cast<State*>(state)->render({samples, static_cast<std::size_t>(count) / sizeof(float)});
}

/// Also sees what another part of the program takes from SDL's queue of events.
int SDLCALL AudioOutput::State::event_seen(void* state, SDL_Event* event) {
    if (event->type == SDL_AUDIODEVICEREMOVED && !event->adevice.iscapture) {
        static_cast<State*>(state)->lost.store(event->adevice.which);
    }
    return 0;
}

void AudioOutput::State::render(std::span<float> out) {
    engine.render(out);
    if (!options.keep) return;
    for (std::size_t i = 0; i + 1 < out.size(); i += 2) kept.put({out[i], out[i + 1]});
}

void AudioOutput::State::look(double time) {
    if (last_look && time - *last_look < kLookAgainAfter) return;
    last_look = time;
    if (!has_sdl) has_sdl = SDL_InitSubSystem(SDL_INIT_AUDIO) == 0;
    SDL_AudioSpec wanted{};
    wanted.freq = kSoundRate;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 2;
    wanted.samples = kFramesACall;
    wanted.callback = sound_wanted;
    wanted.userdata = this;
    if (has_sdl) device = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
    if (device == 0) {
        trouble = SDL_GetError();
        return;
    }
    trouble.clear();
    lost.store(0);
    SDL_PauseAudioDevice(device, 0);
}

void AudioOutput::State::close_device() {
    // Waits until the thread of the device has ended: from here on this thread may render.
    if (device != 0) SDL_CloseAudioDevice(device);
    device = 0;
}

void AudioOutput::State::go_on_unheard(double time) {
    owed += std::clamp(time - last_time.value_or(time), 0.0, kLongestGap) * kSoundRate;
    const double frames = std::max(0.0, std::round(owed));
    owed -= frames;
    unheard.resize(2 * static_cast<std::size_t>(frames));
    render(unheard);
}

AudioOutput::AudioOutput(AudioEngine& engine, const SoundOutputOptions& options)
    : state_(std::make_unique<State>(engine, options)) {
    if (options.device == SoundDevice::Standard) SDL_AddEventWatch(State::event_seen, state_.get());
}

AudioOutput::~AudioOutput() {
    if (state_->options.device == SoundDevice::Standard) SDL_DelEventWatch(State::event_seen, state_.get());
    state_->close_device();
    if (state_->has_sdl) SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

void AudioOutput::update(double time) {
    State& s = *state_;
    if (s.device != 0 &&
        (s.lost.load() == s.device || SDL_GetAudioDeviceStatus(s.device) == SDL_AUDIO_STOPPED)) {
        s.close_device();
        s.trouble = "the sound device is gone";
        s.last_look = time;
    }
    if (s.device == 0 && s.options.device == SoundDevice::Standard) s.look(time);
    if (s.device == 0) s.go_on_unheard(time);
    s.last_time = time;
}

bool AudioOutput::is_heard() const {
    return state_->device != 0;
}

const std::string& AudioOutput::trouble() const {
    return state_->trouble;
}

std::vector<float> AudioOutput::take() {
    std::vector<float> taken;
    if (!state_->options.keep) return taken;
    while (const auto both = state_->kept.take()) taken.insert(taken.end(), both->begin(), both->end());
    return taken;
}

}  // namespace feelem::viewer
