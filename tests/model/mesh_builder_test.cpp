// SPDX-License-Identifier: Apache-2.0
#include "model/collapse.hpp"
#include "model/mesh_builder.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace feelem {
namespace {

TEST(MeshBuilder, sorts_nodes_by_id_and_keeps_the_later_of_two_definitions) {
    Diagnostics diagnostics;
    MeshBuilder builder(diagnostics);
    builder.add_node(NodeId{9}, {9, 0, 0});
    builder.add_node(NodeId{2}, {2, 0, 0});
    builder.add_node(NodeId{9}, {99, 0, 0});
    builder.seal_nodes();

    const Mesh mesh = builder.finish();

    EXPECT_EQ(mesh.node_ids, (std::vector{NodeId{2}, NodeId{9}}));
    EXPECT_EQ(mesh.coordinates[1][0], 99);
    EXPECT_TRUE(diagnostics.has(Code::DuplicateNode));
}

TEST(MeshBuilder, an_element_with_an_unknown_node_is_left_out_and_reported) {
    Diagnostics diagnostics;
    const Mesh mesh =
        test::tiny_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{ElementType::Tri3, {1, 2, 77}}}, diagnostics);

    EXPECT_EQ(mesh.element_count(), 0U);
    EXPECT_EQ(diagnostics.count(Code::UnknownNode), 1U);
}

TEST(MeshBuilder, a_quadratic_row_without_any_mid_side_node_is_linear) {
    const Mesh mesh =
        test::tiny_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{ElementType::Tet10, {1, 2, 3, 4}}});

    EXPECT_EQ(mesh.blocks.at(0).type, ElementType::Tet4);
}

TEST(MeshBuilder, a_left_out_mid_side_node_is_kept_as_missing_and_reported) {
    Diagnostics diagnostics;
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.5, 0, 0}}, {{ElementType::Tri6, {1, 2, 3, 4, 0}}}, diagnostics
    );

    ASSERT_EQ(mesh.blocks.at(0).type, ElementType::Tri6);
    EXPECT_EQ(mesh.blocks[0].nodes[3], NodeIndex{3});
    EXPECT_EQ(mesh.blocks[0].nodes[4], kNoNode);
    EXPECT_EQ(diagnostics.count(Code::MissingMidside), 2U);
}

double volume(ElementType type, std::span<const NodeIndex> nodes, std::span<const Point3> at) {
    double sum = 0;
    for (const FacetRow& facet : facets_of(type)) {
        const auto corners = facet_corners(facet);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            const Point3 &a = at[raw(nodes[corners[0]])], &b = at[raw(nodes[corners[i]])],
                         &c = at[raw(nodes[corners[i + 1]])];
            sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                    a[2] * (b[0] * c[1] - b[1] * c[0])) /
                   6;
        }
    }
    return sum;
}

struct Pattern {
    const char* name;
    std::vector<std::uint32_t> corners;  // of the unit cube's eight
    ElementType expected;
    double expected_volume;
};

TEST(Collapse, any_pattern_of_repeats_gives_the_shape_that_is_there) {
    const ElementRow& cube = element_row(ElementType::Hex8);
    std::vector<Point3> at;
    for (std::size_t i = 0; i < 8; ++i)
        at.push_back({cube.reference[i][0], cube.reference[i][1], cube.reference[i][2]});
    const Pattern patterns[]{
        {"Ansys wedge K=L O=P", {0, 1, 2, 2, 4, 5, 6, 6}, ElementType::Wedge6, 0.5},
        {"Ansys pyramid M=N=O=P", {0, 1, 2, 3, 4, 4, 4, 4}, ElementType::Pyramid5, 1.0 / 3},
        {"Ansys tet", {0, 1, 2, 2, 4, 4, 4, 4}, ElementType::Tet4, 1.0 / 6},
        {"wedge with I=J M=N", {0, 0, 2, 3, 4, 4, 6, 7}, ElementType::Wedge6, 0.5},
        {"wedge lying down I=M L=P", {0, 1, 2, 3, 0, 5, 6, 3}, ElementType::Wedge6, 0.5},
        {"tet with I=J", {0, 0, 1, 2, 4, 4, 4, 4}, ElementType::Tet4, 1.0 / 6},
    };
    for (const Pattern& pattern : patterns) {
        std::vector<NodeIndex> nodes;
        for (const std::uint32_t corner : pattern.corners) nodes.push_back(NodeIndex{corner});

        const auto collapsed = collapse(ElementType::Hex8, nodes);

        ASSERT_TRUE(collapsed.has_value()) << pattern.name;
        EXPECT_EQ(collapsed->type, pattern.expected) << pattern.name;
        EXPECT_NEAR(volume(collapsed->type, collapsed->nodes, at), pattern.expected_volume, 1e-12)
            << pattern.name;
    }
}

