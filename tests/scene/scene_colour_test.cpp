// SPDX-License-Identifier: Apache-2.0
// Texture coordinates, palettes and what moves.
#include "scene/legend.hpp"
#include "scene/sample_scenes.hpp"
#include "scene/scene_colour.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_geometry.hpp"
#include "scene/scene_read.hpp"
#include "support/paths.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace feelem::test {
namespace {

using ::testing::ElementsAre;

constexpr double kInset = 1.0 / 32768;

TEST(Texcoord, lies_in_the_palette_for_values_in_the_range) {
    const ValueRange range{100, 200, Scale::Linear};
    EXPECT_THAT(texcoord_of(100, range), ElementsAre(static_cast<float>(1.0 / 16 + kInset), 0.0F));
    EXPECT_THAT(texcoord_of(150, range), ElementsAre(static_cast<float>(0.5 + kInset), 0.0F));
    EXPECT_THAT(texcoord_of(200, range), ElementsAre(static_cast<float>(15.0 / 16 - kInset), 0.0F));
}

TEST(Texcoord, goes_on_beyond_the_range_so_that_its_border_is_exact_inside_triangles) {
    const ValueRange range{100, 200, Scale::Linear};
    EXPECT_THAT(texcoord_of(0, range), ElementsAre(static_cast<float>(1.0 / 16 - 14.0 / 16), 0.0F));
    EXPECT_THAT(texcoord_of(300, range), ElementsAre(static_cast<float>(1.0 / 16 + 28.0 / 16), 0.0F));
    EXPECT_THAT(texcoord_of(-1e9, range), ElementsAre(-15.0F, 0.0F));
    EXPECT_THAT(texcoord_of(1e30, range), ElementsAre(16.0F, 0.0F));
}

TEST(Texcoord, a_value_hardly_outside_is_drawn_outside) {
    const ValueRange range{0.95233082771301272, 296.7571105957031, Scale::Linear};
    EXPECT_LT(texcoord_of(static_cast<double>(0.95233047F), range)[0], 1.0F / 16);
    EXPECT_GT(texcoord_of(296.7571105957032, range)[0], 15.0F / 16);
}

TEST(Texcoord, points_at_the_missing_colour_without_a_value) {
    const ValueRange range{0, 1, Scale::Linear};
    EXPECT_THAT(texcoord_of(NAN, range), ElementsAre(0.5F, 1.0F));
}

TEST(Texcoord, agrees_with_the_present_stage_on_every_scale) {
    for (const Scale scale : {Scale::Linear, Scale::Log, Scale::Signed, Scale::SymLog}) {
        for (const double lo : {0.5, 0.0, -7.0}) {
            const ValueRange range{lo, 12, scale};
            for (double value = -14; value < 14; value += 0.37) {
                const Normalised wanted = normalise(value, range);
                const double u = static_cast<double>(texcoord_of(value, range)[0]);
                if (wanted.below) {
                    EXPECT_LT(u, 1.0 / 16);
                } else if (wanted.above) {
                    EXPECT_GT(u, 15.0 / 16);
                } else {
                    EXPECT_NEAR((u - 1.0 / 16) * 16 / 14, wanted.position, 1e-4) << value;
                }
            }
        }
    }
}

TEST(Texcoord, a_value_of_the_legend_is_where_the_legend_says) {
    for (const Scale scale : {Scale::Linear, Scale::Log, Scale::Signed, Scale::SymLog}) {
        const ValueRange range{0.5, 12, scale};
        for (const double t : {0.0, 0.25, 0.5, 1.0})
            EXPECT_NEAR(normalise(value_at(t, range), range).position, t, 1e-12);
    }
}

TEST(Palette, has_below_palette_above_and_missing_where_the_coordinates_point) {
    ColourEffect effect;
    for (const int bands : {0, 9, 10}) {
        effect.bands = bands;
        const Picture picture = palette_picture(effect);
        ASSERT_EQ(picture.height, 64);
        ASSERT_EQ(picture.width, bands == 10 ? 80 : bands == 9 ? 144 : 1024);
        const ValueRange range{-3, 5, Scale::Linear};
        for (double value = -4; value < 6; value += 0.0511) {
            const double u = std::clamp(static_cast<double>(texcoord_of(value, range)[0]), 0.0, 1.0);
            const int x = std::min(static_cast<int>(u * picture.width), picture.width - 1);
            const Rgb wanted = colour_of(value, range, effect), found = picture.at(x, 0);
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], bands == 0 ? 1 : 0) << value;
        }
        EXPECT_EQ(picture.at(picture.width / 2, 63), effect.missing);
        EXPECT_EQ(picture.at(0, 1), effect.missing);
    }
}

TEST(Legend, shows_the_palette_beside_its_numbers) {
    ColourEffect effect;
    effect.bands = 9;
    const LegendText text{
        "von Mises stress (Größe)", "von_mises", "N/mm²", "step 1.1  t = 0.25 s", "x50", true};
    const Picture picture = legend_picture(text, {-12.5, 250, Scale::Linear}, effect);
    write_file(scratch_folder("pictures") + "/legend.png", png_bytes(picture));

    for (int y = 0; y < kBarHeight; ++y) {
        const double t = 1 - (y + 0.5) / kBarHeight;
        EXPECT_EQ(picture.at(kBarLeft + kBarWidth / 2, kBarTop + y), palette_colour(t, effect));
    }
}

