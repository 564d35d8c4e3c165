// SPDX-License-Identifier: Apache-2.0
// Sections of small meshes: areas and values that can be known beforehand.
#include "base/parallel.hpp"
#include "inside/section_checks.hpp"
#include "model/vector.hpp"
#include "support/meshes.hpp"

#include "feelem/error.hpp"
#include "feelem/inside.hpp"
#include "feelem/skin.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace feelem {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

double linear(const Point3& p) {
    return 3 + 2 * p[0] - 5 * p[1] + 7 * p[2];
}

Result linear_field(const Mesh& mesh) {
    std::vector<float> values;
    for (const Point3& p : mesh.coordinates) values.push_back(static_cast<float>(linear(p)));
    return test::nodal(values);
}

Section cut(const Mesh& mesh, const Result& result, const Plane& plane) {
    return cut_plane(find_solids(mesh), {&result, 0}, plane).value();
}

/// Every quadratic element's edges are curves now, every quad facet is bent.
void bend(Mesh& mesh) {
    for (Point3& p : mesh.coordinates)
        p = {p[0] + 0.1 * p[1] * p[2], p[1] - 0.12 * p[0] * p[0], p[2] + 0.15 * p[0] * p[1]};
}

Plane random_plane(std::mt19937& random, const Mesh& mesh) {
    std::uniform_real_distribution<double> any(-1, 1);
    Plane plane{{any(random), any(random), any(random)}, 0};
    Point3 through{};
    double sum = 0;
    for (const Point3& p : mesh.coordinates) {
        const double weight = std::abs(any(random));
        for (std::size_t axis = 0; axis < 3; ++axis) through[axis] += weight * p[axis];
        sum += weight;
    }
    plane.offset = dot(plane.normal, through) / sum;
    return plane;
}

/// The section's rim is the skin's, and its area what the rim goes round.
void expect_section_of_skin(const Mesh& mesh, const Plane& plane) {
    Diagnostics diagnostics;
    const Surface skin = make_skin(mesh, {}, diagnostics);
    const Result result = linear_field(mesh);
    const auto rim = test::rim_of_skin(skin, carry(mesh, skin, result), plane);
    const Section section = cut(mesh, result, plane);
    ASSERT_FALSE(section.triangles.empty());
    EXPECT_EQ(test::rim_difference(section, rim), "");
    EXPECT_NEAR(section.area, test::area_within(rim, plane), 1e-9);
    EXPECT_EQ(test::rim_value_difference(section, rim, 1e-5), "");
    for (std::size_t v = 0; v < section.positions.size(); ++v)
        EXPECT_NEAR(double(section.values[v]), linear(section.positions[v]), 1e-5);
}

class SolidSection : public testing::TestWithParam<int> {
protected:
    ElementType type() const { return static_cast<ElementType>(GetParam()); }
};

TEST_P(SolidSection, of_a_straight_element_has_its_area) {
    Mesh mesh = test::one_element(type());
    // Of the reference elements at z = 1/4: a square, a triangle, what is left of them towards an apex.
    const std::string_view name = element_row(type()).name;
    const double area = name.starts_with("hex")       ? 1
                        : name.starts_with("wedge")   ? 0.5
                        : name.starts_with("pyramid") ? 0.75 * 0.75
                                                      : 0.75 * 0.75 / 2;
    EXPECT_NEAR(cut(mesh, linear_field(mesh), {{0, 0, 1}, 0.25}).area, area, 1e-12);
    EXPECT_NEAR(cut(mesh, linear_field(mesh), {{0, 0, -7}, -7 * 0.25}).area, area, 1e-12);
}

TEST_P(SolidSection, of_a_bent_element_joins_its_skin_and_gives_a_linear_field) {
    Mesh mesh = test::one_element(type());
    bend(mesh);
    std::mt19937 random(11);
    for (int i = 0; i < 40; ++i) expect_section_of_skin(mesh, random_plane(random, mesh));
}

TEST_P(SolidSection, of_an_element_without_some_mid_side_nodes_joins_its_skin) {
    Mesh mesh = test::one_element(type());
    if (element_row(type()).order == 1) return;
    bend(mesh);
    for (const std::size_t edge : {1U, 2U}) mesh.blocks[0].nodes[edges_of(type())[edge].middle] = kNoNode;
    std::mt19937 random(12);
    for (int i = 0; i < 20; ++i) expect_section_of_skin(mesh, random_plane(random, mesh));
}

