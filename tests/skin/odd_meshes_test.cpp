// SPDX-License-Identifier: Apache-2.0
// Meshes as they come: mixed, degenerate, listed twice, inside out, not matching.
#include "base/parallel.hpp"
#include "model/mesh_builder.hpp"
#include "support/meshes.hpp"
#include "support/skin_checks.hpp"
#include "support/threads.hpp"

#include "feelem/skin.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace feelem {
namespace {

struct Skinned {
    Surface surface;
    Diagnostics diagnostics;
};

Skinned skin_of(const Mesh& mesh, const SkinOptions& options = {}) {
    Skinned out;
    out.surface = make_skin(mesh, options, out.diagnostics);
    return out;
}

/// A unit cube (nodes 1..8), a node above it (9), a cube beside it (10..13) and on top of that a node (14).
const std::initializer_list<Point3> kNodes{
    {0, 0, 0},
    {1, 0, 0},
    {1, 1, 0},
    {0, 1, 0},
    {0, 0, 1},
    {1, 0, 1},
    {1, 1, 1},
    {0, 1, 1},
    {0.5, 0.5, 2},
    {2, 0, 0},
    {2, 1, 0},
    {2, 0, 1},
    {2, 1, 1},
    {1.5, 0.5, 2}};

TEST(MixedMesh, brick_pyramid_tetrahedron_and_wedge_match_across_types) {
    const Mesh mesh = test::tiny_mesh(
        kNodes,
        {{ElementType::Hex8, {1, 2, 3, 4, 5, 6, 7, 8}},
         {ElementType::Pyramid5, {5, 6, 7, 8, 9}},
         {ElementType::Tet4, {6, 14, 7, 9}},
         {ElementType::Wedge6, {2, 6, 10, 3, 7, 11}}}
    );

    const Surface surface = test::check_skin(mesh);

    // Hidden: brick-pyramid, pyramid-tet, brick-wedge.
    EXPECT_EQ(surface.report.solid_facets_kept, 6U + 5 + 4 + 5 - 6);
}

TEST(MixedMesh, random_subsets_of_a_grid_of_tetrahedra_and_bricks_agree_with_counting_owners) {
    std::mt19937 random(17);
    const Mesh full = test::brick_grid(5, 4, 4);
    for (int round = 0; round < 20; ++round) {
        Diagnostics diagnostics;
        MeshBuilder builder(diagnostics);
        for (std::size_t i = 0; i < full.node_count(); ++i)
            builder.add_node(full.node_ids[i], full.coordinates[i]);
        builder.seal_nodes();
        const ElementBlock& bricks = full.blocks.at(0);
        std::int64_t id = 0;
        const auto add = [&](ElementType type, std::size_t brick, std::initializer_list<int> corners) {
            std::vector<NodeId> ids;
            for (const int corner : corners)
                ids.push_back(full.node_ids[raw(bricks.nodes[brick * 8 + static_cast<std::size_t>(corner)])]);
            builder.add_element(ElementId{++id}, type, ids, builder.part("p"), [] { return ""; });
        };
        for (std::size_t i = 0; i < bricks.ids.size(); ++i) {
            switch (random() % 4) {
            case 0: add(ElementType::Hex8, i, {0, 1, 2, 3, 4, 5, 6, 7}); break;
            case 1:
                add(ElementType::Wedge6, i, {0, 1, 2, 4, 5, 6});
                if (random() % 2 == 0) add(ElementType::Wedge6, i, {0, 2, 3, 4, 6, 7});
                break;
            case 2:
                add(ElementType::Pyramid5, i, {0, 1, 2, 3, 6});
                if (random() % 2 == 0) add(ElementType::Tet4, i, {0, 1, 6, 5});
                break;
            default: break;
            }
        }
        const Mesh mesh = test::renumbered(builder.finish(), static_cast<unsigned>(round));

        const Surface surface = skin_of(mesh).surface;

        const auto owners = test::facet_owners(mesh);
        const auto outer = std::ranges::count_if(owners, [](const auto& facet) { return facet.second == 1; });
        EXPECT_EQ(surface.report.solid_facets_kept, static_cast<std::uint64_t>(outer)) << round;
        EXPECT_TRUE(surface.report.closed) << round;
        EXPECT_NEAR(surface.report.volume, test::volume_of_elements(mesh), 1e-9) << round;
    }
}

TEST(DegenerateElements, bricks_that_are_wedges_and_pyramids_match_real_neighbours) {
    // As Ansys writes them: a wedge as I J K K M N O O and a pyramid as I J K L M M M M.
    const Mesh mesh = test::tiny_mesh(
        kNodes,
        {{ElementType::Hex8, {1, 2, 3, 4, 5, 6, 7, 8}},
         {ElementType::Hex8, {5, 6, 7, 8, 9, 9, 9, 9}},
         {ElementType::Hex8, {2, 6, 10, 10, 3, 7, 11, 11}}}
    );

    EXPECT_EQ(test::check_skin(mesh).report.solid_facets_kept, 6U + 5 + 5 - 4);
}

TEST(DegenerateElements, a_brick_with_one_collapsed_edge_keeps_its_type_and_closes_its_skin) {
    // Corner 4 of the top falls onto corner 3 of it: two facets are triangles then.
    const Mesh mesh = test::tiny_mesh(
        kNodes,
        {{ElementType::Hex8, {1, 2, 3, 4, 5, 6, 7, 7}}, {ElementType::Hex8, {2, 10, 11, 3, 6, 12, 13, 7}}}
    );
    ASSERT_EQ(mesh.blocks.size(), 1U);

    const Surface surface = test::check_skin(mesh);

    EXPECT_EQ(surface.report.solid_facets_kept, 10U);
    EXPECT_EQ(surface.report.solid_tri_kept, 2U);
    EXPECT_EQ(surface.report.facets_collapsed, 0U);
}

TEST(DegenerateElements, a_facet_that_collapses_to_an_edge_is_no_facet) {
    // Both top corners fall onto the bottom ones: that facet is an edge, the brick is a wedge; and again with
    // mid-side nodes that repeat the corner, as Ansys writes them.
    Mesh mesh = test::one_element(ElementType::Hex20);
    std::vector<NodeIndex>& n = mesh.blocks[0].nodes;
    n[7] = n[3];
    n[6] = n[2];
    n[14] = n[10];
    n[18] = n[2];
    n[19] = n[3];

    const Surface surface = skin_of(mesh).surface;

    EXPECT_EQ(surface.report.facets_collapsed, 1U);
    EXPECT_EQ(surface.report.solid_tri_kept, 2U);
    EXPECT_EQ(surface.report.solid_quad_kept, 3U);
    EXPECT_TRUE(surface.report.closed);
    EXPECT_NEAR(surface.report.volume, test::volume_of_elements(mesh), 1e-12);
}

TEST(Duplicates, are_set_aside_and_leave_the_skin_as_it_is) {
    const Mesh mesh = test::brick_grid(3, 3, 3);
    const Surface once = skin_of(mesh).surface;
    for (const auto& [first, last] : {std::pair{0, 27}, {0, 1}, {13, 14}, {5, 9}}) {
        const auto count = static_cast<std::uint64_t>(last - first);
        const Skinned twice = skin_of(
            test::with_duplicates(mesh, static_cast<std::size_t>(first), static_cast<std::size_t>(last))
        );

        EXPECT_EQ(twice.surface.report.duplicate_elements, count);
        EXPECT_EQ(twice.diagnostics.count(Code::DuplicateElement), count);
        EXPECT_EQ(twice.surface.report.facets_of_duplicates, 6 * count);
        EXPECT_EQ(twice.surface.report.solid_facets_kept, once.report.solid_facets_kept);
        EXPECT_EQ(twice.surface.positions, once.positions);
        EXPECT_TRUE(twice.surface.report.closed);
    }
}

TEST(Duplicates, of_one_element_among_many_in_mirrored_order_are_set_aside) {
    Mesh mesh = test::with_duplicates(test::brick_grid(2, 2, 2), 3, 4);
    std::vector<NodeIndex>& nodes = mesh.blocks[0].nodes;
    std::swap_ranges(nodes.end() - 8, nodes.end() - 4, nodes.end() - 4);

    const Surface surface = skin_of(mesh).surface;

    EXPECT_EQ(surface.report.duplicate_elements, 1U);
    EXPECT_EQ(surface.report.solid_facets_kept, 24U);
    EXPECT_EQ(surface.report.inverted_elements, 0U);
    EXPECT_TRUE(surface.report.closed);
}

TEST(Duplicates, in_mirrored_order_do_not_swallow_the_element) {
    const Mesh mesh =
        test::tiny_mesh(kNodes, {{ElementType::Tet4, {1, 2, 4, 5}}, {ElementType::Tet4, {1, 4, 2, 5}}});

    const Surface surface = skin_of(mesh).surface;

    EXPECT_EQ(surface.report.duplicate_elements, 1U);
    EXPECT_EQ(surface.report.solid_facets_kept, 4U);
}

TEST(InvertedElements, are_reported_and_their_outer_facets_turned) {
    Mesh mesh = test::brick_grid(3, 1, 1);
    // The middle brick lists its top first.
    std::vector<NodeIndex>& nodes = mesh.blocks[0].nodes;
    std::swap_ranges(nodes.begin() + 8, nodes.begin() + 12, nodes.begin() + 12);

    const Skinned skin = skin_of(mesh);

    EXPECT_EQ(skin.surface.report.inverted_elements, 1U);
    EXPECT_EQ(skin.diagnostics.count(Code::InvertedElement), 1U);
    EXPECT_EQ(skin.surface.report.solid_facets_kept, 14U);
    EXPECT_TRUE(skin.surface.report.closed);
    EXPECT_NEAR(skin.surface.report.volume, 3, 1e-12);
    EXPECT_EQ(skin_of(test::mirrored(test::brick_grid(3, 3, 3))).surface.report.inverted_elements, 27U);
    EXPECT_EQ(skin_of(test::brick_grid(3, 3, 3)).surface.report.inverted_elements, 0U);
}

TEST(InvertedElements, an_inner_one_shows_by_its_neighbours) {
    Mesh mesh = test::brick_grid(3, 3, 3);
    std::vector<NodeIndex>& nodes = mesh.blocks[0].nodes;
    std::swap_ranges(nodes.begin() + 13 * 8, nodes.begin() + 13 * 8 + 4, nodes.begin() + 13 * 8 + 4);

    const Surface surface = skin_of(mesh).surface;

    EXPECT_EQ(surface.report.inverted_elements, 1U);
    EXPECT_EQ(surface.report.solid_facets_kept, 54U);
}

TEST(ManyOwners, a_facet_with_three_is_inner_and_reported) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0.3, 0.3, -2}},
        {{ElementType::Tet4, {1, 2, 3, 4}},
         {ElementType::Tet4, {1, 3, 2, 5}},
         {ElementType::Tet4, {1, 3, 2, 6}}}
    );

    const Skinned skin = skin_of(mesh);

    EXPECT_EQ(skin.surface.report.facets_many_owners, 3U);
    EXPECT_EQ(skin.diagnostics.count(Code::FacetWithManyOwners), 3U);
    EXPECT_EQ(skin.surface.report.solid_facets_kept, 9U);
    EXPECT_EQ(skin.surface.report.facets_inner, 0U);
    // One side of the three is left over.
    EXPECT_FALSE(skin.surface.report.closed);
}

