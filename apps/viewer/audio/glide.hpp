// SPDX-License-Identifier: Apache-2.0
// A quantity of the sound that moves sample by sample, so that no change clicks: what the page's AudioParams
// do.
#pragma once

#include "viewer/audio/audio_engine.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace feelem::viewer {

/// Samples of the engine's clock.
using SoundTime = std::int64_t;

inline SoundTime samples_of(double seconds) {
    return std::llround(seconds * kSoundRate);
}

class Glide {
public:
    explicit Glide(double value) : value_(value), target_(value) {}

    void jump(double value) {
        count_ = 0;
        hold(value);
    }
    /// Leaves it where it is and moves it towards the target, quickly at first.
    void to(double target, double tau) {
        count_ = 0;
        move(target, tau);
    }
    /// The same, but only after some samples; what was planned before stays planned.
    void to_later(SoundTime wait, double target, double tau) { plan({wait, target, tau}); }
    /// Fades to exactly nothing after some samples; gives how many it takes in all.
    SoundTime fade_out(double tau, SoundTime wait = 0) {
        const SoundTime end = wait + samples_of(kTausOfFade * tau);
        if (wait == 0) {
            to(0, tau);
        } else {
            plan({wait, 0, tau});
        }
        plan({end, 0, 0});
        return end;
    }

    double value() const { return value_; }
    double next() {
        while (count_ > 0 && planned_[0].wait == 0) {
            if (planned_[0].tau > 0) {
                move(planned_[0].target, planned_[0].tau);
            } else {
                hold(planned_[0].target);
            }
            planned_[0] = planned_[1];
            --count_;
        }
        for (std::size_t i = 0; i < count_; ++i) --planned_[i].wait;
        const double now = value_;
        if (value_ != target_) {
            value_ += (target_ - value_) * share_;
            if (std::abs(target_ - value_) < kNear) value_ = target_;
        }
        return now;
    }

private:
    static constexpr double kTausOfFade = 11;
    static constexpr double kNear = 1e-9;  ///< -180 dB: there is no getting nearer.
    struct Step {
        SoundTime wait;
        double target, tau;  ///< tau 0: at once.
    };
    void hold(double value) { value_ = target_ = value; }
    void move(double target, double tau) {
        target_ = target;
        share_ = -std::expm1(-1 / (kSoundRate * tau));
    }
    void plan(const Step& step) {
        if (count_ < planned_.size()) planned_[count_++] = step;
    }

    double value_, target_, share_ = 0;
    std::array<Step, 2> planned_{};
    std::size_t count_ = 0;
};

}  // namespace feelem::viewer