TEST_P(SolidSection, of_a_mirrored_element_has_the_same_area) {
    Mesh mesh = test::one_element(type());
    bend(mesh);
    const double area = cut(mesh, linear_field(mesh), {{0, 0, 1}, 0.3}).area;
    EXPECT_GT(area, 0.1);
    for (Point3& p : mesh.coordinates) p[0] = -p[0];
    EXPECT_NEAR(cut(mesh, linear_field(mesh), {{0, 0, 1}, 0.3}).area, area, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Types,
    SolidSection,
    testing::Range(static_cast<int>(ElementType::Tet4), static_cast<int>(kElementTypeCount)),
    [](const auto& type) { return std::string(element_row(static_cast<ElementType>(type.param)).name); }
);

TEST(Section, of_bricks_joins_across_them_however_the_plane_lies) {
    Mesh mesh = test::brick_grid(4, 3, 5);
    bend(mesh);
    std::mt19937 random(13);
    for (int i = 0; i < 20; ++i) expect_section_of_skin(mesh, random_plane(random, mesh));
}

TEST(Section, in_the_facets_between_bricks_is_cut_once_on_the_side_that_stays) {
    const Mesh mesh = test::brick_grid(2, 2, 2);
    std::vector<float> numbers;
    for (std::size_t i = 0; i < mesh.element_count(); ++i) numbers.push_back(static_cast<float>(i));
    Result result = test::nodal(numbers);
    result.info.location = Location::Elemental;
    const Section section = cut(mesh, result, {{0, 0, 1}, 1});
    EXPECT_NEAR(section.area, 4, 1e-12);
    EXPECT_EQ(section.elements, 4U);
    for (const float value : section.values) EXPECT_LT(value, 4);  // the lower layer
    EXPECT_TRUE(cut(mesh, result, {{0, 0, 1}, 0}).triangles.empty());
    EXPECT_NEAR(cut(mesh, result, {{0, 0, 1}, 2}).area, 4, 1e-12);
}

TEST(Section, of_an_elemental_result_is_constant_in_each_element) {
    const Mesh mesh = test::brick_grid(3, 1, 1);
    Result result = test::nodal({10, kNan, 30});
    result.info.location = Location::Elemental;
    const Section section = cut(mesh, result, {{0, 0, 1}, 0.4});
    for (std::size_t t = 0; t < section.triangles.size(); ++t) {
        for (const std::uint32_t vertex : section.triangles[t]) {
            const float expected = result.values[raw(section.triangle_element[t])];
            EXPECT_TRUE(
                section.values[vertex] == expected ||
                (std::isnan(expected) && std::isnan(section.values[vertex]))
            );
        }
    }
    EXPECT_NEAR(section.area, 3, 1e-12);
}

TEST(Section, of_unaveraged_values_takes_each_element_its_own) {
    const Mesh mesh = test::brick_grid(2, 1, 1);
    Result result;
    result.info.components = {"other", "value"};
    result.info.location = Location::ElementNodal;
    for (std::uint32_t element = 0; element < 2; ++element) {
        for (const NodeIndex node : element_at(mesh, ElementIndex{element}).nodes()) {
            result.row_owner.push_back(element);
            result.row_node.push_back(node);
            result.values.insert(result.values.end(), {kNan, element == 0 ? 1.0F : 5.0F});
        }
    }
    const Section section = cut_plane(find_solids(mesh), {&result, 1}, {{0, 1, 0}, 0.5}).value();
    for (std::size_t t = 0; t < section.triangles.size(); ++t) {
        for (const std::uint32_t vertex : section.triangles[t])
            EXPECT_EQ(section.values[vertex], raw(section.triangle_element[t]) == 0 ? 1.0F : 5.0F);
    }
    EXPECT_NEAR(section.area, 2, 1e-12);
}

TEST(Section, of_values_averaged_within_parts_takes_those_of_the_element_s_part) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
        {{ElementType::Tet4, {1, 2, 3, 4}, "a"}, {ElementType::Tet4, {2, 3, 4, 5}, "b"}}
    );
    Result result;
    result.info.components = {"value"};
    result.info.location = Location::PartNodal;
    for (std::uint32_t i = 0; i < 4; ++i) {
        result.row_owner.push_back(0);
        result.row_node.push_back(NodeIndex{i});
        result.values.push_back(1);
    }
    for (std::uint32_t i = 1; i < 5; ++i) {
        result.row_owner.push_back(1);
        result.row_node.push_back(NodeIndex{i});
        result.values.push_back(2);
    }
    const Section section = cut(mesh, result, {{0, 0, 1}, 0.3});
    std::array<int, 2> seen{};
    for (std::size_t t = 0; t < section.triangles.size(); ++t) {
        const auto element = raw(section.triangle_element[t]);
        ++seen[element];
        for (const std::uint32_t vertex : section.triangles[t])
            EXPECT_NEAR(section.values[vertex], element == 0 ? 1.0F : 2.0F, 1e-6F);
    }
    EXPECT_GT(seen[0], 0);
    EXPECT_GT(seen[1], 0);
}