TEST(ManyOwners, a_hundred_thousand_elements_on_one_facet_do_not_take_for_ever) {
    Mesh mesh =
        test::tiny_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{ElementType::Tet4, {1, 2, 3, 4}}});
    ElementBlock& block = mesh.blocks[0];
    for (std::uint32_t i = 1; i < 100'000; ++i) {
        mesh.node_ids.push_back(NodeId{4 + i});
        mesh.coordinates.push_back({0, 0, 1.0 + i});
        block.ids.push_back(ElementId{1 + i});
        block.parts.push_back(PartIndex{0});
        for (const std::uint32_t node : {0U, 1U, 2U, 3 + i}) block.nodes.push_back(NodeIndex{node});
    }

    const Surface surface = skin_of(mesh).surface;

    EXPECT_EQ(surface.report.facets_many_owners, 100'000U);
    EXPECT_EQ(surface.report.solid_facets_kept, 300'000U);
}

TEST(Unmatched, a_quad_facing_two_triangles_stays_with_them_and_is_reported) {
    const Mesh mesh = test::tiny_mesh(
        kNodes,
        {{ElementType::Hex8, {1, 2, 3, 4, 5, 6, 7, 8}},
         {ElementType::Tet4, {5, 6, 7, 9}},
         {ElementType::Tet4, {5, 7, 8, 9}}}
    );

    const Skinned skin = skin_of(mesh);

    EXPECT_EQ(skin.surface.report.unmatched_facets, 3U);
    EXPECT_EQ(skin.diagnostics.count(Code::UnmatchedFacets), 3U);
    EXPECT_EQ(skin.surface.report.solid_facets_kept, 6U + 8 - 2);
    EXPECT_TRUE(skin.surface.report.closed);
}

TEST(Unmatched, facets_with_other_mid_side_nodes_both_stay_and_are_reported) {
    // Two tet10 on the triangle 1 2 3; the second has a mid-side node of its own between 1 and 2.
    const std::vector<Point3> at{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
    const auto two_tets = [&](bool own_middle, bool left_out) {
        Diagnostics diagnostics;
        MeshBuilder builder(diagnostics);
        for (int i = 0; i < 5; ++i) builder.add_node(NodeId{i + 1}, at[static_cast<std::size_t>(i)]);
        for (int i = 6; i <= 20; ++i) builder.add_node(NodeId{i}, {0.1 * i, 0.2, 0.3});
        builder.seal_nodes();
        const auto id = [](int i) { return NodeId{i}; };
        const NodeId upper[]{id(1), id(2), id(3), id(4), id(6), id(7), id(8), id(9), id(10), id(11)};
        const int shared = own_middle ? 12 : (left_out ? 0 : 6);
        const NodeId lower[]{id(1), id(3), id(2), id(5), id(8), id(7), id(shared), id(13), id(14), id(15)};
        const PartIndex part = builder.part("p");
        builder.add_element(
            id(1) == id(1) ? ElementId{1} : ElementId{0}, ElementType::Tet10, upper, part, [] { return ""; }
        );
        builder.add_element(ElementId{2}, ElementType::Tet10, lower, part, [] { return ""; });
        return builder.finish();
    };

    EXPECT_EQ(skin_of(two_tets(false, false)).surface.report.solid_facets_kept, 6U);
    for (const bool left_out : {false, true}) {
        const Skinned skin = skin_of(two_tets(!left_out, left_out));
        EXPECT_EQ(skin.surface.report.solid_facets_kept, 8U);
        EXPECT_EQ(skin.surface.report.unmatched_facets, 2U);
        EXPECT_EQ(skin.diagnostics.count(Code::UnmatchedFacets), 2U);
    }
}

TEST(Unmatched, a_quadratic_element_may_leave_out_the_mid_side_nodes_towards_a_linear_one) {
    // The usual way to join orders: the tet10 on triangle 1 2 3 has no mid-side nodes there.
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, .5}, {.5, 0, .5}, {0, .5, .5}},
        {{ElementType::Tet10, {1, 2, 3, 4, 0, 0, 0, 6, 7, 8}}, {ElementType::Tet4, {1, 3, 2, 5}}}
    );

    const Surface surface = test::check_skin(mesh);

    EXPECT_EQ(surface.report.solid_facets_kept, 6U);
    EXPECT_EQ(surface.report.unmatched_facets, 0U);
}

