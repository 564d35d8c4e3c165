// SPDX-License-Identifier: Apache-2.0
// Every quantity glides, so nothing clicks; the partials are exact sines, so nothing folds back.
#include "viewer/audio/voices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace feelem::viewer {

namespace {

// Time constants in seconds, and levels: the page's.
constexpr double kPitchTau = 0.015;
constexpr double kGainTau = 0.01;
constexpr double kAttackTau = 0.007;
constexpr double kReleaseTau = 0.01;
constexpr double kStopTau = 0.004;
constexpr double kStepBackTau = 0.3;
constexpr double kPatience = 0.6;
constexpr double kStillAfter = 2;
constexpr double kBaseHz = 261.6255653005986;
constexpr double kToneGain = 0.1;
constexpr double kFlutterHz = 8;
constexpr double kOpenHz = 20000, kDullHz = 400;
constexpr double kTickHz = 3200;
constexpr double kNoiseHz = 1000;  // Its middle, where its level is made up for.
constexpr std::size_t kNoiseWeight = 4, kTickWeight = 5;
const double kSteppedBack = std::pow(10.0, -18.0 / 20);
const double kNoiseGain = std::pow(10.0, -24.0 / 20);

}  // namespace

Voices::Voices(EarLevel level) : level_(std::move(level)) {
    tick_at_ = tick_.size();
}

void Voices::update(const std::optional<SoundFrame>& frame, SoundTime now) {
    if (!frame) {
        clock_.stop();
        if (is_open_) close(now, kReleaseTau);
        return;
    }
    clock_.update(static_cast<double>(now) / kSoundRate, frame->tick_rate);
    steer(*frame);
    if (frame->gain > 0 && frame->hz > 0) {
        sing(*frame, now);
    } else if (is_open_) {
        close(now, kReleaseTau);
    }
}

void Voices::stop(SoundTime now) {
    clock_.stop();
    close(now, kStopTau);
}

bool Voices::is_silent(SoundTime now) const {
    return now >= silent_from_ && tick_at_ >= tick_.size();
}

void Voices::steer(const SoundFrame& frame) {
    plain_.to(frame.negative ? 0 : 1, kGainTau);
    hollow_.to(frame.negative ? 1 : 0, kGainTau);
    cutoff_.to(frame.dull ? kDullHz : kOpenHz, kPitchTau);
    tremolo_.to(frame.tremolo ? 0.75 : 1, kGainTau);
    depth_.to(frame.tremolo ? 0.25 : 0, kGainTau);
}

void Voices::sing(const SoundFrame& frame, SoundTime now) {
    const double cents = 1200 * std::log2(frame.hz / kBaseHz);
    const auto [level, tau] = presence(frame.still, now);
    // A tone that starts anew starts at its pitch: nobody should hear where the last one ended.
    if (now >= silent_from_) {
        cents_.jump(cents);
        loudness_.jump(frame.gain);
        is_anew_ = true;
    } else {
        cents_.to(cents, kPitchTau);
        loudness_.to(frame.gain * level, tau);
    }
    gate_.to(1, kAttackTau);
    silent_from_ = now + gate_.fade_out(kReleaseTau, samples_of(kPatience));
    is_open_ = true;
}

std::array<double, 2> Voices::presence(bool is_still, SoundTime now) {
    if (!is_still) {
        still_since_ = now;
        return {1, kGainTau};
    }
    if (!still_since_) still_since_ = now;
    if (now - *still_since_ >= samples_of(kStillAfter)) return {kSteppedBack, kStepBackTau};
    return {1, kGainTau};
}

void Voices::close(SoundTime now, double tau) {
    silent_from_ = std::min(silent_from_, now + gate_.fade_out(tau));
    is_open_ = false;
    still_since_.reset();
}

std::array<double, 6> Voices::weights_at(const glm::vec3& place) const {
    const EarLevel::Factors factors = level_.towards(place);
    const double hz = kBaseHz * std::exp2(cents_.value() / 1200);
    return {
        factors.at(hz),
        factors.at(2 * hz),
        factors.at(3 * hz),
        factors.at(4 * hz),
        factors.at(kNoiseHz),
        factors.at(kTickHz)};
}

void Voices::render(SoundTime now, const glm::vec3& place, VoicesStep& step) {
    // The weights follow pitch and place in straight lines from step to step.
    const std::array<double, 6> wanted = weights_at(place);
    if (is_anew_) weights_ = wanted;
    is_anew_ = false;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        weight_steps_[k] = (wanted[k] - weights_[k]) / static_cast<double>(kSoundStep);
    }
    for (std::size_t i = 0; i < kSoundStep; ++i) {
        const Pair tone = next_tone();
        const Pair tick = next_tick(now + static_cast<SoundTime>(i));
        step.plain[i] = static_cast<float>(kToneGain * tone.plain + tick.plain);
        step.made_up[i] = static_cast<float>(kToneGain * tone.made_up + tick.made_up);
    }
}

Voices::Pair Voices::next_tone() {
    const double angle = 2 * std::numbers::pi * phase_;
    phase_ += kBaseHz * std::exp2(cents_.next() / 1200) / kSoundRate;
    phase_ -= std::floor(phase_);
    const double plain = plain_.next(), hollow = hollow_.next();
    const double noise = kNoiseGain * hush_.next(static_cast<double>(noise_[noise_at_]));
    noise_at_ = (noise_at_ + 1) % noise_.size();
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const double twice = 2 * sine * cosine, cosine_twice = 1 - 2 * sine * sine;
    const std::array<double, 4> sines{sine, twice, sine * (3 - 4 * sine * sine), 2 * twice * cosine_twice};
    Pair sum{hollow * noise, hollow * noise * weights_[kNoiseWeight]};
    for (std::size_t k = 0; k < sines.size(); ++k) {
        const double partial = (plain * kTonePartials[k] + hollow * kNegativePartials[k]) * sines[k];
        sum.plain += partial;
        sum.made_up += partial * weights_[k];
    }
    for (std::size_t k = 0; k < weights_.size(); ++k) weights_[k] += weight_steps_[k];
    if (const double hz = cutoff_.next(); hz != filter_hz_) {
        filter_.set(hz);
        made_up_filter_.set(hz);
        filter_hz_ = hz;
    }
    const double flutter = std::sin(2 * std::numbers::pi * flutter_);
    flutter_ += kFlutterHz / kSoundRate;
    flutter_ -= std::floor(flutter_);
    const double level = (tremolo_.next() + depth_.next() * flutter) * loudness_.next() * gate_.next();
    return {level * filter_.next(sum.plain), level * made_up_filter_.next(sum.made_up)};
}

Voices::Pair Voices::next_tick(SoundTime now) {
    if (clock_.begins(static_cast<double>(now) / kSoundRate)) tick_at_ = 0;
    if (tick_at_ >= tick_.size()) return {};
    const auto sample = static_cast<double>(tick_[tick_at_++]);
    return {sample, sample * weights_[kTickWeight]};
}

}  // namespace feelem::viewer
