// SPDX-License-Identifier: Apache-2.0
#include "model/rotation.hpp"

#include <cmath>
#include <numbers>

namespace feelem {
std::array<double, 2> sine_and_cosine(double degrees) noexcept {
    const double turned = std::remainder(degrees, 360.0);
    const double quarters = turned / 90;
    if (quarters == std::trunc(quarters)) {
        constexpr double kSines[]{0, -1, 0, 1, 0};
        const auto i = static_cast<int>(quarters) + 2;  // -2..2 quarters
        return {kSines[i], i == 2 ? 1.0 : (i == 0 || i == 4 ? -1.0 : 0.0)};
    }
    const double radians = turned * std::numbers::pi / 180;
    return {std::sin(radians), std::cos(radians)};
}

Matrix3 from_columns(const Point3& x, const Point3& y, const Point3& z) noexcept {
    return {{{x[0], y[0], z[0]}, {x[1], y[1], z[1]}, {x[2], y[2], z[2]}}};
}

Matrix3 product(const Matrix3& a, const Matrix3& b) noexcept {
    Matrix3 out{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t j = 0; j < 3; ++j) out[i][k] += a[i][j] * b[j][k];
        }
    }
    return out;
}

Matrix3 matrix_of(const Tensor6& t) noexcept {
    return {{{t[0], t[3], t[5]}, {t[3], t[1], t[4]}, {t[5], t[4], t[2]}}};
}

Matrix3 nodal_axes(const NodalAngles& angles) noexcept {
    const auto [sz, cz] = sine_and_cosine(angles[0]);
    const auto [sx, cx] = sine_and_cosine(angles[1]);
    const auto [sy, cy] = sine_and_cosine(angles[2]);
    const Matrix3 about_z{{{cz, -sz, 0}, {sz, cz, 0}, {0, 0, 1}}};
    const Matrix3 about_x{{{1, 0, 0}, {0, cx, -sx}, {0, sx, cx}}};
    const Matrix3 about_y{{{cy, 0, sy}, {0, 1, 0}, {-sy, 0, cy}}};
    return product(product(about_z, about_x), about_y);
}

std::array<double, 3> to_global(const Matrix3& axes, const std::array<double, 3>& vector) noexcept {
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            if (axes[i][j] != 0) out[i] += axes[i][j] * vector[j];
        }
    }
    return out;
}

Tensor6 to_global(const Matrix3& axes, const Tensor6& tensor) noexcept {
    const Matrix3 local = matrix_of(tensor);
    const auto component = [&](std::size_t i, std::size_t k) {
        double sum = 0;
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) {
                const double coefficient = axes[i][a] * axes[k][b];
                if (coefficient != 0) sum += coefficient * local[a][b];
            }
        }
        return sum;
    };
    return {
        component(0, 0), component(1, 1), component(2, 2), component(0, 1), component(1, 2), component(2, 0)};
}

}  // namespace feelem
