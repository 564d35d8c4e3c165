// SPDX-License-Identifier: Apache-2.0
// Where values lie in their ranges.
#include "feelem/present.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace feelem {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Normalise, linear_range_maps_its_ends_to_zero_and_one) {
    const ValueRange range{150, 200, Scale::Linear};

    EXPECT_EQ(normalise(150, range).u, 0);
    EXPECT_EQ(normalise(200, range).u, 1);
    EXPECT_EQ(normalise(162.5, range).u, 0.25);
    EXPECT_EQ(normalise(162.5, range).position, 0.25);
}

TEST(Normalise, ends_of_the_range_are_inside_it) {
    const ValueRange range{150, 200, Scale::Linear};

    EXPECT_FALSE(normalise(150, range).below);
    EXPECT_FALSE(normalise(200, range).above);
    EXPECT_TRUE(normalise(std::nextafter(150.0, 0.0), range).below);
    EXPECT_TRUE(normalise(std::nextafter(200.0, 300.0), range).above);
}

TEST(Normalise, values_outside_are_clamped_and_flagged) {
    const ValueRange range{-1, 1, Scale::Linear};

    EXPECT_EQ(normalise(-kInfinity, range).u, 0);
    EXPECT_TRUE(normalise(-kInfinity, range).below);
    EXPECT_EQ(normalise(kInfinity, range).u, 1);
    EXPECT_TRUE(normalise(kInfinity, range).above);
    EXPECT_EQ(normalise(7, range).u, 1);
}

TEST(Normalise, missing_is_neither_low_nor_high) {
    const Normalised place = normalise(kNaN, {0, 1, Scale::Linear});

    EXPECT_TRUE(place.missing);
    EXPECT_FALSE(place.below);
    EXPECT_FALSE(place.above);
}

TEST(Normalise, unusable_range_gives_missing) {
    EXPECT_TRUE(normalise(0.5, {kNaN, 1, Scale::Linear}).missing);
    EXPECT_TRUE(normalise(0.5, {0, kInfinity, Scale::Linear}).missing);
}

TEST(Normalise, range_without_width_puts_its_value_in_the_middle) {
    for (const Scale scale : {Scale::Linear, Scale::Log, Scale::SymLog}) {
        const Normalised place = normalise(5, {5, 5, scale});

        EXPECT_EQ(place.u, 0.5);
        EXPECT_FALSE(place.below || place.above || place.missing);
    }
    EXPECT_TRUE(normalise(6, {5, 5, Scale::Linear}).above);
    EXPECT_EQ(normalise(0, {0, 0, Scale::SymLog}).u, 0.5);
}

TEST(Normalise, log_scale_gives_equal_steps_to_equal_ratios) {
    const ValueRange range{0.01, 100, Scale::Log};

    EXPECT_NEAR(normalise(0.1, range).u, 0.25, 1e-15);
    EXPECT_NEAR(normalise(1, range).u, 0.5, 1e-15);
    EXPECT_NEAR(normalise(10, range).u, 0.75, 1e-15);
    EXPECT_TRUE(normalise(0, range).below);
    EXPECT_EQ(normalise(-3, range).u, 0);
}

TEST(Normalise, log_scale_that_reaches_zero_is_symmetric_log) {
    for (const double value : {0.0, 0.5, 20.0, 99.0}) {
        EXPECT_EQ(normalise(value, {0, 100, Scale::Log}).u, normalise(value, {0, 100, Scale::SymLog}).u);
    }
    EXPECT_NEAR(normalise(0.1, {0, 100, Scale::SymLog}).u, std::log10(2) / std::log10(1001), 1e-15);
}

TEST(Normalise, symmetric_log_has_zero_in_the_middle_of_a_symmetric_range) {
    const ValueRange range{-100, 100, Scale::SymLog};

    EXPECT_NEAR(normalise(0, range).u, 0.5, 1e-15);
    EXPECT_NEAR(normalise(10, range).u + normalise(-10, range).u, 1, 1e-15);
    EXPECT_LT(normalise(1, range).u, normalise(2, range).u);
}

TEST(Normalise, signed_scale_hears_the_magnitude_and_sees_the_sign) {
    const ValueRange range{-50, 200, Scale::Signed};

    const Normalised tension = normalise(100, range);
    const Normalised pressure = normalise(-100, range);

    EXPECT_EQ(tension.u, 0.5);
    EXPECT_EQ(pressure.u, 0.5);
    EXPECT_EQ(tension.sign, 1);
    EXPECT_EQ(pressure.sign, -1);
    EXPECT_EQ(tension.position, 0.75);
    EXPECT_EQ(pressure.position, 0.25);
    EXPECT_FALSE(pressure.below) << "the range of a signed result is symmetric";
    EXPECT_TRUE(normalise(-201, range).below);
    EXPECT_EQ(normalise(-201, range).u, 1);
}

TEST(DeformationFactor, largest_displacement_becomes_a_twentieth_of_the_largest_side) {
    EXPECT_EQ(automatic_deformation_factor(1000, 2), 25);
    EXPECT_EQ(automatic_deformation_factor(1000, 0), 0);
    EXPECT_EQ(automatic_deformation_factor(1000, kNaN), 0);
    EXPECT_EQ(automatic_deformation_factor(kInfinity, 1), 0);
}

}  // namespace
}  // namespace feelem