TEST(Matrix, turns_the_up_axis_up_and_keeps_right_handed) {
    for (const char up : {'x', 'y', 'z'}) {
        const std::array<double, 16> m = model_matrix(up, 0.001);
        const std::size_t axis = static_cast<std::size_t>(up - 'x');
        EXPECT_THAT(std::span(m).subspan(4 * axis, 3), ElementsAre(0, 0.001, 0));
        const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) +
                                   m[8] * (m[1] * m[6] - m[2] * m[5]);
        EXPECT_NEAR(determinant, 1e-9, 1e-20);
    }
    EXPECT_THAT(
        model_matrix('z', 0.001), ElementsAre(0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1)
    );
}

TEST(Deformation, is_the_displacement_times_the_factor) {
    const auto sample = brick_sample(2, 1, 1);
    const SceneFile file(write_sample(*sample, "scene_deformed"));

    const std::vector<float> deltas = file.floats(file.find("p0/deformation/1"), 3);
    const std::vector<float>& displacement = sample->fields[1][0].values;
    ASSERT_EQ(deltas.size(), displacement.size());
    for (std::size_t i = 0; i < deltas.size(); ++i)
        EXPECT_EQ(deltas[i], static_cast<float>(50 * static_cast<double>(displacement[i])));
}

/// Value of a cubic spline with the tangents of the file.
double spline(double t0, double t1, std::span<const float> key0, std::span<const float> key1, double t) {
    const double s = (t - t0) / (t1 - t0), d = t1 - t0;
    const double v0 = key0[1], b0 = key0[2], v1 = key1[1], a1 = key1[0];
    return (2 * s * s * s - 3 * s * s + 1) * v0 + d * (s * s * s - 2 * s * s + s) * b0 +
           (-2 * s * s * s + 3 * s * s) * v1 + d * (s * s * s - s * s) * a1;
}

TEST(Deformation, swings_like_a_cosine) {
    const SceneFile file(write_sample(*brick_sample(1, 1, 1), "scene_swings"));
    const std::vector<float> times = file.floats(file.find("animation/times"), 1);
    const std::vector<float> weights = file.floats(file.find("animation/weights"), 1);
    ASSERT_EQ(times.size(), 9u);
    ASSERT_EQ(weights.size(), 27u);
    EXPECT_EQ(times.back(), 4.0F);

    for (std::size_t key = 0; key + 1 < times.size(); ++key) {
        const auto at = [&](std::size_t k) { return std::span(weights).subspan(3 * k, 3); };
        for (double s = 0; s <= 1; s += 0.1) {
            const double t = times[key] + s * (times[key + 1] - times[key]);
            const double wanted = (1 - std::cos(2 * std::numbers::pi * t / 4)) / 2;
            EXPECT_NEAR(spline(times[key], times[key + 1], at(key), at(key + 1), t), wanted, 1e-3);
        }
    }
}

TEST(Deformation, of_a_complex_mode_turns_through_real_and_imaginary_part) {
    auto sample = brick_sample(1, 1, 1);
    sample->contents.steps[0].kind = StepKind::Mode;
    sample->contents.steps[0].value = 12.5;
    SceneContents& contents = sample->contents;
    contents.results[1].id = "displacement_re";
    contents.results[1].complex = Complex::Real;
    add_result(
        *sample,
        {"displacement_im", Shape::Vector, {"x", "y", "z"}, "mm"},
        [](std::int64_t id, std::size_t, std::size_t c) { return float(id) * 0.01F + float(c); }
    );
    contents.results.back().quantity = "displacement";
    contents.results.back().complex = Complex::Imaginary;
    const SceneFile file(write_sample(*sample, "scene_mode"));

    const std::vector<float> weights = file.floats(file.find("animation/weights"), 1);
    ASSERT_EQ(weights.size(), 17u * 3 * 2);
    for (std::size_t key = 0; key < 17; ++key) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(key) / 16;
        EXPECT_NEAR(weights[key * 6 + 2], std::cos(angle), 1e-6);
        EXPECT_NEAR(weights[key * 6 + 3], -std::sin(angle), 1e-6);
    }
    EXPECT_EQ(
        file.floats(file.find("p0/deformation/1/im"), 3).size(), sample->fields.back()[0].values.size()
    );
}

TEST(Edges, stand_a_little_outside_the_surface) {
    const auto sample = brick_sample(2, 2, 2);
    const SceneFile file(write_sample(*sample, "scene_edges"));

    const std::vector<float> positions = file.floats(file.find("p0/edges/POSITION"), 3);
    const double offset = 0.0005 * std::sqrt(12.0);
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        int outside = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = static_cast<double>(positions[i + axis]);
            outside += std::abs(x + offset) < 1e-6 || std::abs(x - 2 - offset) < 1e-6 ? 1 : 0;
        }
        EXPECT_EQ(outside, 1);
    }
}

}  // namespace
}  // namespace feelem::test
