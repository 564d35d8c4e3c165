// SPDX-License-Identifier: Apache-2.0
// The colour maps: their known rows, their order by lightness, bands told apart, colours beside the map.
#include "present/colour_science.hpp"

#include "feelem/error.hpp"
#include "feelem/present.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace feelem {
namespace {

using ::testing::ElementsAre;

TEST(ColourMap, lists_the_maps_with_the_default_first) {
    const auto maps = colour_maps();

    EXPECT_THAT(
        std::vector<std::string_view>(maps.begin(), maps.end()),
        ElementsAre("batlow", "viridis", "cividis", "turbo", "ansys_rainbow", "cool_warm")
    );
    EXPECT_EQ(ColourEffect{}.map, "batlow");
}

TEST(ColourMap, has_the_rows_its_author_published) {
    EXPECT_EQ(map_colour("batlow", 0), (Rgb{1, 25, 89}));
    EXPECT_EQ(map_colour("batlow", 128 / 255.0), (Rgb{130, 130, 49}));
    EXPECT_EQ(map_colour("batlow", 1), (Rgb{250, 204, 250}));
    EXPECT_EQ(map_colour("viridis", 0), (Rgb{68, 1, 84}));
    EXPECT_EQ(map_colour("viridis", 1), (Rgb{253, 231, 37}));
    EXPECT_EQ(map_colour("cividis", 0), (Rgb{0, 34, 78}));
    EXPECT_EQ(map_colour("cividis", 1), (Rgb{254, 232, 56}));
    EXPECT_EQ(map_colour("turbo", 0), (Rgb{48, 18, 59}));
    EXPECT_EQ(map_colour("turbo", 1), (Rgb{122, 4, 3}));
    EXPECT_EQ(map_colour("cool_warm", 0), (Rgb{59, 76, 192}));
    EXPECT_EQ(map_colour("cool_warm", 0.25), (Rgb{141, 176, 254}));
    EXPECT_EQ(map_colour("cool_warm", 0.5), (Rgb{221, 221, 221}));
    EXPECT_EQ(map_colour("cool_warm", 0.75), (Rgb{244, 154, 123}));
    EXPECT_EQ(map_colour("cool_warm", 1), (Rgb{180, 4, 38}));
}

TEST(ColourMap, nine_bands_of_ansys_rainbow_are_the_nine_contour_colours) {
    const ColourEffect effect{.map = "ansys_rainbow"};
    const std::array<Rgb, 9> contours{{
        {0, 0, 255},
        {0, 178, 255},
        {0, 255, 255},
        {0, 255, 178},
        {0, 255, 0},
        {178, 255, 0},
        {255, 255, 0},
        {255, 178, 0},
        {255, 0, 0},
    }};

    for (int band = 0; band < 9; ++band) {
        EXPECT_EQ(palette_colour((band + 0.5) / 9, effect), contours.at(static_cast<std::size_t>(band)))
            << band;
    }
}

TEST(ColourMap, V2_sequential_maps_grow_lighter_from_low_to_high) {
    for (const char* map : {"batlow", "viridis", "cividis"}) {
        double last = -1;
        for (int i = 0; i <= 255; i += 3) {
            const double lightness = test::lab_of(map_colour(map, i / 255.0))[0];
            EXPECT_GT(lightness, last) << map << " row " << i;
            last = lightness;
        }
    }
}

TEST(ColourMap, diverging_map_is_lightest_in_the_middle_and_symmetric) {
    const double middle = test::lab_of(map_colour("cool_warm", 0.5))[0];

    for (int i = 1; i <= 128; ++i) {
        const double low = test::lab_of(map_colour("cool_warm", 0.5 - i / 256.0))[0];
        const double high = test::lab_of(map_colour("cool_warm", 0.5 + i / 256.0))[0];
        EXPECT_LT(low, middle);
        EXPECT_NEAR(low, high, 1.0) << i;
    }
}

TEST(ColourMap, colour_difference_formula_agrees_with_published_pairs) {
    EXPECT_NEAR(test::difference({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 5e-5);
    EXPECT_NEAR(test::difference({50, 0, 0}, {50, -1, 2}), 2.3669, 5e-5);
    EXPECT_NEAR(test::difference({2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}), 0.9082, 5e-5);
}

TEST(ColourMap, V1_nine_default_bands_are_told_apart_with_any_colour_vision) {
    double least = std::numeric_limits<double>::infinity();
    for (const test::Vision vision : test::kVisions) {
        std::vector<test::Lab> bands;
        for (int band = 0; band < 9; ++band) {
            bands.push_back(test::lab_of(palette_colour((band + 0.5) / 9, {}), vision));
        }
        for (std::size_t i = 0; i < bands.size(); ++i) {
            for (std::size_t j = i + 1; j < bands.size(); ++j) {
                const double apart = test::difference(bands[i], bands[j]);
                EXPECT_GE(apart, 6.0) << i << " and " << j;
                least = std::min(least, apart);
            }
        }
    }
    RecordProperty("measured", fmt::format("{:.2f}", least));
}

TEST(ColourMap, V3_special_colours_differ_from_every_band_and_from_each_other) {
    const ColourEffect effect;
    double least_normal = std::numeric_limits<double>::infinity();
    double least = least_normal;
    std::vector<Rgb> special{effect.above, effect.below, effect.missing};
    for (std::size_t i = 0; i < special.size(); ++i) {
        std::vector<Rgb> others(special.begin() + static_cast<std::ptrdiff_t>(i) + 1, special.end());
        for (int band = 0; band < 9; ++band) {
            others.push_back(palette_colour((band + 0.5) / 9, effect));
        }
        for (const Rgb& other : others) {
            const double normal = test::difference(test::lab_of(special[i]), test::lab_of(other));
            EXPECT_GE(normal, 12.0);
            least_normal = std::min(least_normal, normal);
            for (const test::Vision vision : test::kVisions) {
                const double apart =
                    test::difference(test::lab_of(special[i], vision), test::lab_of(other, vision));
                EXPECT_GE(apart, 6.0);
                least = std::min(least, apart);
            }
        }
    }
    RecordProperty("measured", fmt::format("{:.1f} normal, {:.1f} of all visions", least_normal, least));
}

TEST(ColourOf, band_edges_belong_to_the_upper_band_and_the_last_value_to_the_last) {
    const ColourEffect effect{.map = "ansys_rainbow"};
    const ValueRange range{0, 9, Scale::Linear};

    EXPECT_EQ(colour_of(0.999, range, effect), (Rgb{0, 0, 255}));
    EXPECT_EQ(colour_of(1, range, effect), (Rgb{0, 178, 255}));
    EXPECT_EQ(colour_of(9, range, effect), (Rgb{255, 0, 0}));
    EXPECT_EQ(band_of(1, 9), 8);
}

TEST(ColourOf, values_beside_the_range_take_the_special_colours) {
    const ColourEffect effect;
    const ValueRange range{0, 1, Scale::Linear};

    EXPECT_EQ(colour_of(-0.1, range, effect), effect.below);
    EXPECT_EQ(colour_of(1.1, range, effect), effect.above);
    EXPECT_EQ(colour_of(std::numeric_limits<double>::quiet_NaN(), range, effect), effect.missing);
}

TEST(ColourOf, inverted_map_swaps_its_ends_but_not_the_special_colours) {
    ColourEffect effect;
    effect.invert = true;
    const ValueRange range{0, 1, Scale::Linear};

    EXPECT_EQ(colour_of(0, range, effect), map_colour("batlow", 1));
    EXPECT_EQ(colour_of(1, range, effect), map_colour("batlow", 0));
    EXPECT_EQ(colour_of(2, range, effect), effect.above);
}

TEST(ColourOf, zero_of_a_signed_result_is_the_middle_of_the_map) {
    const ColourEffect effect{.map = "cool_warm", .bands = 0};

    EXPECT_EQ(colour_of(0, {-3, 10, Scale::Signed}, effect), (Rgb{221, 221, 221}));
}

TEST(ColourOf, odd_counts_of_bands_do_not_break_it) {
    EXPECT_EQ(palette_colour(0.3, {.bands = 1}), map_colour("batlow", 0.5));
    EXPECT_EQ(palette_colour(std::numeric_limits<double>::quiet_NaN(), {}), map_colour("batlow", 0));
    EXPECT_EQ(palette_colour(1e300, {.bands = 2'000'000'000}), map_colour("batlow", 1));
}

TEST(ColourMap, unknown_name_is_answered_with_the_names_there_are) {
    try {
        map_colour("jet", 0.5);
        FAIL() << "accepted an unknown map";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::UnknownName);
        EXPECT_THAT(error.what(), ::testing::HasSubstr("'jet'"));
        EXPECT_THAT(error.what(), ::testing::HasSubstr("ansys_rainbow"));
    }
}

}  // namespace
}  // namespace feelem
