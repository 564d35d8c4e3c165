// SPDX-License-Identifier: Apache-2.0
// Angles are right, and the same bits whichever way they are found.
#include "skin/corner_angles.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace feelem {
namespace {

/// Of every size, some equal, opposite, square to each other, or without a length.
EightPairs odd_pairs(std::mt19937& random) {
    std::uniform_real_distribution<double> anything(-1, 1);
    EightPairs pairs{};
    for (std::size_t i = 0; i < EightPairs::kCount; ++i) {
        const double size = std::pow(10.0, 60 * anything(random));
        Point3 a{size * anything(random), size * anything(random), size * anything(random)};
        Point3 b{anything(random), anything(random), anything(random)};
        switch (random() % 8) {
        case 0: b = a; break;
        case 1: b = {-a[0], -a[1], -a[2]}; break;
        case 2: b = {-a[1], a[0], 0}; break;
        case 3: b = {0, -0.0, 0}; break;
        case 4: a = {size, 0, 0}, b = {1, 1, 0}; break;
        default: break;
        }
        pairs.set(i, a, b);
    }
    return pairs;
}

std::array<std::uint64_t, EightPairs::kCount> bits_of(const EightAngles& angles) {
    return std::bit_cast<std::array<std::uint64_t, EightPairs::kCount>>(angles);
}

TEST(CornerAngles, are_those_of_the_vectors) {
    EXPECT_NEAR(angle_between({1, 0, 0}, {0, 2, 0}), std::numbers::pi / 2, 1e-15);
    EXPECT_NEAR(angle_between({1, 0, 0}, {3, 3, 0}), std::numbers::pi / 4, 1e-15);
    EXPECT_NEAR(angle_between({1, 0, 0}, {-1, 0, 0}), std::numbers::pi, 1e-15);
    EXPECT_NEAR(angle_between({1, 0, 0}, {1, std::tan(0.1), 0}), 0.1, 1e-15);
    EXPECT_EQ(angle_between({1, 0, 0}, {0, 0, 0}), 0);
}

TEST(CornerAngles, of_eight_pairs_are_bit_for_bit_those_of_each) {
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        const EightPairs pairs = odd_pairs(random);
        const auto one_by_one = bits_of(angles_between_portably(pairs));
        EXPECT_EQ(bits_of(angles_between(pairs)), one_by_one) << round;
        EightAngles angles{};
        if (angles_between_with_avx2(pairs, angles)) {
            EXPECT_EQ(bits_of(angles), one_by_one) << round;
        }
        if (angles_between_with_avx512(pairs, angles)) {
            EXPECT_EQ(bits_of(angles), one_by_one) << round;
        }
    }
}

}  // namespace
}  // namespace feelem