TEST(Section, with_a_missing_value_invents_none) {
    const Mesh mesh = test::brick_grid(3, 1, 1);
    Result result = linear_field(mesh);
    result.values[0] = kNan;  // a corner of the first brick alone
    const Section section = cut(mesh, result, {{0, 0, 1}, 0.4});
    for (std::size_t t = 0; t < section.triangles.size(); ++t) {
        int missing = 0;
        for (const std::uint32_t vertex : section.triangles[t]) missing += std::isnan(section.values[vertex]);
        EXPECT_EQ(missing > 0, raw(section.triangle_element[t]) == 0);
    }
}

TEST(Section, of_corner_only_results_has_the_means_between_them_as_the_skin_has) {
    Mesh mesh = test::one_element(ElementType::Hex20);
    Result result = linear_field(mesh);
    for (std::size_t i = 8; i < 20; ++i) result.values[i] = kNan;
    EXPECT_TRUE(std::isnan(cut(mesh, result, {{0, 0, 1}, 0.3}).values[0]));
    result.info.corner_only = true;
    const Section section = cut(mesh, result, {{0, 0, 1}, 0.3});
    for (std::size_t v = 0; v < section.positions.size(); ++v)
        EXPECT_NEAR(double(section.values[v]), linear(section.positions[v]), 1e-5);
}

TEST(Section, moves_and_turns_with_the_mesh) {
    Mesh mesh = test::brick_grid(3, 2, 2);
    bend(mesh);
    const Result result = linear_field(mesh);
    const Plane plane{{0.3, -0.5, 0.8}, 0.4};
    const Section before = cut(mesh, result, plane);
    const double c = std::cos(0.7), s = std::sin(0.7);
    const auto turn = [&](const Point3& p) { return Point3{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]}; };
    const Point3 shift{100, -200, 50};
    const auto move = [&](const Point3& p) {
        const Point3 t = turn(p);
        return Point3{t[0] + shift[0], t[1] + shift[1], t[2] + shift[2]};
    };
    for (Point3& p : mesh.coordinates) p = move(p);
    const Point3 normal = turn(plane.normal);
    const Section after = cut(mesh, result, {normal, plane.offset + dot(normal, shift)});
    ASSERT_EQ(after.triangles, before.triangles);
    for (std::size_t v = 0; v < before.positions.size(); ++v) {
        EXPECT_LT(length(minus(after.positions[v], move(before.positions[v]))), 1e-10);
        EXPECT_NEAR(after.values[v], before.values[v], 1e-5);
    }
}

TEST(Section, of_a_deformed_shape_lies_where_the_displacements_bring_it) {
    const Mesh mesh = test::brick_grid(2, 2, 2);
    Result displacement;
    displacement.info.components = {"x", "y", "z"};
    Mesh expected = mesh;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
        const Point3& p = mesh.coordinates[i];
        const std::array<float, 3> u{static_cast<float>(p[1]) / 16, static_cast<float>(p[2]) / 8, 0.25F};
        displacement.values.insert(displacement.values.end(), u.begin(), u.end());
        for (std::size_t axis = 0; axis < 3; ++axis) expected.coordinates[i][axis] += 3 * double(u[axis]);
    }
    const Result result = linear_field(mesh);
    const Solids solids = find_solids(mesh);
    const Plane plane{{0.1, 0.2, 1}, 1.9};
    const Section moved = cut_plane(moved_by(solids, displacement, 3), {&result, 0}, plane).value();
    const Section direct = cut(expected, result, plane);
    EXPECT_EQ(moved.positions, direct.positions);
    EXPECT_EQ(moved.values, direct.values);
    EXPECT_NE(moved.positions, cut(mesh, result, plane).positions);
    displacement.values[0] = kNan;
    EXPECT_EQ(moved_by(solids, displacement, 3).places()[0], mesh.coordinates[0]);
    EXPECT_THROW(moved_by(solids, result, 1), Error);
}

TEST(Section, leaves_out_elements_whose_corners_have_no_place_and_says_how_many) {
    Mesh mesh = test::brick_grid(2, 1, 1);
    mesh.coordinates[0][1] = std::numeric_limits<double>::quiet_NaN();
    const Section section = cut(mesh, test::nodal(std::vector<float>(12, 1)), {{0, 0, 1}, 0.5});
    EXPECT_EQ(section.elements_without_place, 1U);
    EXPECT_NEAR(section.area, 1, 1e-12);
}

TEST(Section, leaves_out_elements_listed_twice) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {{ElementType::Tet4, {1, 2, 3, 4}}, {ElementType::Tet4, {2, 3, 1, 4}}}
    );
    EXPECT_EQ(find_solids(mesh).count, 1U);
    EXPECT_NEAR(cut(mesh, linear_field(mesh), {{0, 0, 1}, 0.25}).area, 0.75 * 0.75 / 2, 1e-12);
}

