// SPDX-License-Identifier: Apache-2.0
// Which element a place is in, and the value there.
#include "inside/section_checks.hpp"
#include "support/meshes.hpp"

#include "feelem/inside.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace feelem {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

double linear(const Point3& p) {
    return 3 + 2 * p[0] - 5 * p[1] + 7 * p[2];
}

Result field_of(const Mesh& mesh, double (*function)(const Point3&)) {
    std::vector<float> values;
    for (const Point3& p : mesh.coordinates) values.push_back(static_cast<float>(function(p)));
    return test::nodal(values);
}

TEST(InteriorPoint, of_each_solid_is_found_with_the_value_of_a_linear_field) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.01, 1);
    for (int t = static_cast<int>(ElementType::Tet4); t < static_cast<int>(kElementTypeCount); ++t) {
        Mesh mesh = test::one_element(static_cast<ElementType>(t));
        for (Point3& p : mesh.coordinates)
            p = {1000 + p[0] + 0.1 * p[1] * p[2], p[1] - 0.1 * p[0] * p[0], p[2]};
        const Result field = field_of(mesh, linear);
        const Solids solids = find_solids(mesh);
        const InteriorFinder finder(solids);
        const std::size_t corners = element_row(static_cast<ElementType>(t)).corner_count;
        for (int i = 0; i < 50; ++i) {
            Point3 place{};
            double sum = 0;
            for (std::size_t k = 0; k < corners; ++k) {
                const double weight = share(random);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    place[axis] += weight * mesh.coordinates[k][axis];
                sum += weight;
            }
            for (double& v : place) v /= sum;
            place[1] -= 0.01;  // Bent edges: the corners' middle may lie above them.
            const auto found = finder.find(place);
            if (!found) continue;
            EXPECT_NEAR(std::accumulate(found->weights.begin(), found->weights.end(), 0.0), 1, 1e-9);
            EXPECT_NEAR(double(value_at(mesh, {&field, 0}, *found).value), linear(place), 2e-3);
        }
        const Point3 inside = mesh.coordinates[0];
        EXPECT_TRUE(finder.find(inside)) << element_row(static_cast<ElementType>(t)).name;
        EXPECT_FALSE(finder.find({1002, 0, 0}));
        EXPECT_FALSE(finder.find({kNan, 0, 0}));
        EXPECT_FALSE(finder.find({1e300, 0, 0}));
    }
}

TEST(InteriorPoint, at_every_node_has_its_value_bit_for_bit) {
    const Mesh mesh = test::brick_grid(4, 3, 2);
    const Result field =
        field_of(mesh, [](const Point3& p) { return std::sin(p[0]) + std::cos(3 * p[1] + p[2]); });
    const Solids solids = find_solids(mesh);
    const InteriorFinder finder(solids);
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
        const auto found = finder.find(mesh.coordinates[i]);
        ASSERT_TRUE(found);
        EXPECT_EQ(value_at(mesh, {&field, 0}, *found).value, field.values[i]);
    }
}

TEST(InteriorPoint, in_a_brick_is_trilinear_with_the_brick_s_nodes) {
    const Mesh mesh = test::brick_grid(4, 3, 2);
    const Result field = field_of(mesh, [](const Point3& p) { return p[0] * p[1] * p[2] + p[0] * p[1]; });
    const Solids solids = find_solids(mesh);
    const InteriorFinder finder(solids);
    const auto found = finder.find({2.25, 1.5, 0.75});
    ASSERT_TRUE(found);
    EXPECT_EQ(raw(found->element), 2U + 4 * 1);
    EXPECT_NEAR(found->natural[0], 0.25, 1e-12);
    EXPECT_NEAR(found->natural[1], 0.5, 1e-12);
    EXPECT_NEAR(found->natural[2], 0.75, 1e-12);
    const InteriorValue value = value_at(mesh, {&field, 0}, *found);
    EXPECT_EQ(value.value, static_cast<float>(2.25 * 1.5 * 0.75 + 2.25 * 1.5));
    ASSERT_EQ(value.node_values.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(value.node_values[i], field.values[raw(found->nodes[i])]);
}

TEST(InteriorPoint, between_bricks_belongs_to_the_first) {
    const Mesh mesh = test::brick_grid(3, 1, 1);
    Result field = test::nodal({10, 20, 30});
    field.info.location = Location::Elemental;
    const Solids solids = find_solids(mesh);
    const InteriorFinder finder(solids);
    const auto found = finder.find({2, 0.5, 0.5});
    ASSERT_TRUE(found);
    EXPECT_EQ(raw(found->element), 1U);
    EXPECT_EQ(value_at(mesh, {&field, 0}, *found).value, 20);
}

TEST(InteriorPoint, next_to_a_missing_value_has_none) {
    const Mesh mesh = test::brick_grid(2, 1, 1);
    Result field = field_of(mesh, linear);
    field.values[0] = kNan;
    const Solids solids = find_solids(mesh);
    const InteriorFinder finder(solids);
    EXPECT_TRUE(std::isnan(value_at(mesh, {&field, 0}, *finder.find({0.5, 0.5, 0.5})).value));
    EXPECT_FALSE(std::isnan(value_at(mesh, {&field, 0}, *finder.find({1.5, 0.5, 0.5})).value));
}

/// A quarter ring of one element: its middle lies outside the brick of its corners.
TEST(InteriorPoint, of_a_curved_element_lies_where_the_curve_is) {
    Mesh mesh = test::one_element(ElementType::Hex20);
    for (Point3& p : mesh.coordinates) {
        const double radius = 1 + p[1], angle = p[0] * 1.57;
        p = {radius * std::cos(angle), radius * std::sin(angle), p[2]};
    }
    const Solids solids = find_solids(mesh);
    const InteriorFinder finder(solids);
    EXPECT_TRUE(finder.find({1.95 * std::cos(0.785), 1.95 * std::sin(0.785), 0.5}));
    EXPECT_FALSE(finder.find({0.9 * std::cos(0.785), 0.9 * std::sin(0.785), 0.5})
    );  // within the corners' hull
    EXPECT_FALSE(finder.find({2.1 * std::cos(0.785), 2.1 * std::sin(0.785), 0.5}));
}

/// Edges that bulge out of the box of the nodes: their highest places lie between these.
TEST(InteriorPoint, of_an_element_may_lie_beyond_the_box_of_its_nodes) {
    Mesh mesh = test::one_element(ElementType::Hex20);
    for (const EdgeRow& edge : edges_of(ElementType::Hex20)) {
        if (mesh.coordinates[edge.middle][2] == 1) mesh.coordinates[edge.middle][2] = 1.2;
    }
    const Solids solids = find_solids(mesh);
    const InteriorFinder finder(solids);
    EXPECT_TRUE(finder.find({0.5, 0.5, 1.35}));
    EXPECT_FALSE(finder.find({0.5, 0.5, 1.45}));
}

TEST(InteriorPoint, of_a_mesh_without_solids_is_not_found) {
    const Mesh mesh = test::one_element(ElementType::Tri3);
    const Solids solids = find_solids(mesh);
    EXPECT_FALSE(InteriorFinder(solids).find({0.2, 0.2, 0}));
}

}  // namespace
}  // namespace feelem
