// SPDX-License-Identifier: Apache-2.0
// Levels of surfaces that are well made: how many triangles they keep, and that nothing they say is untrue.
#include "base/parallel.hpp"
#include "lod_surfaces.hpp"

#include "feelem/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace feelem {
namespace {

using test::bounded;
using test::expect_sound;
using test::LodModel;

bool has_vertex(const LodLevel& level, std::uint32_t v) {
    return std::ranges::binary_search(level.vertices, VertexIndex{v});
}

TEST(Simplify, keeps_every_value_of_a_sheet_with_hot_spots_within_its_bound) {
    const LodModel model = test::wavy_sheet(120, 0.4);
    const auto fields = bounded(model, 0.01);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    EXPECT_LT(result.levels[0].triangles.size(), model.triangles.size() / 6);
    EXPECT_FALSE(result.levels[0].reached);
    EXPECT_EQ(result.levels[0].certificate.samples, model.positions.size() + model.triangles.size());
}

TEST(Simplify, keeps_every_extreme_above_the_threshold_and_the_global_ones) {
    const LodModel model = test::wavy_sheet(150);
    const auto fields = bounded(model, 0.01);

    const LodLevel level = simplify(model.surface(), fields, {}).levels[0];

    std::size_t extremes = 0;
    for (const float sign : {1.0F, -1.0F}) {
        for (const std::uint32_t v :
             test::lasting_extremes(model.fields[0], model.triangles, 2 * fields[0].bound, sign)) {
            EXPECT_TRUE(has_vertex(level, v)) << "vertex " << v;
            ++extremes;
        }
    }
    EXPECT_GT(extremes, 10U);
    const auto [low, high] = std::ranges::minmax_element(model.fields[0]);
    EXPECT_TRUE(has_vertex(level, static_cast<std::uint32_t>(low - model.fields[0].begin())));
    const auto first_high = std::ranges::max_element(model.fields[0]);
    EXPECT_TRUE(has_vertex(level, static_cast<std::uint32_t>(first_high - model.fields[0].begin())));
    EXPECT_EQ(*first_high, *high);
}

TEST(Simplify, gives_levels_of_one_run_each_with_its_own_bound) {
    const LodModel model = test::wavy_sheet(100);
    const auto fields = bounded(model, 0.02);
    LodOptions options;
    options.targets = {{0, 0.125}, {0, 0.25}, {0, 0.5}, {0, 1}};

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    for (std::size_t i = 1; i < result.levels.size(); ++i)
        EXPECT_LT(result.levels[i].triangles.size(), result.levels[i - 1].triangles.size());
}

TEST(Simplify, stops_at_the_count_and_says_which_bound_that_took) {
    const LodModel model = test::wavy_sheet(100);
    const auto fields = bounded(model, 0.02);
    LodOptions options;
    options.targets = {{4000, 1}, {400, 1}, {4, 1}};

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    EXPECT_TRUE(result.levels[0].reached);
    EXPECT_LE(result.levels[0].triangles.size(), 4000U);
    EXPECT_GE(result.levels[0].triangles.size(), 3998U);
    EXPECT_LT(result.levels[0].certificate.bound, 1);
    EXPECT_FALSE(result.levels[2].reached);
    EXPECT_EQ(result.levels[2].certificate.bound, 1);
}

TEST(Simplify, bounds_the_middle_of_triangles_too) {
    LodModel model = test::wavy_sheet(60);
    // Every second vertex of a checkerboard is high: the vertices alone could be met by other diagonals.
    for (std::size_t v = 0; v < model.fields[0].size(); ++v)
        model.fields[0][v] = static_cast<float>((v % 61) % 2) * 0.01F + static_cast<float>(v / 61) * 0.001F;
    const auto fields = bounded(model, 0.05);
    LodOptions options;

    const LodLevel level = simplify(model.surface(), fields, options).levels[0];

    EXPECT_EQ(level.certificate.samples, model.positions.size() + model.triangles.size());
    EXPECT_LE(level.certificate.worst, 1);
    options.centroids = false;
    EXPECT_EQ(
        simplify(model.surface(), fields, options).levels[0].certificate.samples, model.positions.size()
    );
}

TEST(Simplify, keeps_front_and_back_of_a_thin_plate_apart) {
    const LodModel model = test::thin_plate(80, 0.01);
    const auto fields = bounded(model, 0.01);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    EXPECT_LT(result.levels[0].triangles.size(), model.triangles.size() / 5);
    EXPECT_EQ(result.report.non_manifold, 0U);
}

TEST(Simplify, keeps_creases_of_a_curved_closed_body) {
    for (const bool split : {false, true}) {
        SCOPED_TRACE(split ? "split" : "shared");
        const LodModel model = test::capped_tube(96, 120, split);
        const auto fields = bounded(model, 0.01);
        LodOptions options;
        options.targets = {{0, 0.2}, {0, 1}};

        const LodResult result = simplify(model.surface(), fields, options);

        expect_sound(model.surface(), fields, result, options);
        EXPECT_GE(result.report.creases, 190U);
        EXPECT_LT(result.levels[1].triangles.size(), model.triangles.size() / 3);
        EXPECT_GT(result.levels[1].certificate.max_border_distance, 0);
        // Every triangle is of the wall or of one cap: none cuts the right angle.
        for (const auto& t : result.levels[1].triangles) {
            double low = 9, high = -9, least = 9;
            for (const VertexIndex v : t) {
                const Point3& p = model.positions[raw(v)];
                low = std::min(low, p[2]);
                high = std::max(high, p[2]);
                least = std::min(least, std::hypot(p[0], p[1]));
            }
            EXPECT_TRUE(high == low || least > 0.99);
        }
    }
}

/// Distance of p from the nearest border edge of the triangles.
double from_border(
    const Point3& p, const LodModel& model, std::span<const std::array<VertexIndex, 3>> triangles
) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = raw(t[k]), b = raw(t[(k + 1) % 3]);
            ++uses[{std::min(a, b), std::max(a, b)}];
        }
    }
    double least = 1e9;
    for (const auto& [edge, count] : uses) {
        if (count != 1) continue;
        const Point3 &a = model.positions[edge.first], &b = model.positions[edge.second];
        const double dx = b[0] - a[0], dy = b[1] - a[1];
        const double s =
            std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        least = std::min(least, std::hypot(a[0] + s * dx - p[0], a[1] + s * dy - p[1]));
    }
    return least;
}