TEST(Section, of_shells_is_empty) {
    const Mesh mesh = test::one_element(ElementType::Quad8);
    EXPECT_EQ(find_solids(mesh).count, 0U);
    EXPECT_TRUE(cut(mesh, linear_field(mesh), {{1, 0, 0}, 0.5}).triangles.empty());
}

TEST(Section, has_the_same_bytes_for_any_number_of_threads) {
    Mesh mesh = test::brick_grid(25, 25, 25);
    bend(mesh);
    const Result result = linear_field(mesh);
    set_thread_count(1);
    const Section one = cut(mesh, result, {{0.3, -0.5, 0.8}, 4});
    set_thread_count(4);
    const Section four = cut(mesh, result, {{0.3, -0.5, 0.8}, 4});
    set_thread_count(0);
    EXPECT_GT(one.triangles.size(), 1000U);
    EXPECT_EQ(one.positions, four.positions);
    EXPECT_EQ(one.values, four.values);
    EXPECT_EQ(one.triangles, four.triangles);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(one.area), std::bit_cast<std::uint64_t>(four.area));
}

TEST(Section, ends_when_it_is_cancelled_or_too_large) {
    const Mesh mesh = test::brick_grid(25, 25, 25);
    const Result result = linear_field(mesh);
    const Solids solids = find_solids(mesh);
    std::atomic<int> asked = 0;
    SectionLimits limits;
    limits.is_cancelled = [&] { return ++asked > 1; };
    EXPECT_FALSE(cut_plane(solids, {&result, 0}, {{0, 0, 1}, 0.5}, limits));
    limits = {};
    limits.most_triangles = 100;
    try {
        cut_plane(solids, {&result, 0}, {{0, 0, 1}, 0.5}, limits);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::TooLarge);
        EXPECT_STREQ(error.what(), "the section has more than 100 triangles");
    }
}

TEST(Section, refuses_what_is_no_plane_and_no_component) {
    const Mesh mesh = test::brick_grid(1, 1, 1);
    const Result result = linear_field(mesh);
    const Solids solids = find_solids(mesh);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(cut_plane(solids, {&result, 0}, {{0, 0, 0}, 0}), Error);
    EXPECT_THROW(cut_plane(solids, {&result, 0}, {{nan, 0, 1}, 0}), Error);
    EXPECT_THROW(cut_plane(solids, {&result, 0}, {{0, 0, 1}, nan}), Error);
    EXPECT_THROW(cut_plane(solids, {&result, 1}, {{0, 0, 1}, 0}), Error);
    EXPECT_THROW(isosurface(solids, {&result, 0}, nan), Error);
}

TEST(Isosurface, of_a_linear_field_is_a_plane_with_its_section_s_area_and_colours) {
    Mesh mesh = test::brick_grid(3, 3, 3);
    const Result field = linear_field(mesh);
    std::vector<float> other;
    for (const Point3& p : mesh.coordinates) other.push_back(static_cast<float>(p[0] - p[2]));
    const Result colour = test::nodal(other);
    const Plane plane{{2, -5, 7}, 6 - 3};
    const Solids solids = find_solids(mesh);
    const Section iso = isosurface(solids, {&field, 0}, 6, FieldOf{&colour, 0}).value();
    EXPECT_NEAR(iso.area, cut(mesh, field, plane).area, 1e-9);
    for (std::size_t v = 0; v < iso.positions.size(); ++v) {
        const Point3& p = iso.positions[v];
        EXPECT_NEAR(linear(p), 6, 1e-5);
        EXPECT_NEAR(double(iso.values[v]), p[0] - p[2], 1e-5);
    }
    const Section plain = isosurface(solids, {&field, 0}, 6).value();
    for (const float value : plain.values) EXPECT_EQ(value, 6.0F);
    EXPECT_TRUE(isosurface(solids, {&field, 0}, 1e6)->triangles.empty());
}

TEST(Isosurface, has_a_hole_where_values_are_missing_and_none_at_all_of_elements) {
    const Mesh mesh = test::brick_grid(3, 1, 1);
    Result field = test::nodal({});
    for (const Point3& p : mesh.coordinates) field.values.push_back(static_cast<float>(p[2]));
    field.values[0] = kNan;
    const Section iso = isosurface(find_solids(mesh), {&field, 0}, 0.5).value();
    EXPECT_NEAR(iso.area, 2, 1e-6);
    for (const ElementIndex element : iso.triangle_element) EXPECT_NE(raw(element), 0U);
    field.info.location = Location::Elemental;
    EXPECT_THROW(isosurface(find_solids(mesh), {&field, 0}, 0.5), Error);
}

}  // namespace
}  // namespace feelem