TEST(Collapse, a_brick_with_one_collapsed_edge_stays_a_brick) {
    const std::vector<NodeIndex> nodes{
        NodeIndex{0},
        NodeIndex{1},
        NodeIndex{2},
        NodeIndex{2},
        NodeIndex{4},
        NodeIndex{5},
        NodeIndex{6},
        NodeIndex{7}};

    EXPECT_FALSE(collapse(ElementType::Hex8, nodes).has_value());
}

TEST(Collapse, the_20_node_rows_that_ansys_writes_keep_their_mid_side_nodes) {
    // I J K K M N O O | Q R K T U V O X Y Z A A: letters as numbers, I=0 .. P=7, Q=8 ..
    const auto n = [](std::uint32_t i) { return NodeIndex{i}; };
    const std::vector<NodeIndex> wedge{n(0), n(1),  n(2),  n(2),  n(4), n(5),  n(6),  n(6),  n(8),  n(9),
                                       n(2), n(11), n(12), n(13), n(6), n(15), n(16), n(17), n(18), n(18)};

    const auto collapsed = collapse(ElementType::Hex20, wedge);

    ASSERT_TRUE(collapsed.has_value());
    ASSERT_EQ(collapsed->type, ElementType::Wedge15);
    for (const EdgeRow& edge : edges_of(ElementType::Wedge15)) {
        EXPECT_NE(collapsed->nodes[edge.middle], kNoNode);
    }
    const std::vector<NodeIndex> tet{n(0), n(1),  n(2), n(2), n(4), n(4), n(4),  n(4),  n(8),  n(9),
                                     n(2), n(11), n(4), n(4), n(4), n(4), n(16), n(17), n(18), n(18)};
    const auto small = collapse(ElementType::Hex20, tet);
    ASSERT_TRUE(small.has_value());
    ASSERT_EQ(small->type, ElementType::Tet10);
    for (const EdgeRow& edge : edges_of(ElementType::Tet10)) EXPECT_NE(small->nodes[edge.middle], kNoNode);
}

TEST(Collapse, a_quad_with_its_last_node_repeated_is_a_triangle_and_reported) {
    Diagnostics diagnostics;
    const Mesh mesh =
        test::tiny_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{ElementType::Quad4, {1, 2, 3, 3}}}, diagnostics);

    EXPECT_EQ(mesh.blocks.at(0).type, ElementType::Tri3);
    EXPECT_EQ(diagnostics.count(Code::DegenerateElement), 1U);
}

TEST(NodeLookup, finds_ids_whether_dense_or_sparse) {
    const std::vector<NodeId> consecutive{NodeId{5}, NodeId{6}, NodeId{7}};
    const std::vector<NodeId> dense{NodeId{5}, NodeId{7}, NodeId{9}};
    const std::vector<NodeId> sparse{NodeId{-3}, NodeId{7}, NodeId{2'000'000'000'000}};
    for (const auto* ids : {&consecutive, &dense, &sparse}) {
        const NodeLookup lookup(*ids);
        for (std::size_t i = 0; i < ids->size(); ++i)
            EXPECT_EQ(lookup((*ids)[i]), NodeIndex{static_cast<std::uint32_t>(i)});
        EXPECT_EQ(lookup(NodeId{8}), kNoNode);
        EXPECT_EQ(lookup(NodeId{-100}), kNoNode);
    }
}

