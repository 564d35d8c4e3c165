// SPDX-License-Identifier: Apache-2.0
// Surfaces that a simplifier would rather not see.
#include "lod_surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace feelem {
namespace {

using test::bounded;
using test::expect_sound;
using test::LodModel;

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

bool has(const LodLevel& level, std::uint32_t v) {
    return std::ranges::binary_search(level.vertices, VertexIndex{v});
}

TEST(OddSurface, edge_of_three_sheets_stays_as_it_is) {
    const LodModel model = test::three_wings(20);
    const auto fields = bounded(model, 0.05);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    EXPECT_EQ(result.report.non_manifold, 21U);
    EXPECT_LT(result.levels[0].triangles.size(), model.triangles.size() / 4);
    for (std::uint32_t j = 0; j <= 20; ++j) EXPECT_TRUE(has(result.levels[0], j * 21));
}

TEST(OddSurface, point_where_two_fans_touch_stays) {
    LodModel model = test::wavy_sheet(20);
    const std::size_t count = model.positions.size();
    const LodModel other = model;
    // A second sheet, mirrored through the last corner of the first, joined in that corner only.
    const Point3 corner = model.positions.back();
    for (std::size_t v = 0; v < count; ++v) {
        const Point3& p = other.positions[v];
        model.positions.push_back({2 * corner[0] - p[0], 2 * corner[1] - p[1], 2 * corner[2] - p[2]});
        model.fields[0].push_back(other.fields[0][v]);
    }
    const auto moved = [&](VertexIndex v) {
        return raw(v) == count - 1 ? v : VertexIndex{raw(v) + static_cast<std::uint32_t>(count)};
    };
    for (const auto& t : other.triangles) model.triangles.push_back({moved(t[0]), moved(t[1]), moved(t[2])});
    const auto fields = bounded(model, 0.1);
    LodOptions options;
    options.distance = 0.02;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    EXPECT_EQ(result.report.non_manifold, 1U);
    EXPECT_TRUE(has(result.levels[0], static_cast<std::uint32_t>(count - 1)));
    EXPECT_LT(result.levels[0].triangles.size(), model.triangles.size() / 2);
}

TEST(OddSurface, noise_above_the_bound_has_a_floor_that_is_told) {
    LodModel model = test::wavy_sheet(40);
    std::uint32_t state = 1;
    for (float& f : model.fields[0]) {
        state = state * 1664525U + 1013904223U;
        f = static_cast<float>(state >> 8U) / static_cast<float>(1U << 24U);
    }
    const auto fields = bounded(model, 0.01);
    LodOptions options;
    options.targets = {{100, 1}};

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    EXPECT_FALSE(result.levels[0].reached);
    EXPECT_GT(result.levels[0].triangles.size(), model.triangles.size() / 2);
}

TEST(OddSurface, missing_values_are_neither_invented_nor_spread) {
    LodModel model = test::wavy_sheet(60);
    model.fields.push_back(model.fields[0]);
    for (std::uint32_t j = 0; j <= 60; ++j) {
        for (std::uint32_t i = 0; i <= 60; ++i) {
            const std::uint32_t v = j * 61 + i;
            // Half the sheet without the first field, a spot without the second, one lonely vertex.
            if (i < 25) model.fields[0][v] = kMissing;
            if (i > 35 && i < 50 && j > 20 && j < 40) model.fields[1][v] = kMissing;
            if (i == 55 && j == 5) model.fields[0][v] = kMissing;
        }
    }
    const auto fields = bounded(model, 0.02);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    const LodLevel& level = result.levels[0];
    EXPECT_LT(level.triangles.size(), model.triangles.size() / 3);
    EXPECT_GT(level.certificate.missing, 25U * 61U);
    EXPECT_TRUE(has(level, 5 * 61 + 55));
    double area = 0;
    for (const auto& t : level.triangles) {
        if (std::isfinite(
                model.fields[0][raw(t[0])] + model.fields[0][raw(t[1])] + model.fields[0][raw(t[2])]
            ))
            continue;
        const Point3 &a = model.positions[raw(t[0])], &b = model.positions[raw(t[1])],
                     &c = model.positions[raw(t[2])];
        area += 0.5 * std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    }
    // 25 columns of quads and the six triangles round the lonely vertex.
    EXPECT_NEAR(area, 25.0 / 60 + 3.0 / 3600, 1e-6);
}

TEST(OddSurface, steps_that_miss_the_same_values_share_one_hole) {
    LodModel model = test::wavy_sheet(30);
    for (std::size_t v = 0; v < 200; ++v) model.fields[0][v] = kMissing;
    for (int k = 1; k < 70; ++k) model.fields.push_back(model.fields[0]);
    const auto fields = bounded(model, 0.05);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    // The hole itself is flat country.
    EXPECT_LT(result.levels[0].triangles.size(), model.triangles.size() * 2 / 3);
}

TEST(OddSurface, more_kinds_of_missing_than_can_be_told_apart_all_stay) {
    LodModel model = test::wavy_sheet(30);
    for (int k = 1; k < 70; ++k) model.fields.push_back(model.fields[0]);
    for (std::size_t k = 0; k < 70; ++k) {
        for (std::size_t v = 3 * k; v < 3 * k + 2; ++v) model.fields[k][v] = kMissing;
    }
    const auto fields = bounded(model, 0.05);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    // The checker tells 64 fields apart at once.
    for (const auto some : {std::span(fields).first(35), std::span(fields).last(35)}) {
        const LodCheck check = check_level(
            model.surface(), some, result.levels[0].triangles, result.levels[0].certificate.distance_bound
        );
        EXPECT_EQ(check.invented + check.lost + check.without_place, 0U);
        for (const LodCheck::Field& field : check.fields) EXPECT_LE(field.max, fields[0].bound * (1 + 1e-9));
    }
    for (std::uint32_t v = 0; v < 209; ++v) EXPECT_TRUE(has(result.levels[0], v) || v % 3 == 2) << v;
    EXPECT_LT(result.levels[0].triangles.size(), model.triangles.size());
}

TEST(OddSurface, triangles_with_vertices_of_their_own_all_stay) {
    // As elemental results are drawn: each triangle has its own value, flat.
    const LodModel smooth = test::wavy_sheet(10);
    LodModel model;
    model.fields.resize(1);
    for (const auto& t : smooth.triangles) {
        for (const VertexIndex v : t) {
            model.positions.push_back(smooth.positions[raw(v)]);
            model.places.push_back(raw(v));
            model.fields[0].push_back(static_cast<float>(model.triangles.size() % 7));
        }
        const auto n = static_cast<std::uint32_t>(model.positions.size());
        model.triangles.push_back({VertexIndex{n - 3}, VertexIndex{n - 2}, VertexIndex{n - 1}});
    }
    const auto fields = bounded(model, 0.01);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    EXPECT_GE(result.levels[0].triangles.size(), model.triangles.size() - 80);
    EXPECT_FALSE(result.levels[0].reached);
}

TEST(OddSurface, closed_tetrahedron_and_one_triangle_stay) {
    LodModel model;
    model.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    model.fields = {{0, 1, 2, 3}};
    const auto v = [](std::uint32_t i) { return VertexIndex{i}; };
    model.triangles = {{v(0), v(2), v(1)}, {v(0), v(1), v(3)}, {v(1), v(2), v(3)}, {v(2), v(0), v(3)}};
    LodOptions options;
    options.distance = 100;
    std::vector<LodField> fields{{model.fields[0], 100}};

    EXPECT_EQ(simplify(model.surface(), fields, options).levels[0].triangles.size(), 4U);
    model.triangles.resize(1);
    EXPECT_EQ(simplify(model.surface(), fields, options).levels[0].triangles, model.triangles);
}

TEST(OddSurface, almost_flat_tetrahedron_is_not_folded_onto_itself) {
    LodModel model;
    model.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}, {0.5, 0.3, 1e-4}};
    model.fields = {{0, 0, 0, 0}};
    const auto v = [](std::uint32_t i) { return VertexIndex{i}; };
    model.triangles = {{v(0), v(2), v(1)}, {v(0), v(1), v(3)}, {v(1), v(2), v(3)}, {v(2), v(0), v(3)}};
    const auto fields = bounded(model, 1);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    EXPECT_EQ(result.levels[0].triangles.size(), 4U);
}