TEST(MissingMiddles, get_a_vertex_without_a_node_halfway_between_the_corners) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, -.25, 0}, {1.25, 1.25, 0}},
        {{ElementType::Tri6, {1, 2, 3, 4, 5, 0}}}
    );

    const Surface surface = skin_of(mesh).surface;

    EXPECT_EQ(surface.report.triangles, 4U);
    EXPECT_EQ(surface.report.vertices, 5U);
    ASSERT_EQ(surface.blends.size(), 1U);
    const Blend& blend = surface.blends[0];
    EXPECT_EQ(surface.vertex_node[raw(blend.vertex)], kNoNode);
    EXPECT_EQ(surface.positions[raw(blend.vertex)], (Point3{0, 1, 0}));
    EXPECT_THAT(surface.blend_weights, testing::ElementsAre(0.5, 0.5));
}

TEST(MissingMiddles, of_a_quad_are_taken_as_halfway_in_its_centre) {
    // Serendipity centre: -1/4 corners + 1/2 middles, with the middle of 3-4 at (1, 2).
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 1}, {2, 1, 0}, {0, 1, 0}},
        {{ElementType::Quad8, {1, 2, 3, 4, 5, 6, 0, 7}}}
    );

    const Surface surface = skin_of(mesh).surface;

    ASSERT_EQ(surface.blends.size(), 2U);
    const Blend& centre = surface.blends[1];
    EXPECT_EQ(surface.positions[raw(centre.vertex)], (Point3{1, 1, 0.5}));
    double sum = 0;
    for (std::uint32_t i = centre.first; i < centre.first + centre.count; ++i) {
        EXPECT_NE(surface.vertex_node[raw(surface.blend_sources[i])], kNoNode);
        sum += surface.blend_weights[i];
    }
    EXPECT_EQ(sum, 1);
}