TEST(NodeLookup, finds_many_as_it_finds_each) {
    std::mt19937 random(5);
    const std::vector<std::vector<NodeId>> sets{
        {NodeId{7}, NodeId{8}, NodeId{9}, NodeId{10}},
        {NodeId{2}, NodeId{3}, NodeId{5}, NodeId{9}},
        {NodeId{1}, NodeId{500}, NodeId{90'000}},
        {}};
    for (const auto& ids : sets) {
        const NodeLookup lookup(ids);
        for (int i = 0; i < 2000; ++i) {
            std::vector<std::int64_t> wanted;
            for (int k = 0; k < 3; ++k) wanted.push_back(static_cast<std::int64_t>(random() % 13) - 1);
            std::vector<NodeIndex> each, many(wanted.size());
            for (const std::int64_t id : wanted) each.push_back(lookup(NodeId{id}));
            const bool all = std::ranges::find(each, kNoNode) == each.end();
            ASSERT_EQ(lookup.find(wanted, many.data()), all);
            if (all) {
                ASSERT_EQ(many, each);
            }
            std::vector<std::uint32_t> small;
            std::vector<NodeIndex> again(wanted.size());
            for (const std::int64_t id : wanted) small.push_back(static_cast<std::uint32_t>(id));
            ASSERT_EQ(lookup.find(small, again.data()), all);
            if (all) {
                ASSERT_EQ(again, each);
            }
        }
    }
}

TEST(NodeLookup, finds_short_ids_as_it_finds_long_ones) {
    constexpr std::int64_t kLast = 0xFFFF'FFFF;
    const std::vector<std::vector<NodeId>> sets{
        {NodeId{7}, NodeId{8}, NodeId{9}, NodeId{10}},
        {NodeId{kLast - 1}, NodeId{kLast}},
        {NodeId{kLast}, NodeId{kLast + 1}},
        {NodeId{-1}, NodeId{0}, NodeId{1}},
        {NodeId{1}, NodeId{500}}};
    for (const auto& ids : sets) {
        const NodeLookup lookup(ids);
        for (const std::int64_t id :
             {std::int64_t{0},
              std::int64_t{1},
              std::int64_t{6},
              std::int64_t{8},
              std::int64_t{11},
              kLast - 2,
              kLast - 1,
              kLast}) {
            const std::array<std::uint32_t, 1> wanted{static_cast<std::uint32_t>(id)};
            std::array<NodeIndex, 1> found{};
            const NodeIndex expected = lookup(NodeId{id});
            ASSERT_EQ(lookup.find(wanted, found.data()), expected != kNoNode) << id;
            if (expected != kNoNode) {
                EXPECT_EQ(found[0], expected) << id;
            }
        }
    }
}

TEST(NodeLookup, small_ids_are_none_of_large_ones) {
    std::vector<NodeId> ids;
    for (std::int64_t id = 0xFFFFFFF0; id < 0x100000010; ++id) ids.push_back(NodeId{id});
    const NodeLookup lookup(ids);
    NodeIndex found{};
    for (const std::uint32_t id : {0U, 5U, 15U, 16U, 100U})
        EXPECT_FALSE(lookup.find(std::span(&id, 1), &found)) << id;
    const std::uint32_t large = 0xFFFFFFF3;
    ASSERT_TRUE(lookup.find(std::span(&large, 1), &found));
    EXPECT_EQ(found, NodeIndex{3});
}

TEST(Collapse, repeated_corners_are_noticed_wherever_they_stand) {
    std::vector<NodeIndex> corners;
    for (std::uint32_t i = 0; i < 8; ++i) corners.push_back(NodeIndex{100 * i});
    EXPECT_TRUE(all_differ(corners));
    for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            auto repeated = corners;
            repeated[i] = repeated[j];
            EXPECT_FALSE(all_differ(repeated)) << i << ' ' << j;
        }
    }
}

TEST(Collapse, corners_compared_at_once_are_the_same_as_one_by_one) {
    std::mt19937 random(8);
    for (int round = 0; round < 20'000; ++round) {
        std::vector<NodeIndex> corners;
        const std::size_t count = 3 + random() % 6;
        for (std::size_t i = 0; i < count; ++i)
            corners.push_back(NodeIndex{static_cast<std::uint32_t>(random() % 40)});
        const std::set<NodeIndex> different(corners.begin(), corners.end());
        ASSERT_EQ(all_differ(corners), different.size() == corners.size());
    }
}