TEST(OddSurface, nothing_at_all_gives_an_empty_level) {
    const LodModel model;
    const LodResult result = simplify(model.surface(), {}, {});

    ASSERT_EQ(result.levels.size(), 1U);
    EXPECT_TRUE(result.levels[0].triangles.empty());
    EXPECT_TRUE(result.levels[0].reached);
    EXPECT_EQ(result.levels[0].certificate.samples, 0U);
}

TEST(OddSurface, triangles_without_three_points_are_left_out_and_counted) {
    LodModel model = test::wavy_sheet(10);
    const auto before = model.triangles.size();
    model.triangles.insert(model.triangles.begin() + 5, {VertexIndex{3}, VertexIndex{3}, VertexIndex{4}});
    const auto fields = bounded(model, 0.2);
    LodOptions options;
    options.distance = 0.05;

    const LodResult result = simplify(model.surface(), fields, options);

    EXPECT_EQ(result.report.degenerate, 1U);
    EXPECT_LT(result.levels[0].triangles.size(), before);
    EXPECT_LE(result.levels[0].certificate.worst, 1);
    EXPECT_EQ(result.levels[0].certificate.samples, model.positions.size() + before);
}

TEST(OddSurface, places_that_are_not_numbers_are_survived) {
    LodModel model = test::wavy_sheet(10);
    model.positions[60][1] = std::nan("");
    model.positions[61][2] = std::numeric_limits<double>::infinity();
    const auto fields = bounded(model, 0.05);

    try {
        const LodResult result = simplify(model.surface(), fields, {});
        EXPECT_TRUE(has(result.levels[0], 60));
    } catch (const std::exception& error) {
        EXPECT_STRNE(error.what(), "");
    }
}

}  // namespace
}  // namespace feelem
