// SPDX-License-Identifier: Apache-2.0
// Value -> ticks a second for the ear, pulses a second and their strength for the hand (docs/effects.md 4,
// 5).
#include "feelem/present.hpp"

#include <cmath>

namespace feelem {
namespace {

/// Equal ratios: low at 0, high at 1.
double geometric(double low, double high, double share) {
    return low * std::pow(high / low, share);
}

}  // namespace

double tick_rate_of(double value, const ValueRange& range, const TickEffect& effect) {
    const Normalised place = normalise(value, range);
    return place.missing
               ? 0
               : geometric(effect.rate_low, effect.rate_high, effect.invert ? 1 - place.u : place.u);
}

Pulse pulse_of(double value, const ValueRange& range, const PulseEffect& effect) {
    const Normalised place = normalise(value, range);
    if (place.missing) {
        return {};
    }
    const double share = effect.invert ? 1 - place.u : place.u;
    return {geometric(effect.rate_low, effect.rate_high, share), geometric(effect.amplitude_min, 1, share)};
}

}  // namespace feelem
