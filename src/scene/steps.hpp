// SPDX-License-Identifier: Apache-2.0
// What compressed scenes round to: even steps for results, a grid for what is drawn.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

namespace feelem::gltf {

/// A value is offset + step * number, computed in double and rounded once to float32. Numbers are signed, of
/// 32 bits; glTF, which has no such type, sees their bits as unsigned ones.
struct Steps {
    double offset = 0, step = 0;

    float value(double number) const { return static_cast<float>(offset + step * number); }
    double number(double value) const { return std::nearbyint((value - offset) / step); }
};

/// What a normal is rounded to where positions are: a direction is off by 0.2 degrees at most.
inline constexpr float kNormalGrid = 0x1p-8F;
/// The same for texture coordinates: the distance that a value at the end of a range keeps from it.
inline constexpr float kTexcoordGrid = 0x1p-15F;

/// Steps on which no value of the range is moved by more than `bound` of its width, and its ends not at all.
/// Nothing when that saves nothing: steps hardly wider than float32's own.
std::optional<Steps> steps_within(const std::array<float, 2>& range, double bound);

/// Rounds all of them, but for those that are missing. False, and nothing changed, when one is beyond the
/// steps' numbers.
bool round_to_steps(const Steps& steps, std::span<float> values);

/// The power of two that divides `largest` into 65,536 pieces or up to twice as many.
float grid_of(double largest);

/// The nearest multiple of a power of two; the value itself for a grid of 0.
inline float on_grid(double value, float grid) {
    const double wide = static_cast<double>(grid);
    return static_cast<float>(grid > 0 ? std::nearbyint(value / wide) * wide : value);
}

}  // namespace feelem::gltf