TEST(Simplify, does_not_close_a_hole) {
    // Every vertex of the rim lies inside the triangle that a chord would make: only the line itself tells.
    const LodModel model = test::flat_ring(200, 20);
    const auto fields = bounded(model, 0.01);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    EXPECT_LT(result.levels[0].triangles.size(), 400U);
    for (std::uint32_t i = 0; i < 200; i += 7) {
        EXPECT_LE(
            from_border(model.positions[i], model, result.levels[0].triangles),
            result.levels[0].certificate.distance_bound
        );
    }
}

TEST(Simplify, leaves_no_crack_between_parts_and_keeps_the_jump_between_them) {
    const LodModel model = test::two_parts(60);
    const auto fields = bounded(model, 0.001);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    const LodLevel& level = result.levels[0];
    EXPECT_LT(level.triangles.size(), model.triangles.size() / 4);
    std::vector<std::uint32_t> sides[2];
    for (const VertexIndex v : level.vertices) {
        if (model.positions[raw(v)][0] == 0.5) sides[model.parts[raw(v)]].push_back(model.places[raw(v)]);
    }
    std::ranges::sort(sides[0]);
    std::ranges::sort(sides[1]);
    EXPECT_EQ(sides[0], sides[1]);
    EXPECT_LT(sides[0].size(), 40U);
    for (const auto& t : level.triangles) {
        EXPECT_EQ(model.parts[raw(t[0])], model.parts[raw(t[1])]);
        EXPECT_EQ(model.parts[raw(t[0])], model.parts[raw(t[2])]);
    }
}

TEST(Simplify, gives_the_same_bytes_whatever_the_number_of_threads) {
    const LodModel model = test::wavy_sheet(120, 0.4);
    const auto fields = bounded(model, 0.005);
    std::vector<LodResult> results;
    for (const unsigned threads : {1U, 2U, 3U}) {
        set_thread_count(threads);
        results.push_back(simplify(model.surface(), fields, {}));
    }
    set_thread_count(0);
    for (const LodResult& other : results) {
        EXPECT_EQ(results[0].levels[0].triangles, other.levels[0].triangles);
        EXPECT_EQ(results[0].levels[0].witness, other.levels[0].witness);
        EXPECT_EQ(results[0].levels[0].certificate.worst, other.levels[0].certificate.worst);
        EXPECT_EQ(results[0].levels[0].certificate.fields[0].rms, other.levels[0].certificate.fields[0].rms);
    }
}

