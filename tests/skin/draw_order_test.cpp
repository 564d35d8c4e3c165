// SPDX-License-Identifier: Apache-2.0
// The order for drawing changes nothing but the order.
#include "support/meshes.hpp"

#include "feelem/skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <tuple>

namespace feelem {
namespace {

Mesh slab(int side) {
    Mesh mesh = test::brick_grid(side, side, 1);
    for (Point3& at : mesh.coordinates) at[2] *= 1 + 0.1 * std::fmod(at[0] * 7 + at[1] * 3, 5.0);
    return mesh;
}

/// Two squares side by side, parts a and b; nodes 2 and 3 are shared.
Mesh squares_of_two_parts() {
    return test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
        {{ElementType::Quad4, {1, 2, 3, 4}, "a"}, {ElementType::Quad4, {2, 5, 6, 3}, "b"}}
    );
}

/// A triangle without regard to where it stands: part, element, places of its corners from the smallest on.
using Shape3 = std::tuple<std::size_t, std::uint32_t, std::array<Point3, 3>>;

std::vector<Shape3> triangles_of(const Surface& surface) {
    std::vector<Shape3> out;
    for (std::size_t p = 0; p < surface.parts.size(); ++p) {
        const SurfacePart& part = surface.parts[p];
        for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
            std::array<Point3, 3> corners{};
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t vertex = raw(surface.triangles[t][i]);
                EXPECT_GE(vertex, part.first_vertex);
                EXPECT_LT(vertex, part.first_vertex + part.vertex_count);
                corners[i] = surface.positions[vertex];
            }
            std::ranges::rotate(corners, std::ranges::min_element(corners));
            out.emplace_back(p, raw(surface.triangle_element[t]), corners);
        }
    }
    std::ranges::sort(out);
    return out;
}

TEST(DrawOrder, keeps_every_triangle_with_its_element_and_winding) {
    Diagnostics diagnostics;
    const Surface before = make_skin(slab(20), {}, diagnostics);
    Surface after = before;
    order_for_drawing(after);
    EXPECT_NE(before.triangles, after.triangles) << "nothing was ordered";
    EXPECT_EQ(triangles_of(before), triangles_of(after));
}

TEST(DrawOrder, keeps_parts_apart) {
    Diagnostics diagnostics;
    const Surface before = make_skin(squares_of_two_parts(), {}, diagnostics);
    Surface after = before;
    order_for_drawing(after);
    ASSERT_EQ(after.parts.size(), 2u);
    EXPECT_EQ(triangles_of(before), triangles_of(after));
}

/// Vertices that a card with room for 16 has to make again, per triangle.
double misses_per_triangle(const Surface& surface) {
    std::deque<VertexIndex> room;
    std::size_t misses = 0;
    for (const auto& triangle : surface.triangles) {
        for (const VertexIndex corner : triangle) {
            if (std::ranges::find(room, corner) != room.end()) continue;
            ++misses;
            room.push_back(corner);
            if (room.size() > 16) room.pop_front();
        }
    }
    return static_cast<double>(misses) / static_cast<double>(surface.triangles.size());
}

TEST(DrawOrder, neighbours_follow_each_other) {
    Diagnostics diagnostics;
    const Surface before = make_skin(slab(40), {}, diagnostics);
    Surface after = before;
    order_for_drawing(after);
    EXPECT_LT(misses_per_triangle(after), 0.75);
    EXPECT_LT(misses_per_triangle(after), 0.9 * misses_per_triangle(before));
}

TEST(DrawOrder, values_arrive_at_the_same_places) {
    const Mesh mesh = slab(12);
    Diagnostics diagnostics;
    const Surface before = make_skin(mesh, {}, diagnostics);
    Surface after = before;
    order_for_drawing(after);
    Result result;
    result.info.components = {"value"};
    result.info.location = Location::Nodal;
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
        result.values.push_back(0.1F * static_cast<float>(i * i));
    const auto placed = [&](const Surface& surface) {
        const SurfaceField field = carry(mesh, surface, result);
        std::vector<std::tuple<std::size_t, Point3, std::array<float, 3>, float, std::uint32_t>> rows;
        for (std::size_t p = 0; p < surface.parts.size(); ++p) {
            for (std::uint32_t i = 0; i < surface.parts[p].vertex_count; ++i) {
                const std::size_t v = surface.parts[p].first_vertex + i;
                rows.emplace_back(
                    p, surface.positions[v], surface.normals[v], field.values[v], raw(surface.vertex_node[v])
                );
            }
        }
        std::ranges::sort(rows);
        return rows;
    };
    EXPECT_GT(before.blends.size(), 100u);
    EXPECT_EQ(placed(before), placed(after));
}

TEST(DrawOrder, edges_join_the_same_places) {
    Diagnostics diagnostics;
    const Surface before = make_skin(slab(9), {}, diagnostics);
    Surface after = before;
    order_for_drawing(after);
    const auto ends = [](const Surface& surface) {
        std::vector<std::array<Point3, 2>> out;
        for (const auto& edge : surface.edges)
            out.push_back({surface.positions[raw(edge[0])], surface.positions[raw(edge[1])]});
        return out;
    };
    EXPECT_EQ(ends(before), ends(after));
}

}  // namespace
}  // namespace feelem
