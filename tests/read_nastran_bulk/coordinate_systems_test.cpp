// SPDX-License-Identifier: Apache-2.0
// Chains of coordinate systems, the axes at a place, and their angles.
#include "derive/tensor.hpp"
#include "read/nastran/coordinate_systems.hpp"
#include "read/nodal_angles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace feelem {
namespace {

using nastran::CoordinateSystems;
using nastran::GridPlace;
using nastran::SystemCard;
using nastran::SystemKind;

const CoordinateSystems::FindGrid kNoGrids = [](std::int64_t) { return std::optional<GridPlace>(); };

SystemCard by_points(std::int64_t id, SystemKind kind, std::int64_t reference, Point3 a, Point3 b, Point3 c) {
    SystemCard card;
    card.id = id;
    card.kind = kind;
    card.reference = reference;
    card.points = {a, b, c};
    return card;
}

void expect_near(const Point3& found, const Point3& expected) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-14) << "coordinate " << i;
}

void expect_same_axes(const Matrix3& found, const Matrix3& expected) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(found[i][j], expected[i][j], 1e-12) << i << " " << j;
    }
}

TEST(NodalAngles, of_any_rotation_turn_back_into_it) {
    for (int a = -180; a <= 180; a += 30) {
        for (int b = -180; b <= 180; b += 30) {
            for (int c = -180; c <= 180; c += 45) {
                SCOPED_TRACE(testing::Message() << a << " " << b << " " << c);
                const Matrix3 axes = nodal_axes({a + 0.25, double(b), c - 0.5});
                expect_same_axes(nodal_axes(nodal_angles_of(axes)), axes);
            }
        }
    }
}

TEST(NodalAngles, of_the_global_axes_are_all_zero) {
    const NodalAngles none{};
    EXPECT_EQ(nodal_angles_of({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}), none);
}

TEST(NastranSystems, places_in_each_kind_come_out_in_the_basic_system) {
    CoordinateSystems systems;
    Diagnostics diagnostics;
    // Origin (1, 2, 3), z along x, x along y: then y is along z.
    for (const auto kind : {SystemKind::Rectangular, SystemKind::Cylindrical, SystemKind::Spherical}) {
        systems.add(by_points(1 + static_cast<int>(kind), kind, 0, {1, 2, 3}, {5, 2, 3}, {9, 4, 3}));
    }
    systems.resolve(kNoGrids, diagnostics);
    EXPECT_TRUE(diagnostics.entries().empty());
    expect_near(systems.to_basic(1, {10, 20, 30}), {31, 12, 23});
    expect_near(systems.to_basic(2, {10, 90, 30}), {31, 2, 13});
    expect_near(systems.to_basic(3, {10, 90, 0}), {1, 12, 3});
    expect_near(systems.to_basic(3, {10, 0, 0}), {11, 2, 3});
    expect_near(systems.to_basic(3, {10, 90, 90}), {1, 2, 13});
    expect_near(systems.to_basic(0, {7, 8, 9}), {7, 8, 9});
}

