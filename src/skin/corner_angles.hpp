// SPDX-License-Identifier: Apache-2.0
// Angles at the corners of triangles: one, or eight at once with the same bits.
#pragma once

#include "feelem/mesh.hpp"

#include <array>
#include <cstddef>

namespace feelem {

/// From 0 to pi.
double angle_between(const Point3& a, const Point3& b) noexcept;

/// Eight pairs of vectors, axis by axis.
struct EightPairs {
    static constexpr std::size_t kCount = 8;
    std::array<std::array<double, kCount>, 3> a, b;

    void set(std::size_t i, const Point3& from_a, const Point3& from_b) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            a[axis][i] = from_a[axis];
            b[axis][i] = from_b[axis];
        }
    }
};
using EightAngles = std::array<double, EightPairs::kCount>;

/// angle_between of each pair.
EightAngles angles_between(const EightPairs& pairs) noexcept;

/// What angles_between chooses from; tests compare them. The others say false where the processor is not for
/// them.
EightAngles angles_between_portably(const EightPairs& pairs) noexcept;
bool angles_between_with_avx2(const EightPairs& pairs, EightAngles& out) noexcept;
bool angles_between_with_avx512(const EightPairs& pairs, EightAngles& out) noexcept;

}  // namespace feelem