TEST(Skin, facets_at_nodes_without_coordinates_are_left_out_and_reported) {
    Mesh mesh = test::brick_grid(1, 1, 1);
    mesh.coordinates[0][1] = std::numeric_limits<double>::quiet_NaN();

    const Skinned skin = skin_of(mesh);

    EXPECT_EQ(skin.surface.report.triangles, 12U);
    EXPECT_EQ(skin.diagnostics.count(Code::UnknownNode), 3U);
}

TEST(Skin, solids_and_shells_of_two_parts_become_a_part_each) {
    const Mesh mesh = test::tiny_mesh(
        kNodes,
        {{ElementType::Quad4, {5, 6, 7, 8}, "b"},
         {ElementType::Hex8, {2, 10, 11, 3, 6, 12, 13, 7}, "b"},
         {ElementType::Hex8, {1, 2, 3, 4, 5, 6, 7, 8}, "a"},
         {ElementType::Line2, {9, 14}, "a"}}
    );

    const Surface surface = skin_of(mesh).surface;

    // Part 0 is b, the first one named.
    ASSERT_EQ(surface.parts.size(), 4U);
    const auto is = [&](std::size_t i, std::uint32_t part, PartKind kind) {
        return surface.parts[i].part == PartIndex{part} && surface.parts[i].kind == kind;
    };
    EXPECT_TRUE(is(0, 0, PartKind::Solid));
    EXPECT_TRUE(is(1, 0, PartKind::Shell));
    EXPECT_TRUE(is(2, 1, PartKind::Solid));
    EXPECT_TRUE(is(3, 1, PartKind::Beam));
    EXPECT_EQ(surface.report.solid_facets_kept, 10U);
    EXPECT_EQ(surface.report.triangles, 4U * 11);
    // Each part has the four nodes of the facet between the bricks.
    EXPECT_EQ(surface.report.vertices, 8U + 2 + 8);
    EXPECT_TRUE(surface.report.closed);
    EXPECT_DOUBLE_EQ(surface.report.area, 11);
}

