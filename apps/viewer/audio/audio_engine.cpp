// SPDX-License-Identifier: Apache-2.0
// Voices -> direction -> master -> limiter; earcons join after the direction, because they come from nowhere.
#include "viewer/audio/audio_engine.hpp"

#include "viewer/audio/earcons.hpp"
#include "viewer/audio/hand_over.hpp"
#include "viewer/audio/voices.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace feelem::viewer {

namespace {

constexpr double kFirstTau = 0.05;  // Of the master, when the engine is made.
constexpr double kMasterTau = 0.04;
constexpr double kMuteTau = 0.01;
constexpr double kLeaveTau = 0.004;
constexpr double kComeTau = 0.007;
constexpr double kMonoTau = 0.01;
constexpr double kDuckTau = 0.01, kUnduckTau = 0.03, kDucked = 0.5;
constexpr double kTurnTau = 0.015;
constexpr SoundTime kTail = 1024;  // Samples that the mixer into directions rings on, and to spare.
constexpr std::size_t kMostEvents = 64;

/// What the frame's thread wants; the newest counts.
struct Wish {
    std::uint64_t updates = 0;  ///< How often a frame was said.
    std::uint64_t stops = 0;    ///< How often silence was asked for.
    std::optional<SoundFrame> frame;
    bool is_muted = false, is_mono = false;
    double master = 0.5;
};

struct QueuedEvent {
    SenseEvent event{};
    std::uint64_t stops = 0;  ///< At the time; what was before a stop is not heard after it.
};

double within_0_1(double value) {
    return value > 0 ? std::min(value, 1.0) : 0;
}

/// What no number of a frame can break: a filter that has once heard NaN never sounds again.
SoundFrame made_safe(SoundFrame frame) {
    constexpr double kLowestHz = 20, kHighestHz = 5000, kFastestTicks = 100;
    if (!std::isfinite(frame.hz) || !std::isfinite(frame.gain)) frame.gain = 0;
    frame.gain = within_0_1(frame.gain);
    // The fourth partial stays below half of the sound's rate.
    frame.hz = frame.hz > 0 ? std::clamp(frame.hz, kLowestHz, kHighestHz) : 0;
    frame.tick_rate = frame.tick_rate > 0 ? std::min(frame.tick_rate, kFastestTicks) : 0;
    return frame;
}

glm::vec3 unit_or_ahead(const glm::vec3& direction) {
    const float length = glm::length(direction);
    return length > 1e-6F && std::isfinite(length) ? direction / length : glm::vec3(0, 0, -1);
}

/// A share of the turn from one unit direction to another.
glm::vec3 turned_towards(const glm::vec3& from, const glm::vec3& to, float share) {
    constexpr float kThere = 1e-4F;
    const float angle = std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
    if (angle < kThere) return to;
    glm::vec3 aside = to - from * glm::dot(from, to);
    // Straight behind: any way is the shortest.
    if (glm::length(aside) < kThere)
        aside = glm::cross(from, std::abs(from.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
    aside = glm::normalize(aside);
    return from * std::cos(share * angle) + aside * std::sin(share * angle);
}

/// Everything that belongs to the thread that renders.
class Mixer {
public:
    explicit Mixer(const AudioOptions& options)
        : voices_(EarLevel::measured(spatialiser_)), master_wanted_(within_0_1(options.master)),
          is_mono_(options.mono || !spatialiser_.works()), panned_(is_mono_ ? 0 : 1),
          centred_(is_mono_ ? std::numbers::sqrt2 / 2 : 0) {
        master_.to(master_wanted_, kFirstTau);
    }

    const std::string& directions() const { return spatialiser_.words(); }
    void heed(const Wish& wish);
    void event(SenseEvent event);
    void render(StereoStep& out);

private:
    void come();
    void leave();
    void turn();
    void set_mono(bool is_mono);

    Spatialiser spatialiser_;
    Voices voices_;
    EarconPlayer earcons_;
    VoicesStep step_;
    StereoStep turned_{};
    SoundTime now_ = 0;
    std::uint64_t updates_ = 0, stops_ = 0;
    double master_wanted_;
    bool is_muted_ = false, is_mono_;
    Glide master_{0}, leave_{1}, panned_, centred_, duck_{1};
    bool has_left_ = false;
    SoundTime gone_from_ = 0;  ///< From when on it is silent after it has left.
    glm::vec3 place_{0, 0, -1}, place_wanted_{0, 0, -1};
};

void Mixer::heed(const Wish& wish) {
    if (wish.stops != stops_) {
        stops_ = wish.stops;
        leave();
    }
    if (wish.is_muted != is_muted_ || wish.master != master_wanted_) {
        is_muted_ = wish.is_muted;
        master_wanted_ = wish.master;
        if (is_muted_) {
            master_.fade_out(kMuteTau);
        } else {
            master_.to(master_wanted_, kMasterTau);
        }
    }
    set_mono(wish.is_mono);
    if (wish.updates != updates_) {
        updates_ = wish.updates;
        if (wish.frame) {
            come();
            place_wanted_ = unit_or_ahead(wish.frame->source);
            if (voices_.is_silent(now_)) place_ = place_wanted_;
        }
        voices_.update(wish.frame ? std::optional(made_safe(*wish.frame)) : std::nullopt, now_);
    }
}

void Mixer::set_mono(bool is_mono) {
    is_mono = is_mono || !spatialiser_.works();
    if (is_mono == is_mono_) return;
    is_mono_ = is_mono;
    if (is_mono) {
        panned_.fade_out(kMonoTau);
        centred_.to(std::numbers::sqrt2 / 2, kMonoTau);
    } else {
        panned_.to(1, kMonoTau);
        centred_.fade_out(kMonoTau);
    }
}

void Mixer::event(SenseEvent event) {
    if (has_left_) earcons_.silence(now_);
    if (!earcons_.play(event, now_)) return;
    come();
    duck_.to(kDucked, kDuckTau);
    duck_.to_later(samples_of(earcon_of(event).seconds()), 1, kUnduckTau);
}

void Mixer::leave() {
    voices_.stop(now_);
    if (has_left_) return;
    has_left_ = true;
    gone_from_ = now_ + leave_.fade_out(kLeaveTau) + kTail;
}

void Mixer::come() {
    if (!has_left_) return;
    has_left_ = false;
    if (now_ >= gone_from_) {
        earcons_.silence(now_);
        leave_.jump(1);
    } else {
        leave_.to(1, kComeTau);
    }
}

/// Around the head by the shortest way, the faster the further it is.
void Mixer::turn() {
    static const auto share =
        static_cast<float>(-std::expm1(-static_cast<double>(kSoundStep) / (kSoundRate * kTurnTau)));
    if (place_ != place_wanted_) place_ = turned_towards(place_, place_wanted_, share);
}

void Mixer::render(StereoStep& out) {
    turn();
    voices_.render(now_, place_, step_);
    std::array<double, kSoundStep> ducked;
    for (std::size_t i = 0; i < kSoundStep; ++i) {
        ducked[i] = duck_.next();
        step_.made_up[i] = static_cast<float>(step_.made_up[i] * ducked[i]);
    }
    spatialiser_.render(step_.made_up, place_, turned_);
    for (std::size_t i = 0; i < kSoundStep; ++i) {
        const double centred = centred_.next() * ducked[i] * static_cast<double>(step_.plain[i]);
        const double both = centred + earcons_.next(now_ + static_cast<SoundTime>(i));
        const double panned = panned_.next();
        const double level = master_.next() * leave_.next();
        for (std::size_t ear = 0; ear < 2; ++ear) {
            const double x = level * (both + panned * static_cast<double>(turned_[2 * i + ear]));
            out[2 * i + ear] = static_cast<float>(limited(x));
        }
    }
    now_ += static_cast<SoundTime>(kSoundStep);
}

}  // namespace

struct AudioEngine::State {
    explicit State(const AudioOptions& options) : mixer(options) {
        wish.master = within_0_1(options.master);
        wish.is_mono = options.mono;
        newest.put(wish);
    }

    Wish wish;  ///< Of the frame's thread.
    bool was_focused = true;
    Newest<Wish> newest;
    Queue<QueuedEvent> events{kMostEvents};

    Mixer mixer;  ///< From here on, of the thread that renders.
    StereoStep step{};
    std::size_t taken = 2 * kSoundStep;

    void make_step() {
        const Wish& wanted = newest.get();
        mixer.heed(wanted);
        while (const std::optional<QueuedEvent> queued = events.take()) {
            if (queued->stops >= wanted.stops) mixer.event(queued->event);
        }
        mixer.render(step);
        taken = 0;
    }
};

AudioEngine::AudioEngine(const AudioOptions& options) : state_(std::make_unique<State>(options)) {}

AudioEngine::~AudioEngine() = default;

void AudioEngine::update(const Snapshot& snapshot, bool is_focused) {
    State& s = *state_;
    if (!is_focused) {
        if (s.was_focused) stop();
        s.was_focused = false;
        return;
    }
    s.was_focused = true;
    s.wish.updates++;
    s.wish.frame = snapshot.sound;
    s.newest.put(s.wish);
    for (const SenseEvent event : snapshot.events) s.events.put({event, s.wish.stops});
}

void AudioEngine::stop() {
    state_->wish.stops++;
    state_->wish.frame.reset();
    state_->newest.put(state_->wish);
}

void AudioEngine::set_muted(bool muted) {
    state_->wish.is_muted = muted;
    state_->newest.put(state_->wish);
}

void AudioEngine::set_master(double master) {
    state_->wish.master = within_0_1(master);
    state_->newest.put(state_->wish);
}

void AudioEngine::set_mono(bool mono) {
    state_->wish.is_mono = mono;
    state_->newest.put(state_->wish);
}

void AudioEngine::render(std::span<float> stereo) {
    State& s = *state_;
    for (std::size_t at = 0; at < stereo.size();) {
        if (s.taken == s.step.size()) s.make_step();
        const std::size_t count = std::min(stereo.size() - at, s.step.size() - s.taken);
        std::copy_n(s.step.data() + s.taken, count, stereo.data() + at);
        s.taken += count;
        at += count;
    }
}

const std::string& AudioEngine::directions() const {
    return state_->mixer.directions();
}

}  // namespace feelem::viewer
