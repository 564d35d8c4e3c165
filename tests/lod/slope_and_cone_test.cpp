// SPDX-License-Identifier: Apache-2.0
// A corrugated sheet whose bound of the distance is far too wide: only the limit of the slope and the cone of
// the normals keep places from being taken for others.
#include "lod_surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace feelem {
namespace {

using test::LodModel;

constexpr std::uint32_t kSide = 120;

/// Waves of height 0.04 along x, `value` over (x, y).
template <class Value>
LodModel corrugated(double waves, const Value& value) {
    LodModel model;
    model.fields.resize(1);
    for (std::uint32_t j = 0; j <= kSide; ++j) {
        for (std::uint32_t i = 0; i <= kSide; ++i) {
            const double x = static_cast<double>(i) / kSide, y = static_cast<double>(j) / kSide;
            model.positions.push_back({x, y, 0.04 * std::sin(2 * std::numbers::pi * waves * x)});
            model.fields[0].push_back(static_cast<float>(value(x, y)));
        }
    }
    for (std::uint32_t j = 0; j < kSide; ++j) {
        for (std::uint32_t i = 0; i < kSide; ++i) {
            const std::uint32_t a = j * (kSide + 1) + i, d = a + kSide + 1;
            model.triangles.push_back({VertexIndex{a}, VertexIndex{a + 1}, VertexIndex{d + 1}});
            model.triangles.push_back({VertexIndex{a}, VertexIndex{d + 1}, VertexIndex{d}});
        }
    }
    return model;
}

Point3 normal_of(const LodModel& model, const std::array<VertexIndex, 3>& t) {
    const Point3 &p = model.positions[raw(t[0])], &q = model.positions[raw(t[1])],
                 &r = model.positions[raw(t[2])];
    const Point3 a{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, b{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double cosine(const Point3& a, const Point3& b) {
    const auto inner = [](const Point3& u, const Point3& v) {
        return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    };
    return inner(a, b) / std::sqrt(inner(a, a) * inner(b, b));
}

/// Removed vertices whose triangle is turned more than 45 degrees (and the rounding) from their own mean
/// normal.
std::size_t turned_away(const LodModel& model, const LodLevel& level) {
    std::vector<Point3> normals(model.positions.size(), Point3{});
    for (const auto& t : model.triangles) {
        const Point3 n = normal_of(model, t);
        for (const VertexIndex v : t) {
            for (std::size_t axis = 0; axis < 3; ++axis) normals[raw(v)][axis] += n[axis];
        }
    }
    std::size_t turned = 0;
    for (std::size_t v = 0; v < normals.size(); ++v) {
        if (std::ranges::binary_search(level.vertices, VertexIndex{static_cast<std::uint32_t>(v)})) continue;
        const double agrees = cosine(normals[v], normal_of(model, level.triangles[level.witness[v]]));
        turned += agrees < std::sqrt(0.5) - 1e-4 ? 1U : 0U;
    }
    return turned;
}

std::uint64_t over(const LodModel& model, double share, const LodOptions& options) {
    const auto fields = test::bounded(model, share);
    const LodLevel level = simplify(model.surface(), fields, options).levels[0];
    EXPECT_LE(level.certificate.worst, 1);
    return check_level(model.surface(), fields, level.triangles, level.certificate.distance_bound)
        .fields[0]
        .over;
}

TEST(SlopeLimit, keeps_the_closest_place_from_showing_another_value) {
    const auto spot = [](double x, double y) {
        return std::exp(-((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)) / 0.003);
    };
    LodOptions options, without;
    options.distance = without.distance = 0.2;
    without.slip = 1e6;
    for (const auto& [waves, share] : {std::pair{5.0, 0.1}, {8.0, 0.02}}) {
        const LodModel model = corrugated(waves, spot);
        EXPECT_EQ(over(model, share, options), 0U) << waves << " waves";
        // The certificate alone holds without it too: its witnesses may be far away.
        EXPECT_GT(over(model, share, without), 0U) << waves << " waves";
    }
}

TEST(NormalCone, keeps_the_flanks_of_waves_that_the_distance_would_flatten) {
    const LodModel model = corrugated(5, [](double x, double) { return x; });
    const auto fields = test::bounded(model, 0.1);
    LodOptions options, without;
    options.distance = without.distance = 0.2;
    // The limit of the slope would keep some of them.
    options.slip = without.slip = 1e6;
    without.cone_angle = 180;

    const LodResult kept = simplify(model.surface(), fields, options);

    test::expect_sound(model.surface(), fields, kept, options);
    EXPECT_EQ(turned_away(model, kept.levels[0]), 0U);
    EXPECT_GT(turned_away(model, simplify(model.surface(), fields, without).levels[0]), 1000U);
}

}  // namespace
}  // namespace feelem
