// SPDX-License-Identifier: Apache-2.0
// One AL source, fed by a queue that always holds one step more than is being played: the source never runs
// dry.
#include "viewer/audio/spatialiser.hpp"

#include "viewer/audio/audio_engine.hpp"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <glm/geometric.hpp>

namespace feelem::viewer {

namespace {

constexpr std::size_t kQueue = 4;

template <class Function>
Function function_of(const char* name) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): what alcGetProcAddress is for.
    return reinterpret_cast<Function>(alcGetProcAddress(nullptr, name));
}

}  // namespace

/// Makes a context this thread's for a while: another library's, or another engine's, stays as it is.
class Spatialiser::Turn {
public:
    explicit Turn(const State& state);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

private:
    const State& state_;
    ALCcontext* before_;
};

struct Spatialiser::State {
    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;
    LPALCRENDERSAMPLESSOFT render_samples = nullptr;
    PFNALCSETTHREADCONTEXTPROC set_thread_context = nullptr;
    PFNALCGETTHREADCONTEXTPROC get_thread_context = nullptr;
    ALuint source = 0;
    std::array<ALuint, kQueue> buffers{};
    std::string words = "centred";

    bool open();
    bool queue(ALuint buffer, const MonoStep& samples) const;
    bool start();
    void close();
};

Spatialiser::Turn::Turn(const State& state) : state_(state), before_(state.get_thread_context()) {
    state_.set_thread_context(state_.context);
}

Spatialiser::Turn::~Turn() {
    state_.set_thread_context(before_);
}

bool Spatialiser::State::open() {
    const auto open_loopback = function_of<LPALCLOOPBACKOPENDEVICESOFT>("alcLoopbackOpenDeviceSOFT");
    render_samples = function_of<LPALCRENDERSAMPLESSOFT>("alcRenderSamplesSOFT");
    set_thread_context = function_of<PFNALCSETTHREADCONTEXTPROC>("alcSetThreadContext");
    get_thread_context = function_of<PFNALCGETTHREADCONTEXTPROC>("alcGetThreadContext");
    if (!open_loopback || !render_samples || !set_thread_context || !get_thread_context) return false;
    device = open_loopback(nullptr);
    if (!device) return false;
    const std::array<ALCint, 13> wanted{
        ALC_FORMAT_CHANNELS_SOFT,
        ALC_STEREO_SOFT,
        ALC_FORMAT_TYPE_SOFT,
        ALC_FLOAT_SOFT,
        ALC_FREQUENCY,
        kSoundRate,
        ALC_HRTF_SOFT,
        ALC_TRUE,
        // Ours comes last and bends nothing that is quiet enough.
        ALC_OUTPUT_LIMITER_SOFT,
        ALC_FALSE,
        ALC_MONO_SOURCES,
        1,
        0};
    context = alcCreateContext(device, wanted.data());
    if (!context) return false;
    const Turn turn(*this);
    ALCint status = ALC_HRTF_DISABLED_SOFT;
    alcGetIntegerv(device, ALC_HRTF_STATUS_SOFT, 1, &status);
    const bool has_hrtf = status == ALC_HRTF_ENABLED_SOFT || status == ALC_HRTF_REQUIRED_SOFT;
    const ALCchar* name = has_hrtf ? alcGetString(device, ALC_HRTF_SPECIFIER_SOFT) : nullptr;
    words = name ? std::string("HRTF ") + name : "panned";
    return alIsExtensionPresent("AL_EXT_FLOAT32") == AL_TRUE;
}

bool Spatialiser::State::queue(ALuint buffer, const MonoStep& samples) const {
    alBufferData(buffer, AL_FORMAT_MONO_FLOAT32, samples.data(), sizeof samples, kSoundRate);
    alSourceQueueBuffers(source, 1, &buffer);
    return alGetError() == AL_NO_ERROR;
}

bool Spatialiser::State::start() {
    const Turn turn(*this);
    alGetError();
    alGenBuffers(static_cast<ALsizei>(buffers.size()), buffers.data());
    alGenSources(1, &source);
    // Direction only: nothing gets quieter with distance.
    alDistanceModel(AL_NONE);
    alSourcei(source, AL_SOURCE_RELATIVE, AL_TRUE);
    alSource3f(source, AL_POSITION, 0, 0, -1);
    if (alGetError() != AL_NO_ERROR) return false;
    const MonoStep silence{};
    for (const ALuint buffer : buffers) {
        if (!queue(buffer, silence)) return false;
    }
    alSourcePlay(source);
    // All but one of the steps are played here, so that what comes later is one step late and no more.
    StereoStep unheard;
    for (std::size_t i = 1; i < buffers.size(); ++i) {
        render_samples(device, unheard.data(), kSoundStep);
    }
    return alGetError() == AL_NO_ERROR;
}

void Spatialiser::State::close() {
    if (context) {
        {
            const Turn turn(*this);
            if (source) alDeleteSources(1, &source);
            if (buffers.front()) alDeleteBuffers(static_cast<ALsizei>(buffers.size()), buffers.data());
        }
        alcDestroyContext(context);
    }
    if (device) alcCloseDevice(device);
    context = nullptr;
    device = nullptr;
}

Spatialiser::Spatialiser() : state_(std::make_unique<State>()) {
    if (state_->open() && state_->start()) return;
    state_->close();
    state_->words = "centred";
}

Spatialiser::~Spatialiser() {
    state_->close();
}

const std::string& Spatialiser::words() const {
    return state_->words;
}

bool Spatialiser::works() const {
    return state_->context != nullptr;
}

void Spatialiser::render(const MonoStep& mono, const glm::vec3& direction, StereoStep& stereo) {
    State& s = *state_;
    stereo.fill(0);
    if (!s.context) return;
    const Turn turn(s);
    const float length = glm::length(direction);
    const glm::vec3 unit = length > 1e-6F ? direction / length : glm::vec3(0, 0, -1);
    alSource3f(s.source, AL_POSITION, unit.x, unit.y, unit.z);
    ALint played = 0;
    alGetSourcei(s.source, AL_BUFFERS_PROCESSED, &played);
    if (played > 0) {
        ALuint buffer = 0;
        alSourceUnqueueBuffers(s.source, 1, &buffer);
        s.queue(buffer, mono);
    }
    ALint state = AL_PLAYING;
    alGetSourcei(s.source, AL_SOURCE_STATE, &state);
    if (state != AL_PLAYING) alSourcePlay(s.source);
    s.render_samples(s.device, stereo.data(), kSoundStep);
}

}  // namespace feelem::viewer
