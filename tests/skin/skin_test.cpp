// SPDX-License-Identifier: Apache-2.0
#include "support/meshes.hpp"
#include "support/skin_checks.hpp"

#include "feelem/error.hpp"
#include "feelem/skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace feelem {
namespace {

Surface skin_of(const Mesh& mesh, const SkinOptions& options = {}) {
    Diagnostics diagnostics;
    return make_skin(mesh, options, diagnostics);
}

TEST(Skin, inner_facet_of_two_bricks_is_dropped) {
    const Surface surface = test::check_skin(test::brick_grid(2, 1, 1));

    EXPECT_EQ(surface.report.solid_facets_in, 12U);
    EXPECT_EQ(surface.report.solid_facets_kept, 10U);
    EXPECT_EQ(surface.report.facets_inner, 2U);
    EXPECT_EQ(surface.report.solid_quad_kept, 10U);
    EXPECT_EQ(surface.report.triangles, 40U);
    EXPECT_EQ(surface.report.vertices, 12U);
    EXPECT_DOUBLE_EQ(surface.report.area, 10);
    EXPECT_DOUBLE_EQ(surface.report.volume, 2);
}

TEST(Skin, a_plate_one_element_thick_keeps_only_its_outside) {
    const Surface surface = test::check_skin(test::brick_grid(5, 4, 1));

    EXPECT_EQ(surface.report.solid_facets_kept, 2U * 20 + 2 * 5 + 2 * 4);
}

TEST(Skin, nodes_inside_get_no_vertex) {
    const Surface surface = test::check_skin(test::brick_grid(4, 4, 4));

    EXPECT_EQ(surface.report.vertices, 125U - 27U);
    EXPECT_EQ(std::ranges::count(surface.vertex_node, NodeIndex{62}), 0);
}

class EverySolid : public testing::TestWithParam<ElementType> {};

TEST_P(EverySolid, alone_is_closed_and_has_its_own_volume) {
    const Mesh mesh = test::one_element(GetParam());

    const Surface surface = test::check_skin(mesh);

    EXPECT_EQ(surface.report.solid_facets_kept, element_row(GetParam()).facet_count);
    const bool has_inner_node = GetParam() == ElementType::Hex27;
    EXPECT_EQ(surface.report.vertices, mesh.node_count() - (has_inner_node ? 1 : 0));
}

INSTANTIATE_TEST_SUITE_P(
    Table,
    EverySolid,
    testing::Values(
        ElementType::Tet4,
        ElementType::Tet10,
        ElementType::Pyramid5,
        ElementType::Pyramid13,
        ElementType::Wedge6,
        ElementType::Wedge15,
        ElementType::Wedge18,
        ElementType::Hex8,
        ElementType::Hex20,
        ElementType::Hex27
    ),
    [](const auto& row) { return std::string(element_row(row.param).name); }
);

TEST(Skin, facets_are_cut_as_the_contract_says) {
    const auto triangles = [](ElementType type) { return skin_of(test::one_element(type)).report.triangles; };

    EXPECT_EQ(triangles(ElementType::Tri3), 1U);
    EXPECT_EQ(triangles(ElementType::Quad4), 4U);
    EXPECT_EQ(triangles(ElementType::Tri6), 4U);
    EXPECT_EQ(triangles(ElementType::Quad8), 8U);
    EXPECT_EQ(triangles(ElementType::Quad9), 8U);
}

TEST(Skin, every_shell_is_its_own_facet) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}},
        {{ElementType::Quad4, {1, 2, 3, 4}}, {ElementType::Tri3, {2, 5, 3}}}
    );

    const Surface surface = skin_of(mesh);

    EXPECT_EQ(surface.report.shell_quad, 1U);
    EXPECT_EQ(surface.report.shell_tri, 1U);
    ASSERT_EQ(surface.parts.size(), 1U);
    EXPECT_EQ(surface.parts[0].kind, PartKind::Shell);
    EXPECT_FALSE(surface.report.has_solids);
    EXPECT_FALSE(surface.report.closed);
    EXPECT_DOUBLE_EQ(surface.report.area, 1.5);
    EXPECT_EQ(surface.report.volume, 0);
}

TEST(Skin, a_mesh_of_nothing_that_can_be_drawn_is_refused) {
    EXPECT_THROW(skin_of(Mesh{}), Error);
}

TEST(Skin, values_are_carried_bit_for_bit) {
    const Mesh mesh = test::brick_grid(3, 2, 2);
    const Surface surface = skin_of(mesh);
    Result result;
    result.info.components = {"value"};
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
        result.values.push_back(0.1F * static_cast<float>(i) + 1e-7F);

    const SurfaceField field = carry(mesh, surface, result);

    ASSERT_EQ(field.values.size(), surface.positions.size());
    for (std::size_t v = 0; v < field.values.size(); ++v) {
        const NodeIndex node = surface.vertex_node[v];
        if (node == kNoNode) {
            EXPECT_EQ(field.validity[v], Validity::Interpolated);
        } else {
            EXPECT_EQ(field.values[v], result.values[raw(node)]);
            EXPECT_EQ(field.validity[v], Validity::Solver);
        }
    }
    EXPECT_EQ(field.missing, 0U);
}

}  // namespace
}  // namespace feelem
