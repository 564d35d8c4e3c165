// SPDX-License-Identifier: Apache-2.0
// Where a value lies in its range (docs/effects.md 1): the one number that all senses share.
#include "feelem/present.hpp"

#include <algorithm>
#include <cmath>

namespace feelem {
namespace {

/// Linear within a thousandth of the largest magnitude, logarithmic beyond.
double symmetric_log(double value, double half_width) {
    return std::copysign(std::log10(1 + std::abs(value) / half_width), value);
}

/// (value - lo) / (hi - lo), and the middle of a range without width.
double fraction(double value, double lo, double hi) {
    return hi > lo ? std::clamp((value - lo) / (hi - lo), 0.0, 1.0) : 0.5;
}

}  // namespace

Normalised normalise(double value, const ValueRange& range) {
    Normalised result;
    if (std::isnan(value) || !std::isfinite(range.lo) || !std::isfinite(range.hi)) {
        result.missing = true;
        return result;
    }
    const double magnitude = std::max(std::abs(range.lo), std::abs(range.hi));
    const bool is_signed = range.scale == Scale::Signed;
    const double lo = is_signed ? -magnitude : range.lo;
    const double hi = is_signed ? magnitude : range.hi;
    result.below = value < lo;
    result.above = value > hi;
    result.sign = value < 0 ? -1 : 1;

    const double inside = std::min(std::max(value, lo), std::max(lo, hi));
    if (is_signed) {
        result.u = magnitude > 0 ? std::abs(inside) / magnitude : 0;
        result.position = fraction(inside, lo, hi);
        return result;
    }
    if (range.scale == Scale::Log && lo > 0) {
        result.u = fraction(std::log10(inside), std::log10(lo), std::log10(hi));
    } else if (range.scale == Scale::Linear || magnitude == 0) {
        result.u = fraction(inside, lo, hi);
    } else {  // SymLog, and Log over a range that reaches zero.
        const double half_width = 1e-3 * magnitude;
        result.u = fraction(
            symmetric_log(inside, half_width), symmetric_log(lo, half_width), symmetric_log(hi, half_width)
        );
    }
    result.position = result.u;
    return result;
}

double automatic_deformation_factor(double largest_side, double largest_displacement) {
    const double factor = 0.05 * largest_side / largest_displacement;
    return largest_displacement > 0 && std::isfinite(factor) ? factor : 0;
}

}  // namespace feelem
