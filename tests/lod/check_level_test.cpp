// SPDX-License-Identifier: Apache-2.0
// The checker finds what is wrong with levels that are not sound.
#include "lod_surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace feelem {
namespace {

using test::LodModel;

VertexIndex at(std::uint32_t i) {
    return VertexIndex{i};
}

/// A square of four triangles round its middle, which is 0.25 high and has the value 8.
LodModel pyramid() {
    LodModel model;
    model.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0.25}};
    model.fields = {{0, 0, 0, 0, 8}};
    model.triangles = {
        {at(0), at(1), at(4)}, {at(1), at(2), at(4)}, {at(2), at(3), at(4)}, {at(3), at(0), at(4)}};
    return model;
}

TEST(CheckLevel, surface_itself_has_no_error) {
    const LodModel model = pyramid();
    const std::vector<LodField> fields{{model.fields[0], 1}};

    const LodCheck check = check_level(model.surface(), fields, model.triangles, 0);

    EXPECT_EQ(check.vertices, 5U);
    EXPECT_EQ(check.fields[0].max, 0);
    EXPECT_EQ(check.max_distance, 0);
    EXPECT_EQ(check.fields[0].over, 0U);
}

TEST(CheckLevel, lost_peak_is_measured_in_value_and_distance) {
    const LodModel model = pyramid();
    const std::vector<LodField> fields{{model.fields[0], 1}};
    const std::vector<std::array<VertexIndex, 3>> level{{at(0), at(1), at(2)}, {at(0), at(2), at(3)}};

    const LodCheck check = check_level(model.surface(), fields, level, 0);

    EXPECT_EQ(check.fields[0].max, 8);
    EXPECT_EQ(raw(check.fields[0].worst), 4U);
    EXPECT_EQ(check.fields[0].over, 1U);
    EXPECT_DOUBLE_EQ(check.fields[0].rms, 8 / std::sqrt(5.0));
    EXPECT_DOUBLE_EQ(check.max_distance, 0.25);
}

TEST(CheckLevel, triangle_that_was_turned_over_shows_nothing) {
    const LodModel model = pyramid();
    const std::vector<LodField> fields{{model.fields[0], 1}};
    const std::vector<std::array<VertexIndex, 3>> level{{at(0), at(2), at(1)}, {at(0), at(3), at(2)}};

    EXPECT_EQ(check_level(model.surface(), fields, level, 0).without_place, 5U);
}

TEST(CheckLevel, triangle_of_another_part_shows_nothing) {
    LodModel model = pyramid();
    const std::vector<LodField> fields{{model.fields[0], 1}};
    model.parts = {0, 0, 0, 0, 1};
    const std::vector<std::array<VertexIndex, 3>> level{{at(0), at(1), at(2)}, {at(0), at(2), at(3)}};

    EXPECT_EQ(check_level(model.surface(), fields, level, 0).without_place, 1U);
}

TEST(CheckLevel, tells_what_was_invented_and_what_was_lost) {
    LodModel model = pyramid();
    const float missing = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::array<VertexIndex, 3>> level{{at(0), at(1), at(2)}, {at(0), at(2), at(3)}};

    model.fields[0] = {0, 0, 0, 0, missing};
    EXPECT_EQ(
        check_level(model.surface(), std::vector<LodField>{{model.fields[0], 1}}, level, 0).invented, 5U
    );
    model.fields[0] = {missing, 0, 0, 0, 1};
    EXPECT_EQ(check_level(model.surface(), std::vector<LodField>{{model.fields[0], 1}}, level, 0).lost, 4U);
}

}  // namespace
}  // namespace feelem
