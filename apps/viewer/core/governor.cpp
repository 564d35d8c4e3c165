// SPDX-License-Identifier: Apache-2.0
#include "viewer/core/governor.hpp"

#include <algorithm>
#include <utility>

namespace feelem::viewer {
namespace {

constexpr int kMostPatience = 16;
// Shares of the budget: past the first the picture gets coarser, past the second by two levels at once; a
// finer level is tried when it may be expected to take the third.
constexpr double kTooSlow = 1.25, kFarTooSlow = 4, kQuick = 0.9;
/// A program that was asleep says nothing of its frames.
constexpr double kAsleepSeconds = 3;

double median_of(std::vector<double> times) {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    return *middle;
}

/// Worst case: all time goes into pixels.
double cost_of_finer(std::size_t level) {
    if (level == 0) return 1;
    const double ratio = kFineness[level - 1].resolution / kFineness[level].resolution;
    return ratio * ratio;
}

}  // namespace

void govern(Governor& governor, double seconds, double budget) {
    if (!(seconds > 0 && seconds < kAsleepSeconds)) return;
    governor.times.push_back(seconds);
    if (governor.times.size() < kGovernorRound) return;
    const double median = median_of(std::exchange(governor.times, {}));
    if (median > kTooSlow * budget) {
        governor.quick_rounds = 0;
        const std::size_t steps = median > kFarTooSlow * budget ? 2 : 1;
        const std::size_t coarser = std::min(governor.level + steps, kFineness.size() - 1);
        if (coarser == governor.level) return;
        if (std::exchange(governor.tried, false))
            governor.patience = std::min(2 * governor.patience, kMostPatience);
        governor.level = coarser;
        return;
    }
    if (governor.level == 0 || median * cost_of_finer(governor.level) > kQuick * budget) {
        governor.quick_rounds = 0;
        return;
    }
    if (++governor.quick_rounds < governor.patience) return;
    governor.quick_rounds = 0;
    governor.tried = true;
    --governor.level;
}

}  // namespace feelem::viewer