TEST(Simplify, bounds_every_field_and_step_that_it_serves) {
    LodModel model = test::wavy_sheet(80);
    // A spot that travels: 90 steps, more than fit one mask of missing values.
    model.fields.clear();
    for (int step = 0; step < 90; ++step) {
        std::vector<float> values;
        for (const Point3& p : model.positions) {
            const double dx = p[0] - 0.2 - 0.006 * step, dy = p[1] - 0.5;
            values.push_back(static_cast<float>(std::exp(-(dx * dx + dy * dy) / 0.01)));
        }
        model.fields.push_back(std::move(values));
    }
    const auto fields = bounded(model, 0.02);
    const LodOptions options;

    const LodResult result = simplify(model.surface(), fields, options);

    expect_sound(model.surface(), fields, result, options);
    EXPECT_LT(result.levels[0].triangles.size(), model.triangles.size() / 3);
}

TEST(Simplify, says_the_same_of_a_field_afterwards_as_while_it_was_made) {
    const LodModel model = test::capped_tube(96, 60, false);
    const auto fields = bounded(model, 0.02);

    const LodLevel level = simplify(model.surface(), fields, {}).levels[0];
    const std::vector<LodFieldError> later = measure_level(model.surface(), fields, level);

    ASSERT_FALSE(level.second_witness.empty());
    EXPECT_DOUBLE_EQ(later[0].max, level.certificate.fields[0].max);
    EXPECT_NEAR(later[0].rms, level.certificate.fields[0].rms, 0.05 * later[0].rms);
}

TEST(Simplify, keeps_what_it_is_told_to_keep) {
    const LodModel model = test::wavy_sheet(40);
    LodOptions options;
    for (std::uint32_t v = 100; v < 1600; v += 37) options.keep.push_back(VertexIndex{v});

    const LodLevel level = simplify(model.surface(), bounded(model, 0.2), options).levels[0];

    for (const VertexIndex v : options.keep) EXPECT_TRUE(has_vertex(level, raw(v))) << raw(v);
    EXPECT_LT(level.vertices.size(), 700U);
}

TEST(Simplify, extremes_to_keep_are_those_that_it_keeps_by_itself) {
    const LodModel model = test::wavy_sheet(150);
    const auto fields = bounded(model, 0.01);

    const std::vector<VertexIndex> found = lasting_extremes(model.surface(), fields);

    std::vector<std::uint32_t> wanted;
    for (const float sign : {1.0F, -1.0F}) {
        for (const std::uint32_t v :
             test::lasting_extremes(model.fields[0], model.triangles, 2 * fields[0].bound, sign))
            wanted.push_back(v);
    }
    std::ranges::sort(wanted);
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(raw(found[i]), wanted[i]);
}

Code code_of(const LodModel& model, std::span<const LodField> fields, const LodOptions& options) {
    try {
        simplify(model.surface(), fields, options);
    } catch (const Error& error) {
        return error.code();
    }
    return Code::BadScene;
}

TEST(Simplify, refuses_bounds_that_mean_nothing) {
    const LodModel model = test::wavy_sheet(4);
    const std::vector<float> few(3);
    LodOptions options;

    EXPECT_EQ(code_of(model, std::vector<LodField>{{model.fields[0], 0}}, options), Code::BadOption);
    EXPECT_EQ(
        code_of(model, std::vector<LodField>{{model.fields[0], std::nan("")}}, options), Code::BadOption
    );
    EXPECT_EQ(code_of(model, std::vector<LodField>{{few, 1}}, options), Code::BadOption);
    EXPECT_EQ(code_of(model, std::vector<LodField>{{model.fields[0], 1e-9}}, options), Code::BadOption);
    options.targets = {{10, 1}, {100, 1}};
    EXPECT_EQ(code_of(model, {}, options), Code::BadOption);
}

}  // namespace
}  // namespace feelem
