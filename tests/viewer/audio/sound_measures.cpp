// SPDX-License-Identifier: Apache-2.0
// The measures are those of web/test/sense/signal.ts.
#include "viewer/audio/sound_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace feelem::test {

namespace {

using viewer::kSoundRate;

double correlation_at(std::span<const float> x, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = 0; i + lag < x.size(); ++i) {
        sum += static_cast<double>(x[i]) * static_cast<double>(x[i + lag]);
    }
    return sum / static_cast<double>(x.size() - lag);
}

double top_between(double a, double b, double c) {
    const double bend = a - 2 * b + c;
    return bend == 0 ? 0 : 0.5 * (a - c) / bend;
}

double peak_near(std::span<const float> x, double lag, std::size_t reach) {
    const auto middle = static_cast<std::size_t>(std::lround(lag));
    std::size_t best = middle;
    double most = correlation_at(x, best);
    for (std::size_t l = middle - reach; l <= middle + reach; ++l) {
        if (const double here = correlation_at(x, l); here > most) {
            most = here;
            best = l;
        }
    }
    return static_cast<double>(best) +
           top_between(correlation_at(x, best - 1), most, correlation_at(x, best + 1));
}

}  // namespace

double decibel(double ratio) {
    return 20 * std::log10(ratio);
}

std::span<const float> part(std::span<const float> samples, double from, double to) {
    const auto first = static_cast<std::size_t>(std::lround(from * kSoundRate));
    const auto last = std::min(static_cast<std::size_t>(std::lround(to * kSoundRate)), samples.size());
    return samples.subspan(first, last - first);
}

double peak(std::span<const float> samples) {
    double most = 0;
    for (const float x : samples) most = std::max(most, std::abs(static_cast<double>(x)));
    return most;
}

double rms(std::span<const float> samples) {
    double sum = 0;
    for (const float x : samples) sum += static_cast<double>(x) * static_cast<double>(x);
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

double amplitude_at(std::span<const float> samples, double hz) {
    double re = 0, im = 0, weight = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto at = static_cast<double>(i);
        const double window =
            0.5 - 0.5 * std::cos(2 * std::numbers::pi * at / static_cast<double>(samples.size() - 1));
        const double phase = 2 * std::numbers::pi * hz * at / kSoundRate;
        const double x = static_cast<double>(samples[i]) * window;
        re += x * std::cos(phase);
        im += x * std::sin(phase);
        weight += window;
    }
    return 2 * std::hypot(re, im) / weight;
}

double fundamental(std::span<const float> samples) {
    constexpr std::size_t kShortest = kSoundRate / 2200, kLongest = kSoundRate / 60;
    std::vector<double> all;
    for (std::size_t lag = kShortest; lag <= kLongest; ++lag) all.push_back(correlation_at(samples, lag));
    const double most = *std::max_element(all.begin(), all.end());
    // The first of the equal peaks is the period; the others are its multiples. A lag near zero is no period.
    std::size_t first = 0;
    while (first + 1 < all.size() && all[first + 1] < all[first]) ++first;
    while (first < all.size() && all[first] <= 0.9 * most) ++first;
    while (first + 1 < all.size() && all[first + 1] > all[first]) ++first;
    double period = peak_near(samples, static_cast<double>(kShortest + first), 2);
    for (const int count : {2, 4, 8, 16, 32}) {
        if (count * period > 0.4 * static_cast<double>(samples.size())) break;
        period = peak_near(samples, count * period, 3) / count;
    }
    return kSoundRate / period;
}

Samples high_passed(std::span<const float> samples, double hz) {
    std::vector<double> y(samples.begin(), samples.end());
    for (const double q : {0.5411961, 1.306563}) {
        const double w = 2 * std::numbers::pi * hz / kSoundRate;
        const double cosine = std::cos(w), alpha = std::sin(w) / (2 * q);
        const double a0 = 1 + alpha, b0 = (1 + cosine) / 2 / a0, b1 = -(1 + cosine) / a0;
        const double a1 = -2 * cosine / a0, a2 = (1 - alpha) / a0;
        double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
        for (double& v : y) {
            const double out = b0 * v + b1 * x1 + b0 * x2 - a1 * y1 - a2 * y2;
            x2 = x1, x1 = v, y2 = y1, y1 = out;
            v = out;
        }
    }
    return {y.begin(), y.end()};
}

double click_level(std::span<const float> samples) {
    return decibel(peak(high_passed(samples, 12000)));
}

std::vector<double> onsets(std::span<const float> samples, double level) {
    const double rest = 0.02 * kSoundRate;
    std::vector<double> times;
    double loud_at = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto at = static_cast<double>(i);
        if (std::abs(static_cast<double>(samples[i])) <= level) continue;
        if (at - loud_at > rest) times.push_back(at / kSoundRate);
        loud_at = at;
    }
    return times;
}

double lag_of(std::span<const float> left, std::span<const float> right) {
    constexpr int kReach = 60;  // 1.25 ms: no head is wider.
    std::array<double, 2 * kReach + 1> sums{};
    for (int lag = -kReach; lag <= kReach; ++lag) {
        double sum = 0;
        for (std::size_t i = kReach; i + kReach < left.size(); ++i) {
            const auto other = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + lag);
            sum += static_cast<double>(left[i]) * static_cast<double>(right[other]);
        }
        sums[static_cast<std::size_t>(lag + kReach)] = sum;
    }
    const auto best =
        static_cast<std::size_t>(std::max_element(sums.begin() + 1, sums.end() - 1) - sums.begin());
    return static_cast<double>(best) - kReach + top_between(sums[best - 1], sums[best], sums[best + 1]);
}

viewer::SoundFrame tone_frame(double u) {
    const Tone tone = tone_of(u, {0, 1, Scale::Linear}, {});
    viewer::SoundFrame frame;
    frame.hz = tone.hz;
    frame.gain = tone.gain;
    return frame;
}

Listening::Listening(const viewer::AudioOptions& options, std::size_t block)
    : engine_(options), block_(block) {}

void Listening::listen_until(double time) {
    const auto wanted = static_cast<std::size_t>(std::lround(time * kSoundRate));
    std::vector<float> out;
    while (heard_.left.size() < wanted) {
        out.assign(2 * std::min(block_, wanted - heard_.left.size()), 9);
        engine_.render(out);
        for (std::size_t i = 0; i < out.size(); i += 2) {
            heard_.left.push_back(out[i]);
            heard_.right.push_back(out[i + 1]);
        }
    }
}

void Listening::say(const std::optional<viewer::SoundFrame>& frame, std::vector<viewer::SenseEvent> events) {
    viewer::Snapshot snapshot;
    snapshot.frame = frame_++;
    snapshot.time = time();
    snapshot.sound = frame;
    snapshot.events = std::move(events);
    engine_.update(snapshot, true);
}

void Listening::frames_until(
    double time, const std::function<std::optional<viewer::SoundFrame>(double)>& frame
) {
    const double from = this->time();
    const auto count = static_cast<int>(std::floor((time - from) * 72 + 1e-9));
    for (int i = 0; i < count; ++i) {
        listen_until(from + i / 72.0);
        say(frame(from + i / 72.0));
    }
    listen_until(time);
}

void Listening::hold_until(double time, const viewer::SoundFrame& frame) {
    frames_until(time, [&](double) { return frame; });
}

}  // namespace feelem::test
