// SPDX-License-Identifier: Apache-2.0
#include "scene/steps.hpp"

#include <algorithm>

namespace feelem::gltf {

std::optional<Steps> steps_within(const std::array<float, 2>& range, double bound) {
    const double low = static_cast<double>(range[0]), high = static_cast<double>(range[1]);
    const double rounding = std::max(std::abs(low), std::abs(high)) * 0x1p-23;
    const double width = 2 * (bound * (high - low) - rounding);
    if (!(bound > 0) || !(width > 8 * rounding) || !std::isfinite(width)) return std::nullopt;
    // Both ends of the range are steps, so that nothing lies beyond them that did not: counted from the end
    // nearer to zero, which keeps the other one exact too.
    const double step = (high - low) / std::ceil((high - low) / width);
    if (std::abs(low) <= std::abs(high)) return Steps{low, step};
    return Steps{high, -step};
}

bool round_to_steps(const Steps& steps, std::span<float> values) {
    constexpr double kMost = 2147483647.0;
    const bool fits = std::ranges::all_of(values, [&](float value) {
        return !std::isfinite(value) || std::abs(steps.number(static_cast<double>(value))) <= kMost;
    });
    if (!fits) return false;
    for (float& value : values) {
        if (std::isfinite(value)) value = steps.value(steps.number(static_cast<double>(value)));
    }
    return true;
}

float grid_of(double largest) {
    return static_cast<float>(std::exp2(std::floor(std::log2(largest / 65536))));
}

}  // namespace feelem::gltf
