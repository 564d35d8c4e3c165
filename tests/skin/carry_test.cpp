// SPDX-License-Identifier: Apache-2.0
#include "support/meshes.hpp"

#include "feelem/skin.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace feelem {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

Surface skin_of(const Mesh& mesh, Domain domain = Domain::Node) {
    SkinOptions options;
    options.domain = domain;
    Diagnostics diagnostics;
    return make_skin(mesh, options, diagnostics);
}

Result scalar(Location location, std::vector<float> values) {
    Result result;
    result.info.components = {"value"};
    result.info.location = location;
    result.values = std::move(values);
    return result;
}

/// Two squares side by side, parts a and b; nodes 2 and 3 are shared.
Mesh two_squares() {
    return test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
        {{ElementType::Quad4, {1, 2, 3, 4}, "a"}, {ElementType::Quad4, {2, 5, 6, 3}, "b"}}
    );
}

/// Value at the vertex of a node in part i of the surface.
float at(const Surface& surface, const SurfaceField& field, std::size_t part, std::uint32_t node) {
    const SurfacePart& p = surface.parts[part];
    for (std::uint32_t v = p.first_vertex; v < p.first_vertex + p.vertex_count; ++v) {
        if (surface.vertex_node[v] == NodeIndex{node}) return field.values[v];
    }
    ADD_FAILURE() << "no vertex of node " << node;
    return kNan;
}

TEST(Carry, every_bit_of_a_value_arrives) {
    const Mesh mesh = test::one_element(ElementType::Tet4);
    const Surface surface = skin_of(mesh);
    const std::vector<float> values{-0.0F, std::numeric_limits<float>::denorm_min(), 1e38F, 0.1F};

    const SurfaceField field = carry(mesh, surface, scalar(Location::Nodal, values));

    for (std::size_t v = 0; v < field.values.size(); ++v)
        EXPECT_EQ(
            std::bit_cast<std::uint32_t>(field.values[v]),
            std::bit_cast<std::uint32_t>(values[raw(surface.vertex_node[v])])
        );
}

TEST(Carry, a_missing_value_is_nan_with_its_mask_and_spoils_the_centre) {
    const Mesh mesh = two_squares();
    const Surface surface = skin_of(mesh);

    const SurfaceField field = carry(mesh, surface, scalar(Location::Nodal, {kNan, 2, 3, 4, 5, 6}));

    EXPECT_EQ(field.missing, 1U);
    EXPECT_EQ(field.interpolated, 0U);
    for (std::size_t v = 0; v < field.values.size(); ++v)
        EXPECT_EQ(std::isnan(field.values[v]), field.validity[v] == Validity::Missing);
    const std::size_t first_centre = raw(surface.blends.at(0).vertex);
    const std::size_t second_centre = raw(surface.blends.at(1).vertex);
    EXPECT_EQ(field.validity[first_centre], Validity::Missing);
    EXPECT_EQ(field.validity[second_centre], Validity::Interpolated);
    EXPECT_EQ(field.values[second_centre], 4);
}

TEST(Carry, one_missing_component_makes_the_vertex_missing_but_keeps_the_others) {
    const Mesh mesh = test::tiny_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{ElementType::Tri3, {1, 2, 3}}});
    Result result = scalar(Location::Nodal, {1, 2, kNan, 4, 5, 6, 7, 8, 9});
    result.info.components = {"x", "y", "z"};

    const SurfaceField field = carry(mesh, skin_of(mesh), result);

    EXPECT_EQ(field.component_count, 3U);
    EXPECT_EQ(field.validity[0], Validity::Missing);
    EXPECT_EQ(field.values[1], 2);
    EXPECT_EQ(field.validity[1], Validity::Solver);
    EXPECT_EQ(field.missing, 1U);
}

TEST(Carry, values_averaged_by_part_keep_their_jump_at_the_border) {
    const Mesh mesh = two_squares();
    const Surface surface = skin_of(mesh);
    Result result = scalar(Location::PartNodal, {1, 2, 3, 4, 20, 30, 50, 60});
    result.row_owner = {0, 0, 0, 0, 1, 1, 1, 1};
    result.row_node = {
        NodeIndex{0},
        NodeIndex{1},
        NodeIndex{2},
        NodeIndex{3},
        NodeIndex{1},
        NodeIndex{2},
        NodeIndex{4},
        NodeIndex{5}};

    const SurfaceField field = carry(mesh, surface, result);

    EXPECT_EQ(at(surface, field, 0, 1), 2);
    EXPECT_EQ(at(surface, field, 1, 1), 20);
    EXPECT_EQ(at(surface, field, 1, 5), 60);
    EXPECT_EQ(field.missing, 0U);
}

TEST(Carry, elemental_values_are_flat_on_their_element_centres_too) {
    const Mesh mesh = two_squares();
    const Surface surface = skin_of(mesh, Domain::ElementNode);

    const SurfaceField field = carry(mesh, surface, scalar(Location::Elemental, {0.1F, 7.7F}));

    for (std::size_t v = 0; v < field.values.size(); ++v)
        EXPECT_EQ(field.values[v], surface.vertex_element[v] == ElementIndex{0} ? 0.1F : 7.7F);
}

