// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include "feelem/pick.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace feelem {
namespace {

struct Triangles {
    std::vector<Vertex3> positions;
    std::vector<Triangle> triangles;
};

/// A wavy sheet over [0, n] x [0, n].
Triangles sheet(std::uint32_t n) {
    Triangles out;
    for (std::uint32_t y = 0; y <= n; ++y) {
        for (std::uint32_t x = 0; x <= n; ++x) {
            const float height = 0.5F * std::sin(0.7F * static_cast<float>(x) + 0.3F * static_cast<float>(y));
            out.positions.push_back({static_cast<float>(x), static_cast<float>(y), height});
        }
    }
    for (std::uint32_t y = 0; y < n; ++y) {
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 2, d = a + n + 1;
            out.triangles.push_back({a, b, c});
            out.triangles.push_back({a, c, d});
        }
    }
    return out;
}

/// Triangles anywhere, of any size; some without area.
Triangles soup(std::size_t count) {
    Triangles out;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(-10, 10), size(-1, 1);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vertex3 at{place(random), place(random), place(random)};
        for (std::uint32_t k = 0; k < 3; ++k) {
            const bool flat = i % 7 == 0;
            out.positions.push_back(
                {at[0] + size(random), at[1] + (flat ? 0 : size(random)), at[2] + (flat ? 0 : size(random))}
            );
        }
        out.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return out;
}

/// Every triangle on its own: the slow and simple way.
template <class Ask>
std::optional<Hit> by_hand(const Triangles& mesh, Ask ask) {
    std::optional<Hit> best;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Picker one(mesh.positions, std::span(mesh.triangles).subspan(i, 1));
        std::optional<Hit> hit = ask(one);
        if (!hit || (best && hit->distance >= best->distance)) continue;
        hit->triangle = i;
        best = hit;
    }
    return best;
}

void expect_same(const std::optional<Hit>& found, const std::optional<Hit>& expected) {
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (!found) return;
    EXPECT_NEAR(found->distance, expected->distance, 1e-9);
    EXPECT_NEAR(found->weights[0] + found->weights[1] + found->weights[2], 1, 1e-12);
}

TEST(Picker, finds_what_trying_every_triangle_finds) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-12, 12), target(-6, 12);
    int hits = 0;
    for (const Triangles& mesh : {sheet(12), soup(300)}) {
        const Picker picker(mesh.positions, mesh.triangles);
        for (int i = 0; i < 300; ++i) {
            const std::array<double, 3> from{place(random), place(random), place(random)};
            const std::array<double, 3> towards{
                target(random) - from[0], target(random) - from[1], target(random) / 6 - from[2]};
            const auto hit = picker.ray(from, towards);
            hits += hit ? 1 : 0;
            expect_same(hit, by_hand(mesh, [&](const Picker& one) { return one.ray(from, towards); }));
            expect_same(picker.nearest(from), by_hand(mesh, [&](const Picker& one) {
                            return one.nearest(from);
                        }));
        }
    }
    EXPECT_GT(hits, 50);
}

TEST(Picker, a_ray_through_a_shared_vertex_hits_there) {
    const Triangles mesh = sheet(10);
    const Picker picker(mesh.positions, mesh.triangles);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> turn(-1, 1);
    for (std::size_t y = 1; y < 10; ++y) {
        for (std::size_t x = 1; x < 10; ++x) {
            const Vertex3& vertex = mesh.positions[y * 11 + x];
            const std::array<double, 3> at{double(vertex[0]), double(vertex[1]), double(vertex[2])};
            const std::array<double, 3> from{at[0] + turn(random), at[1] + turn(random), 9};
            const auto hit = picker.ray(from, {at[0] - from[0], at[1] - from[1], at[2] - from[2]});

            ASSERT_TRUE(hit.has_value()) << x << " " << y;
            EXPECT_NEAR(std::hypot(at[0] - from[0], at[1] - from[1], at[2] - from[2]), hit->distance, 1e-9);
        }
    }
}

TEST(Picker, straight_down_on_a_flat_grid_nothing_slips_through_and_ties_go_to_the_smaller_triangle) {
    Triangles mesh = sheet(6);
    for (Vertex3& at : mesh.positions) at[2] = 0;
    const Picker picker(mesh.positions, mesh.triangles);
    for (int y = 0; y <= 12; ++y) {
        for (int x = 0; x <= 12; ++x) {
            const std::array<double, 3> from{x / 2.0, y / 2.0, 5};
            const auto hit = picker.ray(from, {0, 0, -2});
            ASSERT_TRUE(hit.has_value()) << x << " " << y;
            EXPECT_EQ(hit->distance, 5);
            const auto expected = by_hand(mesh, [&](const Picker& one) { return one.ray(from, {0, 0, -1}); });
            EXPECT_EQ(hit->triangle, expected->triangle) << x << " " << y;
        }
    }
}