TEST(NastranSystems, chains_are_followed_whatever_their_order) {
    CoordinateSystems systems;
    Diagnostics diagnostics;
    // 1 stands in 2, which is cylindrical and stands in 3, which is moved by (0, 0, 100).
    systems.add(by_points(1, SystemKind::Rectangular, 2, {5, 90, 0}, {5, 90, 1}, {6, 90, 0}));
    systems.add(by_points(2, SystemKind::Cylindrical, 3, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    systems.add(by_points(3, SystemKind::Rectangular, 0, {0, 0, 100}, {0, 0, 101}, {1, 0, 100}));
    systems.resolve(kNoGrids, diagnostics);
    EXPECT_TRUE(diagnostics.entries().empty());
    expect_near(systems.to_basic(1, {1, 2, 3}), {-2, 6, 103});
}

TEST(NastranSystems, grids_may_hold_a_system_and_stand_in_another) {
    CoordinateSystems systems;
    Diagnostics diagnostics;
    SystemCard card;
    card.id = 7;
    card.by_grids = true;
    card.grids = {11, 12, 13};
    systems.add(card);
    systems.add(by_points(9, SystemKind::Cylindrical, 0, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    const auto find = [](std::int64_t id) -> std::optional<GridPlace> {
        if (id == 11) return GridPlace{9, {2, 90, 0}};
        if (id == 12) return GridPlace{0, {0, 2, 1}};
        return GridPlace{9, {3, 90, 0}};
    };
    systems.resolve(find, diagnostics);
    EXPECT_TRUE(diagnostics.entries().empty());
    expect_near(systems.to_basic(7, {1, 0, 0}), {0, 3, 0});
}

TEST(NastranSystems, loops_gaps_and_points_in_one_line_are_reported_each) {
    CoordinateSystems systems;
    Diagnostics diagnostics;
    systems.add(by_points(1, SystemKind::Rectangular, 2, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    systems.add(by_points(2, SystemKind::Rectangular, 1, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    systems.add(by_points(3, SystemKind::Rectangular, 3, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    systems.add(by_points(4, SystemKind::Rectangular, 99, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    systems.add(by_points(5, SystemKind::Rectangular, 0, {0, 0, 0}, {0, 0, 1}, {0, 0, 4}));
    systems.add(by_points(6, SystemKind::Rectangular, 0, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    systems.resolve(kNoGrids, diagnostics);
    EXPECT_EQ(diagnostics.count(Code::CoordinateSystem), 5U);
    EXPECT_EQ(diagnostics.entries().size(), 5U);
    for (int id = 1; id <= 5; ++id) {
        EXPECT_FALSE(systems.known(id)) << id;
        EXPECT_TRUE(std::isnan(systems.to_basic(id, {1, 2, 3})[0])) << id;
        EXPECT_EQ(systems.angles_at(id, {1, 2, 3}), NodalAngles{}) << id;
    }
    EXPECT_TRUE(systems.known(6));
}

TEST(NastranSystems, a_chain_of_many_systems_needs_no_deep_stack) {
    CoordinateSystems systems;
    Diagnostics diagnostics;
    constexpr int kMany = 100000;
    for (int i = 1; i <= kMany; ++i) {
        systems.add(
            by_points(i, SystemKind::Rectangular, i < kMany ? i + 1 : 0, {1, 0, 0}, {1, 0, 1}, {2, 0, 0})
        );
    }
    systems.resolve(kNoGrids, diagnostics);
    expect_near(systems.to_basic(1, {0, 0, 0}), {kMany, 0, 0});
}

TEST(NastranSystems, axes_turn_with_the_place_in_round_systems) {
    CoordinateSystems systems;
    Diagnostics diagnostics;
    systems.add(by_points(2, SystemKind::Cylindrical, 0, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    systems.add(by_points(3, SystemKind::Spherical, 0, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
    systems.resolve(kNoGrids, diagnostics);
    const double half = std::sqrt(0.5);
    // At 45 degrees: r outward, then round, then z.
    expect_same_axes(systems.axes_at(2, {1, 1, 5}), {{{half, -half, 0}, {half, half, 0}, {0, 0, 1}}});
    EXPECT_NEAR(systems.angles_at(2, {1, 1, 5})[0], 45, 1e-13);
    // r outward, then down the meridian, then round the pole.
    expect_same_axes(systems.axes_at(3, {1, 0, 1}), {{{half, half, 0}, {0, 0, 1}, {half, -half, 0}}});
    expect_same_axes(nodal_axes(systems.angles_at(3, {3, -4, 2})), systems.axes_at(3, {3, -4, 2}));
    // On the axis the angle is 0.
    expect_same_axes(systems.axes_at(2, {0, 0, 5}), {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    expect_same_axes(systems.axes_at(3, {0, 0, 0}), {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}});
}

}  // namespace
}  // namespace feelem