TEST(Carry, unaveraged_values_are_those_of_the_element_and_node) {
    const Mesh mesh = two_squares();
    const Surface surface = skin_of(mesh, Domain::ElementNode);
    Result result = scalar(Location::ElementNodal, {4, 3, 2, 1, 50, 20, 30});
    result.row_owner = {0, 0, 0, 0, 1, 1, 1};
    result.row_node = {
        NodeIndex{3}, NodeIndex{2}, NodeIndex{1}, NodeIndex{0}, NodeIndex{4}, NodeIndex{1}, NodeIndex{2}};

    const SurfaceField field = carry(mesh, surface, result);

    EXPECT_EQ(at(surface, field, 0, 1), 2);
    EXPECT_EQ(at(surface, field, 1, 1), 20);
    EXPECT_TRUE(std::isnan(at(surface, field, 1, 5)));
    EXPECT_EQ(field.missing, 1U);
}

/// A quadratic triangle; the middle of 1-2 is node 4, of 2-3 node 5, of 3-1 node 6.
Mesh tri6() {
    return test::one_element(ElementType::Tri6);
}

TEST(CornerOnly, a_mid_side_vertex_gets_the_mean_of_its_corners_marked_as_interpolated) {
    const Mesh mesh = tri6();
    const Surface surface = skin_of(mesh);
    Result result = scalar(Location::Nodal, {1, 2, 0.1F, kNan, kNan, kNan});
    result.info.corner_only = true;

    const SurfaceField field = carry(mesh, surface, result);

    EXPECT_EQ(at(surface, field, 0, 3), 1.5F);
    // In double, rounded once.
    EXPECT_EQ(at(surface, field, 0, 4), static_cast<float>((2 + double(0.1F)) / 2));
    EXPECT_EQ(field.interpolated, 3U);
    EXPECT_EQ(field.missing, 0U);
    for (std::size_t v = 0; v < field.values.size(); ++v) {
        const bool is_middle = raw(surface.vertex_node[v]) >= 3;
        EXPECT_EQ(field.validity[v], is_middle ? Validity::Interpolated : Validity::Solver);
    }
}

TEST(CornerOnly, other_gaps_stay_missing) {
    const Mesh mesh = tri6();
    const Surface surface = skin_of(mesh);
    Result result = scalar(Location::Nodal, {1, kNan, 3, kNan, kNan, kNan});

    EXPECT_EQ(carry(mesh, surface, result).missing, 4U);
    result.info.corner_only = true;
    const SurfaceField field = carry(mesh, surface, result);
    // Corner 2 and the middles of its two edges.
    EXPECT_EQ(field.missing, 3U);
    EXPECT_EQ(field.interpolated, 1U);
    EXPECT_EQ(at(surface, field, 0, 5), 2);
}

TEST(CornerOnly, middles_are_filled_from_their_own_part_and_element) {
    const Mesh mesh = tri6();
    Result by_part = scalar(Location::PartNodal, {1, 2, 5});
    by_part.info.corner_only = true;
    by_part.row_owner = {0, 0, 0};
    by_part.row_node = {NodeIndex{0}, NodeIndex{1}, NodeIndex{2}};
    const Surface shared = skin_of(mesh);
    EXPECT_EQ(at(shared, carry(mesh, shared, by_part), 0, 4), 3.5F);

    Result unaveraged = by_part;
    unaveraged.info.location = Location::ElementNodal;
    const Surface own = skin_of(mesh, Domain::ElementNode);
    const SurfaceField field = carry(mesh, own, unaveraged);
    EXPECT_EQ(at(own, field, 0, 3), 1.5F);
    EXPECT_EQ(field.interpolated, 3U);
}

TEST(CornerOnly, the_centre_of_a_quad_is_made_from_filled_middles) {
    const Mesh mesh = test::one_element(ElementType::Quad8);
    const Surface surface = skin_of(mesh);
    Result result = scalar(Location::Nodal, {0, 1, 2, 5, kNan, kNan, kNan, kNan});
    result.info.corner_only = true;

    const SurfaceField field = carry(mesh, surface, result);

    // With middles halfway the serendipity centre is the mean of the corners.
    EXPECT_EQ(field.values[raw(surface.blends.at(0).vertex)], 2);
    EXPECT_EQ(field.interpolated, 4U);
}

TEST(Carry, serendipity_centres_weigh_corners_and_middles) {
    const Mesh mesh = test::one_element(ElementType::Quad8);
    const Surface surface = skin_of(mesh);

    const SurfaceField field = carry(mesh, surface, scalar(Location::Nodal, {1, 2, 3, 4, 5, 6, 7, 8}));

    EXPECT_EQ(field.values[raw(surface.blends.at(0).vertex)], -10.0F / 4 + 26.0F / 2);
}

TEST(Carry, a_result_shorter_than_the_mesh_is_missing_where_it_ends) {
    const Mesh mesh = two_squares();
    const Surface surface = skin_of(mesh, Domain::ElementNode);

    EXPECT_GT(carry(mesh, surface, scalar(Location::Elemental, {1})).missing, 0U);
}

}  // namespace
}  // namespace feelem
