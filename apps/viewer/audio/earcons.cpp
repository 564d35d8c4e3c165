// SPDX-License-Identifier: Apache-2.0
// Pure tones with raised-cosine edges.
#include "viewer/audio/earcons.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace feelem::viewer {

namespace {

const double kThird = std::exp2(4.0 / 12);  // An equal-tempered major third.
constexpr double kRest = 0.5;               // Between two of a kind, seconds.

// In the order of SenseEvent.
const std::array<Earcon, 8> kEarcons{{
    {5, -14, 0.06, 0.06, {1500, 1500}, 2},
    {5, -14, 0.06, 0, {750}, 1},
    {4, -18, 0.09, 0, {880, 880 * kThird}, 2},
    {4, -18, 0.09, 0, {880, 880 / kThird}, 2},
    {3, -18, 0.06, 0, {110}, 1},
    {2, -26, 0.008, 0, {1300}, 1},
    {2, -26, 0.008, 0, {950}, 1},
    {1, -30, 0.03, 0, {500}, 1},
}};

double sample_of(const Earcon& earcon, double time) {
    const double each = earcon.beep_seconds + earcon.gap_seconds;
    const auto beep = static_cast<std::size_t>(std::max(0.0, std::floor(time / each)));
    const double within = time - static_cast<double>(beep) * each;
    if (beep >= earcon.beeps || within >= earcon.beep_seconds) return 0;
    const double edge = std::min(0.01, earcon.beep_seconds / 3);
    const double part = std::min(1.0, std::min(within, earcon.beep_seconds - within) / edge);
    const double level =
        std::pow(10.0, earcon.decibel / 20) * (0.5 - 0.5 * std::cos(std::numbers::pi * part));
    return level * std::sin(2 * std::numbers::pi * earcon.pitches[beep] * within);
}

}  // namespace

const Earcon& earcon_of(SenseEvent event) {
    return kEarcons[static_cast<std::size_t>(event)];
}

bool EarconPlayer::play(SenseEvent event, SoundTime now) {
    const auto kind = static_cast<std::size_t>(event);
    const Earcon& earcon = earcon_of(event);
    if (was_played_[kind] && now - last_[kind] < samples_of(kRest)) return false;
    if (now < ends_ && earcon.weight <= weight_) return false;
    was_played_[kind] = true;
    last_[kind] = now;
    ends_ = now + samples_of(earcon.seconds());
    weight_ = earcon.weight;
    if (count_ < sounding_.size()) sounding_[count_++] = {event, now, ends_};
    return true;
}

void EarconPlayer::silence(SoundTime now) {
    count_ = 0;
    ends_ = now;
}

double EarconPlayer::next(SoundTime now) {
    double sum = 0;
    for (std::size_t i = 0; i < count_;) {
        if (now >= sounding_[i].end) {
            sounding_[i] = sounding_[--count_];
            continue;
        }
        sum += sample_of(
            earcon_of(sounding_[i].event), static_cast<double>(now - sounding_[i].start) / kSoundRate
        );
        ++i;
    }
    return sum;
}

}  // namespace feelem::viewer