TEST(Glyphs, a_beam_is_a_thin_tube_whose_vertices_are_its_nodes) {
    const Mesh mesh =
        test::tiny_mesh({{0, 0, 0}, {0, 0, 10}, {0, 0.1, 5}}, {{ElementType::Line3, {1, 2, 3}}});

    const Surface surface = skin_of(mesh).surface;

    ASSERT_EQ(surface.parts.size(), 1U);
    EXPECT_EQ(surface.parts[0].kind, PartKind::Beam);
    EXPECT_EQ(surface.positions.size(), 18U);
    EXPECT_EQ(surface.triangles.size(), 24U);
    EXPECT_EQ(surface.report.triangles, 0U);
    EXPECT_EQ(surface.report.vertices, 0U);
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const Point3& node = mesh.coordinates[raw(surface.vertex_node[v])];
        const Point3& at = surface.positions[v];
        EXPECT_NEAR(std::hypot(at[0] - node[0], at[1] - node[1], at[2] - node[2]), 0.04, 1e-12);
    }
    for (const auto& t : surface.triangles) {
        const Point3 &a = surface.positions[raw(t[0])], &b = surface.positions[raw(t[1])],
                     &c = surface.positions[raw(t[2])];
        const double nx = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
        const double ny = (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]);
        const auto& normal = surface.normals[raw(t[0])];
        EXPECT_GT(nx * double(normal[0]) + ny * double(normal[1]), 0);
    }
}