/// The mesh of rows of nodes, added one by one or all together, and what was said.
std::string mesh_of_rows(ElementType type, const std::vector<std::uint32_t>& nodes, bool together) {
    Diagnostics diagnostics;
    MeshBuilder builder(diagnostics);
    // Zero is a node's number too, but in a row it says that a node is left out.
    for (int id = 0; id <= 60; ++id) {
        if (id == 0 || id % 9 != 0) builder.add_node(NodeId{id}, {1.0 * id, 0, 0});
    }
    builder.seal_nodes();
    const std::size_t width = element_row(type).node_count;
    std::vector<ElementId> ids;
    for (std::size_t row = 0; row * width < nodes.size(); ++row)
        ids.push_back(ElementId{static_cast<int>(row) + 1});
    const auto where = [](std::size_t row) { return "row " + std::to_string(row); };
    const PartIndex part = builder.part("one");
    if (together) builder.add_elements(type, part, ids, nodes, where);
    for (std::size_t row = 0; row < ids.size() && !together; ++row) {
        std::vector<NodeId> given;
        for (std::size_t i = 0; i < width; ++i) given.push_back(NodeId{nodes[row * width + i]});
        builder.add_element(ids[row], type, given, part, [&] { return where(row); });
    }
    const Mesh mesh = builder.finish();
    std::string text;
    for (const ElementBlock& block : mesh.blocks) {
        text += std::string(element_row(block.type).name) + ":";
        for (const ElementId id : block.ids) text += ' ' + std::to_string(raw(id));
        for (const NodeIndex node : block.nodes) text += ' ' + std::to_string(raw(node));
    }
    for (const Diagnostic& one : diagnostics.entries())
        text += one.where + one.text + std::to_string(one.count);
    return text;
}

TEST(MeshBuilder, rows_added_together_are_what_they_are_one_by_one) {
    std::mt19937 random(9);
    for (const ElementType type :
         {ElementType::Hex8, ElementType::Tet10, ElementType::Quad4, ElementType::Line2}) {
        const std::size_t width = element_row(type).node_count;
        // Some rows repeat nodes, leave one out, or name one that is not there.
        for (const std::uint32_t most : {8U, 60U}) {
            std::vector<std::uint32_t> nodes;
            for (std::size_t i = 0; i < 9000; ++i) {
                for (std::size_t k = 0; k < width; ++k) {
                    const auto usual = static_cast<std::uint32_t>(1 + (i + k) % 8);
                    nodes.push_back(random() % 50 == 0 ? static_cast<std::uint32_t>(random() % most) : usual);
                }
            }
            const std::string together = mesh_of_rows(type, nodes, true);
            EXPECT_EQ(together, mesh_of_rows(type, nodes, false));
            if (most > 8) {
                EXPECT_NE(together.find("row "), std::string::npos);
            }
        }
    }
}

TEST(Collapse, repeated_corners_are_noticed_in_every_row) {
    for (const std::size_t corners : {3U, 4U, 6U, 8U}) {
        constexpr std::size_t kRows = 5;
        const std::size_t width = corners + 2;
        std::vector<NodeIndex> rows;
        // Corners are there again in other rows, and behind the corners of their own.
        for (std::size_t i = 0; i < kRows * width; ++i)
            rows.push_back(NodeIndex{static_cast<std::uint32_t>(i % width % corners)});
        EXPECT_TRUE(all_differ_in_rows(rows, width, corners));
        EXPECT_TRUE(all_differ_in_rows({}, width, corners));
        for (std::size_t row = 0; row < kRows; ++row) {
            for (std::size_t i = 0; i < corners; ++i) {
                auto repeated = rows;
                repeated[row * width + i] = rows[row * width + (i + 1) % corners];
                EXPECT_FALSE(all_differ_in_rows(repeated, width, corners)) << corners << ' ' << row;
            }
        }
    }
}

}  // namespace
}  // namespace feelem
