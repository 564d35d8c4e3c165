// SPDX-License-Identifier: Apache-2.0
// The spectrum of the impulse's answer in both ears, direction by direction.
#include "viewer/audio/ear_level.hpp"

#include "viewer/audio/audio_engine.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace feelem::viewer {

namespace {

constexpr double kLowestHz = 50, kPitchesPerOctave = 4;
constexpr std::size_t kAzimuths = 24, kElevations = 13;
constexpr double kDegreesApart = 15;
constexpr std::size_t kAnswerSteps = 3;
constexpr double kMostMadeUp = 4;  // 12 dB: where ears have a notch, leave it one.
constexpr double kDegree = std::numbers::pi / 180;

/// Clockwise from ahead, as seen from above; upwards.
glm::vec3 direction_at(std::size_t azimuth, std::size_t elevation) {
    const double a = kDegreesApart * static_cast<double>(azimuth) * kDegree;
    const double e = (kDegreesApart * static_cast<double>(elevation) - 90) * kDegree;
    return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

using Answer = std::array<StereoStep, kAnswerSteps>;

Answer answer_from(Spatialiser& spatialiser, const glm::vec3& direction) {
    Answer answer{};
    MonoStep in{};
    spatialiser.render(in, direction, answer[0]);  // It turns within a step.
    in[0] = 1;
    spatialiser.render(in, direction, answer[0]);  // What comes out lags by a step.
    in[0] = 0;
    for (StereoStep& step : answer) spatialiser.render(in, direction, step);
    return answer;
}

/// e to the -i w t for each sample of an answer.
std::vector<std::complex<double>> wave_of(double hz) {
    std::vector<std::complex<double>> wave(kAnswerSteps * kSoundStep);
    for (std::size_t i = 0; i < wave.size(); ++i) {
        wave[i] = std::polar(1.0, -2 * std::numbers::pi * hz * static_cast<double>(i) / kSoundRate);
    }
    return wave;
}

/// Of both ears together, at the wave's pitch.
double power_of(const Answer& answer, const std::vector<std::complex<double>>& wave) {
    std::complex<double> left = 0, right = 0;
    for (std::size_t i = 0; i < wave.size(); ++i) {
        const StereoStep& step = answer[i / kSoundStep];
        const std::size_t at = 2 * (i % kSoundStep);
        left += static_cast<double>(step[at]) * wave[i];
        right += static_cast<double>(step[at + 1]) * wave[i];
    }
    return std::norm(left) + std::norm(right);
}

}  // namespace

EarLevel EarLevel::measured(Spatialiser& spatialiser) {
    std::vector<std::vector<std::complex<double>>> waves;
    for (std::size_t pitch = 0; pitch < Factors::kPitches; ++pitch) {
        waves.push_back(wave_of(kLowestHz * std::exp2(static_cast<double>(pitch) / kPitchesPerOctave)));
    }
    EarLevel level;
    for (std::size_t elevation = 0; elevation < kElevations; ++elevation) {
        for (std::size_t azimuth = 0; azimuth < kAzimuths; ++azimuth) {
            const Answer answer = answer_from(spatialiser, direction_at(azimuth, elevation));
            Factors factors;
            for (std::size_t pitch = 0; pitch < Factors::kPitches; ++pitch) {
                const double factor = 1 / std::sqrt(std::max(power_of(answer, waves[pitch]), 1e-12));
                factors.factors_[pitch] = std::clamp(factor, 1 / kMostMadeUp, kMostMadeUp);
            }
            level.factors_.push_back(factors);
        }
    }
    answer_from(spatialiser, {0, 0, -1});
    return level;
}

EarLevel::Factors EarLevel::towards(const glm::vec3& direction) const {
    const double size = glm::length(direction);
    const double up = size > 0 ? std::clamp(direction.y / size, -1.0, 1.0) : 0;
    const double turn = size > 0 ? std::atan2(direction.x, -direction.z) / kDegree : 0;
    const double azimuth = (turn < 0 ? turn + 360 : turn) / kDegreesApart;
    const double elevation = (std::asin(up) / kDegree + 90) / kDegreesApart;
    const auto a = static_cast<std::size_t>(azimuth) % kAzimuths;
    const auto e = std::min(static_cast<std::size_t>(elevation), kElevations - 2);
    const double to_a = azimuth - std::floor(azimuth), to_e = elevation - static_cast<double>(e);
    const auto row = [&](std::size_t e_at, std::size_t a_at) -> const Factors& {
        return factors_[e_at * kAzimuths + a_at % kAzimuths];
    };
    Factors between;
    for (std::size_t i = 0; i < Factors::kPitches; ++i) {
        const double low = row(e, a).factors_[i] * (1 - to_a) + row(e, a + 1).factors_[i] * to_a;
        const double high = row(e + 1, a).factors_[i] * (1 - to_a) + row(e + 1, a + 1).factors_[i] * to_a;
        between.factors_[i] = low * (1 - to_e) + high * to_e;
    }
    return between;
}

double EarLevel::Factors::at(double hz) const {
    const double place = kPitchesPerOctave * std::log2(std::max(hz, kLowestHz) / kLowestHz);
    if (!(place < static_cast<double>(kPitches - 1))) return factors_.back();
    const auto below = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(below);
    return factors_[below] + share * (factors_[below + 1] - factors_[below]);
}

}  // namespace feelem::viewer
