// SPDX-License-Identifier: Apache-2.0
#include "derive/tensor.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace feelem {
namespace {

constexpr int kMostSweeps = 50;

/// One Jacobi rotation that makes a[p][q] zero (Golub & Van Loan, Matrix Computations, 8.5.2).
void rotate(Matrix3& a, std::size_t p, std::size_t q) noexcept {
    const double off = a[p][q];
    if (off == 0) return;
    const double tau = (a[q][q] - a[p][p]) / (2 * off);
    const double t = std::copysign(1.0, tau) / (std::abs(tau) + std::hypot(1.0, tau));
    const double c = 1 / std::sqrt(1 + t * t);
    const double s = t * c;
    const std::size_t r = 3 - p - q;
    a[p][p] -= t * off;
    a[q][q] += t * off;
    a[p][q] = a[q][p] = 0;
    const double rp = a[r][p];
    const double rq = a[r][q];
    a[r][p] = a[p][r] = c * rp - s * rq;
    a[r][q] = a[q][r] = s * rp + c * rq;
}

}  // namespace

std::array<double, 3> eigenvalues(const Tensor6& tensor) noexcept {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (!std::ranges::all_of(tensor, [](double v) { return std::isfinite(v); })) return {nan, nan, nan};
    Matrix3 a = matrix_of(tensor);
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        const double off = std::abs(a[0][1]) + std::abs(a[1][2]) + std::abs(a[0][2]);
        const double diagonal = std::abs(a[0][0]) + std::abs(a[1][1]) + std::abs(a[2][2]);
        if (off <= 1e-20 * diagonal) break;
        rotate(a, 0, 1);
        rotate(a, 1, 2);
        rotate(a, 0, 2);
    }
    std::array<double, 3> values{a[0][0], a[1][1], a[2][2]};
    std::ranges::sort(values, std::greater{});
    return values;
}

}  // namespace feelem
