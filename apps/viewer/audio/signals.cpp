// SPDX-License-Identifier: Apache-2.0
// Noise is made by a generator of our own, so that it is the same everywhere.
#include "viewer/audio/signals.hpp"

#include "viewer/audio/audio_engine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace feelem::viewer {

namespace {

/// A repeatable row of numbers in -1..1 (xorshift32).
class Noise {
public:
    explicit Noise(std::uint32_t seed) : state_(seed) {}
    double next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 17;
        state_ ^= state_ << 5;
        return state_ / 2147483648.0 - 1;
    }

private:
    std::uint32_t state_;
};

constexpr double kTickSeconds = 0.016;
constexpr double kTickPeak = 0.2;
constexpr double kKnee = 0.4;
const double kCeiling = std::pow(10.0, -6.0 / 20);

void scale_to_peak(std::vector<float>& samples, double wanted) {
    double peak = 0;
    for (const float sample : samples) peak = std::max(peak, std::abs(static_cast<double>(sample)));
    for (float& sample : samples) sample = static_cast<float>(sample * wanted / peak);
}

}  // namespace

std::vector<float> tick_samples() {
    std::vector<float> samples(static_cast<std::size_t>(std::lround(kTickSeconds * kSoundRate)));
    Noise noise(0x2545f491);
    const double w = 2 * std::numbers::pi * 3200 / kSoundRate;
    const double alpha = std::sin(w) / 8;
    const double b = alpha / (1 + alpha);
    const double a1 = -2 * std::cos(w) / (1 + alpha), a2 = (1 - alpha) / (1 + alpha);
    double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
    const auto next = [&] {
        const double x = noise.next();
        const double y = b * (x - x2) - a1 * y1 - a2 * y2;
        x2 = x1, x1 = x, y2 = y1, y1 = y;
        return y;
    };
    constexpr int kWarmUp = 200;
    for (int i = 0; i < kWarmUp; ++i) next();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double t = static_cast<double>(i) / kSoundRate;
        const double attack = std::min(1.0, t / 0.001);
        const double decay = std::exp(-std::max(0.0, t - 0.001) / 0.004);
        const double end = std::max(0.0, std::min(1.0, (kTickSeconds - t) / 0.002));
        samples[i] = static_cast<float>(next() * attack * decay * end);
    }
    scale_to_peak(samples, kTickPeak);
    return samples;
}

std::vector<float> pink_noise() {
    std::vector<float> samples(2 * kSoundRate);
    Noise noise(0x9e3779b9);
    double b0 = 0, b1 = 0, b2 = 0;
    for (float& sample : samples) {
        const double white = noise.next();
        b0 = 0.99765 * b0 + white * 0.099046;
        b1 = 0.963 * b1 + white * 0.2965164;
        b2 = 0.57 * b2 + white * 1.0526913;
        sample = static_cast<float>(b0 + b1 + b2 + white * 0.1848);
    }
    scale_to_peak(samples, 1);
    return samples;
}

double limited(double x) {
    const double size = std::min(std::abs(x), 1.0);
    if (size <= kKnee) return x;
    const double room = kCeiling - kKnee;
    return std::copysign(kKnee + room * std::tanh((size - kKnee) / room), x);
}

LowPass::LowPass(double hz, double quality_decibel) : quality_(std::pow(10.0, quality_decibel / 20)) {
    set(hz);
}

void LowPass::set(double hz) {
    const double w = 2 * std::numbers::pi * hz / kSoundRate;
    const double alpha = std::sin(w) / (2 * quality_);
    const double cosine = std::cos(w);
    b0_ = (1 - cosine) / 2 / (1 + alpha);
    b1_ = (1 - cosine) / (1 + alpha);
    a1_ = -2 * cosine / (1 + alpha);
    a2_ = (1 - alpha) / (1 + alpha);
}

double LowPass::next(double x) {
    const double y = b0_ * x + b1_ * x1_ + b0_ * x2_ - a1_ * y1_ - a2_ * y2_;
    x2_ = x1_, x1_ = x;
    y2_ = y1_, y1_ = y;
    return y;
}

}  // namespace feelem::viewer
