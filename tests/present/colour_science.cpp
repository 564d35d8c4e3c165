// SPDX-License-Identifier: Apache-2.0
// Colour differences as people see them.
#include "present/colour_science.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace feelem::test {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr std::array<Matrix, 4> kMachado{{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
}};
constexpr Matrix kToXyz{{
    {0.4124564, 0.3575761, 0.1804375},
    {0.2126729, 0.7151522, 0.0721750},
    {0.0193339, 0.1191920, 0.9503041},
}};
constexpr std::array<double, 3> kWhite{0.95047, 1.0, 1.08883};

std::array<double, 3> product(const Matrix& matrix, const std::array<double, 3>& v) {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
    }
    return result;
}

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}
double degrees_of(double a, double b) {
    const double angle = std::atan2(b, a) * 180 / std::numbers::pi;
    return angle < 0 ? angle + 360 : angle;
}
double saturation(double chroma) {
    const double power = std::pow(chroma, 7);
    return std::sqrt(power / (power + std::pow(25.0, 7)));
}

}  // namespace

Lab lab_of(const Rgb& colour, Vision vision) {
    std::array<double, 3> linear{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double c = colour[i] / 255.0;
        linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    linear = product(kMachado[static_cast<std::size_t>(vision)], linear);
    for (double& c : linear) {
        c = std::clamp(c, 0.0, 1.0);
    }
    std::array<double, 3> f = product(kToXyz, linear);
    for (std::size_t i = 0; i < 3; ++i) {
        const double c = f[i] / kWhite[i];
        f[i] = c > 216.0 / 24389 ? std::cbrt(c) : (24389.0 / 27 * c + 16) / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double difference(const Lab& first, const Lab& second) {
    const double mean = (std::hypot(first[1], first[2]) + std::hypot(second[1], second[2])) / 2;
    const double stretch = 1 + 0.5 * (1 - saturation(mean));
    const double chroma1 = std::hypot(stretch * first[1], first[2]);
    const double chroma2 = std::hypot(stretch * second[1], second[2]);
    const double hue1 = degrees_of(stretch * first[1], first[2]);
    const double hue2 = degrees_of(stretch * second[1], second[2]);
    const bool grey = chroma1 * chroma2 == 0;

    double turn = grey ? 0 : hue2 - hue1;
    turn += turn > 180 ? -360 : turn < -180 ? 360 : 0;
    double hue = hue1 + hue2;
    if (!grey) {
        const bool wraps = std::abs(hue1 - hue2) > 180;
        hue = (wraps ? hue + (hue < 360 ? 360 : -360) : hue) / 2;
    }
    const double chroma = (chroma1 + chroma2) / 2;
    const double lift = std::pow((first[0] + second[0]) / 2 - 50, 2);
    const double t = 1 - 0.17 * std::cos(radians(hue - 30)) + 0.24 * std::cos(radians(2 * hue)) +
                     0.32 * std::cos(radians(3 * hue + 6)) - 0.20 * std::cos(radians(4 * hue - 63));

    const double light_term = (second[0] - first[0]) / (1 + 0.015 * lift / std::sqrt(20 + lift));
    const double chroma_term = (chroma2 - chroma1) / (1 + 0.045 * chroma);
    const double hue_term =
        2 * std::sqrt(chroma1 * chroma2) * std::sin(radians(turn / 2)) / (1 + 0.015 * chroma * t);
    const double rotation =
        -std::sin(radians(60 * std::exp(-std::pow((hue - 275) / 25, 2)))) * 2 * saturation(chroma);
    return std::sqrt(
        light_term * light_term + chroma_term * chroma_term + hue_term * hue_term +
        rotation * chroma_term * hue_term
    );
}

}  // namespace feelem::test