TEST(Picker, both_sides_count_and_what_lies_behind_does_not) {
    const Triangles mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const Picker picker(mesh.positions, mesh.triangles);

    EXPECT_TRUE(picker.ray({0.2, 0.2, 1}, {0, 0, -1}).has_value());
    const auto from_below = picker.ray({0.25, 0.5, -2}, {0, 0, 10});
    ASSERT_TRUE(from_below.has_value());
    EXPECT_DOUBLE_EQ(from_below->distance, 2);
    EXPECT_DOUBLE_EQ(from_below->weights[0], 0.25);
    EXPECT_DOUBLE_EQ(from_below->weights[1], 0.25);
    EXPECT_DOUBLE_EQ(from_below->weights[2], 0.5);
    EXPECT_FALSE(picker.ray({0.2, 0.2, 1}, {0, 0, 1}).has_value());
    EXPECT_FALSE(picker.ray({2, 2, 1}, {0, 0, -1}).has_value());
}

TEST(Picker, the_nearest_place_may_be_inside_on_an_edge_or_a_corner) {
    const Triangles mesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
    const Picker picker(mesh.positions, mesh.triangles);

    EXPECT_DOUBLE_EQ(picker.nearest({0.5, 0.5, 3})->distance, 3);
    const auto edge = picker.nearest({1, -1, 0});
    EXPECT_DOUBLE_EQ(edge->distance, 1);
    EXPECT_DOUBLE_EQ(edge->weights[1], 0.5);
    const auto corner = picker.nearest({5, -4, 0});
    EXPECT_DOUBLE_EQ(corner->distance, 5);
    EXPECT_DOUBLE_EQ(corner->weights[1], 1);
}

TEST(Picker, asks_without_an_answer_get_none) {
    const Triangles mesh = sheet(2);
    const Picker picker(mesh.positions, mesh.triangles);
    const double nan = std::numeric_limits<double>::quiet_NaN();

    EXPECT_FALSE(picker.ray({0, 0, 1}, {0, 0, 0}).has_value());
    EXPECT_FALSE(picker.ray({nan, 0, 1}, {0, 0, -1}).has_value());
    EXPECT_FALSE(picker.ray({0, 0, 1}, {0, nan, -1}).has_value());
    EXPECT_FALSE(picker.nearest({0, nan, 0}).has_value());
    const Picker empty({}, {});
    EXPECT_FALSE(empty.ray({0, 0, 1}, {0, 0, -1}).has_value());
    EXPECT_FALSE(empty.nearest({0, 0, 0}).has_value());
}

TEST(Picker, triangles_on_one_spot_do_not_make_it_deep) {
    Triangles mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles.assign(10'000, {0, 1, 2});
    const Picker picker(mesh.positions, mesh.triangles);

    EXPECT_EQ(picker.ray({0.2, 0.2, 1}, {0, 0, -1})->triangle, 0U);
    EXPECT_EQ(picker.nearest({0.2, 0.2, 1})->triangle, 0U);
}

TEST(Picker, hierarchy_is_the_same_whatever_the_number_of_threads) {
    const Triangles mesh = soup(5000);
    set_thread_count(1);
    const Hierarchy alone = grow_hierarchy(mesh.positions, mesh.triangles);
    set_thread_count(3);
    const Hierarchy together = grow_hierarchy(mesh.positions, mesh.triangles);
    set_thread_count(0);
    EXPECT_EQ(alone.order, together.order);
    ASSERT_EQ(alone.nodes.size(), together.nodes.size());
    for (std::size_t i = 0; i < alone.nodes.size(); ++i) {
        EXPECT_EQ(alone.nodes[i].low, together.nodes[i].low);
        EXPECT_EQ(alone.nodes[i].high, together.nodes[i].high);
        EXPECT_EQ(alone.nodes[i].first, together.nodes[i].first);
        if (alone.nodes[i].count == 0) {
            EXPECT_GT(alone.nodes[i].first, i) << "children stand behind their parents";
        }
    }
}

}  // namespace
}  // namespace feelem