TEST(Glyphs, points_are_drawn_only_where_there_is_nothing_else) {
    const Mesh alone = test::tiny_mesh({{0, 0, 0}, {1, 2, 3}}, {{ElementType::Point1, {2}}});
    const Surface surface = skin_of(alone).surface;
    ASSERT_EQ(surface.parts.size(), 1U);
    EXPECT_EQ(surface.parts[0].kind, PartKind::Point);
    EXPECT_EQ(surface.triangles.size(), 8U);
    EXPECT_THAT(surface.vertex_node, testing::Each(NodeIndex{1}));

    const Mesh beside =
        test::tiny_mesh(kNodes, {{ElementType::Tet4, {1, 2, 4, 5}}, {ElementType::Point1, {9}}});
    const Skinned skin = skin_of(beside);
    EXPECT_EQ(skin.surface.parts.size(), 1U);
    EXPECT_EQ(skin.diagnostics.count(Code::SkippedElement), 1U);
}

void expect_same(const Surface& one, const Surface& other) {
    ASSERT_EQ(one.report.solid_facets_kept, other.report.solid_facets_kept);
    ASSERT_TRUE(one.positions == other.positions);
    ASSERT_TRUE(one.normals == other.normals);
    ASSERT_TRUE(one.triangles == other.triangles);
    ASSERT_TRUE(one.edges == other.edges);
    ASSERT_TRUE(one.triangle_element == other.triangle_element);
}

/// Many chunks of 16,384 elements.
Mesh many_bricks() {
    return test::brick_grid(60, 40, 30);
}

TEST(Skin, is_the_same_whatever_the_number_of_threads) {
    // In the second one chunks meet at nodes everywhere.
    for (const Mesh& mesh : {many_bricks(), test::renumbered(many_bricks(), 1)}) {
        set_thread_count(1);
        const Surface one = skin_of(mesh).surface;
        set_thread_count(0);
        EXPECT_EQ(one.report.solid_facets_kept, 2U * (60 * 40 + 40 * 30 + 60 * 30));
        expect_same(one, skin_of(mesh).surface);
    }
}

TEST(Skin, is_the_same_while_threads_come_and_go) {
    const Mesh mesh = test::renumbered(many_bricks(), 1);
    const Surface still = skin_of(mesh).surface;
    const test::ThreadsComeAndGo changing;
    for (int i = 0; i < 30; ++i) expect_same(still, skin_of(mesh).surface);
}

}  // namespace
}  // namespace feelem
