// SPDX-License-Identifier: Apache-2.0
// The tone and the ticks, made sample by sample: what web/src/sense/audio.ts builds of the browser's nodes.
#pragma once

#include "viewer/audio/ear_level.hpp"
#include "viewer/audio/glide.hpp"
#include "viewer/audio/signals.hpp"
#include "viewer/audio/tick_clock.hpp"
#include "viewer/core/senses.hpp"

#include "feelem/present.hpp"

#include <array>
#include <optional>
#include <vector>

namespace feelem::viewer {

/// One step of sound, twice: as it is, and with each pitch made up for how strong it comes from where it is.
struct VoicesStep {
    MonoStep plain{}, made_up{};
};

class Voices {
public:
    explicit Voices(EarLevel level);
    /// What is to be heard from `now` on; empty: release (80 ms).
    void update(const std::optional<SoundFrame>& frame, SoundTime now);
    /// As a release, but in half the time.
    void stop(SoundTime now);
    /// `place`: where it comes from, in the axes of the head.
    void render(SoundTime now, const glm::vec3& place, VoicesStep& step);
    /// Nothing has sounded for long enough that a new place needs no way to it.
    bool is_silent(SoundTime now) const;

private:
    struct Pair {
        double plain = 0, made_up = 0;
    };
    void steer(const SoundFrame& frame);
    void sing(const SoundFrame& frame, SoundTime now);
    /// How far the tone steps back, and how slowly.
    std::array<double, 2> presence(bool is_still, SoundTime now);
    void close(SoundTime now, double tau);
    Pair next_tone();
    Pair next_tick(SoundTime now);
    std::array<double, 6> weights_at(const glm::vec3& place) const;

    EarLevel level_;
    std::vector<float> noise_ = pink_noise();
    std::vector<float> tick_ = tick_samples();
    TickClock clock_;

    Glide cents_{0}, plain_{1}, hollow_{0}, cutoff_{20000}, tremolo_{1}, depth_{0}, loudness_{0}, gate_{0};
    LowPass hush_{4000, 1}, filter_{20000, -3}, made_up_filter_{20000, -3};
    double filter_hz_ = 20000;
    double phase_ = 0, flutter_ = 0;
    /// Of the four partials, the noise and the ticks, and how they change from sample to sample.
    std::array<double, 6> weights_{}, weight_steps_{};
    bool is_anew_ = true;
    std::size_t noise_at_ = 0, tick_at_ = 0;
    bool is_open_ = false;
    SoundTime silent_from_ = 0;
    std::optional<SoundTime> still_since_;
};

}  // namespace feelem::viewer
