// SPDX-License-Identifier: Apache-2.0
// Vertices, normals, edges and centres of the skin, and the paper's node map.
#include "support/meshes.hpp"

#include "feelem/error.hpp"
#include "feelem/skin.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace feelem {
namespace {

Surface skin_of(const Mesh& mesh, const SkinOptions& options = {}) {
    Diagnostics diagnostics;
    return make_skin(mesh, options, diagnostics);
}

std::size_t vertices_with_node(const Surface& surface) {
    return surface.vertex_node.size() -
           static_cast<std::size_t>(std::ranges::count(surface.vertex_node, kNoNode));
}

double dot(const std::array<float, 3>& a, const std::array<float, 3>& b) {
    return double(a[0]) * double(b[0]) + double(a[1]) * double(b[1]) + double(a[2]) * double(b[2]);
}

TEST(Creases, a_cube_has_a_vertex_for_each_side_at_its_corners) {
    const Surface surface = skin_of(test::brick_grid(2, 2, 2));

    // 8 corners x 3 + 12 edges x 2 + 6 sides x 1, and a centre for each of 24 facets.
    EXPECT_EQ(vertices_with_node(surface), 8U * 3 + 12 * 2 + 6);
    EXPECT_EQ(surface.positions.size(), 54U + 24);
    EXPECT_EQ(surface.report.vertices, 26U);
    for (const auto& normal : surface.normals)
        EXPECT_EQ(std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]), 1);
}

TEST(Creases, above_the_angle_of_the_edges_there_are_none) {
    SkinOptions options;
    options.crease_angle = 91;
    const Surface surface = skin_of(test::brick_grid(1, 1, 1), options);

    EXPECT_EQ(vertices_with_node(surface), 8U);
    // The normal at a corner of a cube weighs its three sides alike, however they are cut.
    for (std::size_t v = 0; v < 8; ++v) {
        if (surface.vertex_node[v] == kNoNode) continue;
        for (const float component : surface.normals[v])
            EXPECT_NEAR(std::abs(double(component)), 1 / std::sqrt(3.0), 1e-7);
    }
}

/// A quarter of a pipe of one quadratic element: 90 degrees in one curved facet, mid-side nodes on the
/// circle.
Mesh curved_pipe(int elements) {
    Mesh mesh;
    // Shells: Quad8 along the circle of radius 1, height 1.
    const double step = 2 * 3.14159265358979323846 / elements;
    ElementBlock block;
    block.type = ElementType::Quad8;
    const auto node = [&](int half_steps, int level) {
        return NodeIndex{static_cast<std::uint32_t>(3 * (half_steps % (2 * elements)) + level)};
    };
    for (int i = 0; i < 2 * elements; ++i) {
        for (int level = 0; level < 3; ++level) {
            mesh.node_ids.push_back(NodeId{3 * i + level + 1});
            mesh.coordinates.push_back({std::cos(i * step / 2), std::sin(i * step / 2), level * 0.5});
        }
    }
    for (int i = 0; i < elements; ++i) {
        const int a = 2 * i;
        block.ids.push_back(ElementId{i + 1});
        block.parts.push_back(PartIndex{0});
        for (const NodeIndex n :
             {node(a, 0),
              node(a + 2, 0),
              node(a + 2, 2),
              node(a, 2),
              node(a + 1, 0),
              node(a + 2, 1),
              node(a + 1, 2),
              node(a, 1)})
            block.nodes.push_back(n);
    }
    mesh.blocks.push_back(block);
    mesh.parts.push_back({"pipe"});
    return mesh;
}

TEST(Creases, a_curved_wall_of_few_quadratic_facets_is_smooth) {
    // Facets turn by 45 degrees each, but their curved sides meet at 22.5.
    const Surface surface = skin_of(curved_pipe(8));

    EXPECT_EQ(vertices_with_node(surface), 8U * 5);
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        if (surface.vertex_node[v] == kNoNode) continue;
        const Point3& at = surface.positions[v];
        EXPECT_GT(dot(surface.normals[v], {static_cast<float>(at[0]), static_cast<float>(at[1]), 0}), 0.999);
    }
}

TEST(Creases, shells_that_wind_against_each_other_do_not_share_vertices) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
        {{ElementType::Quad4, {1, 2, 3, 4}}, {ElementType::Quad4, {2, 3, 6, 5}}}
    );

    SkinOptions options;
    options.crease_angle = 180;
    const Surface surface = skin_of(mesh, options);

    EXPECT_EQ(vertices_with_node(surface), 8U);
    EXPECT_EQ(surface.report.vertices, 6U);
}

TEST(Edges, are_the_elements_edges_once_each) {
    const Surface surface = skin_of(test::brick_grid(2, 1, 1));

    EXPECT_EQ(surface.edges.size(), 20U);
    std::set<std::pair<NodeIndex, NodeIndex>> seen;
    for (const auto& [a, b] : surface.edges) {
        const NodeIndex first = surface.vertex_node[raw(a)], second = surface.vertex_node[raw(b)];
        ASSERT_NE(first, kNoNode);
        ASSERT_NE(second, kNoNode);
        EXPECT_TRUE(seen.insert(std::minmax(first, second)).second);
        const Point3 &p = surface.positions[raw(a)], &q = surface.positions[raw(b)];
        EXPECT_EQ(std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]), 1);
    }
}

TEST(Edges, of_quadratic_elements_are_bent_through_their_mid_side_nodes) {
    const Surface surface = skin_of(test::one_element(ElementType::Hex20));

    EXPECT_EQ(surface.edges.size(), 24U);
    for (const auto& [a, b] : surface.edges) {
        const bool first_is_middle = raw(surface.vertex_node[raw(a)]) >= 8;
        const bool second_is_middle = raw(surface.vertex_node[raw(b)]) >= 8;
        EXPECT_NE(first_is_middle, second_is_middle);
    }
}

TEST(Edges, belong_to_the_part_whose_vertices_they_join) {
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
        {{ElementType::Quad4, {1, 2, 3, 4}, "a"}, {ElementType::Quad4, {2, 5, 6, 3}, "b"}}
    );

    const Surface surface = skin_of(mesh);

    ASSERT_EQ(surface.parts.size(), 2U);
    for (const SurfacePart& part : surface.parts) {
        EXPECT_EQ(part.edge_count, 4U);
        for (std::uint32_t i = part.first_edge; i < part.first_edge + part.edge_count; ++i) {
            for (const VertexIndex v : surface.edges[i]) {
                EXPECT_GE(raw(v), part.first_vertex);
                EXPECT_LT(raw(v), part.first_vertex + part.vertex_count);
            }
        }
    }
}

TEST(Centres, follow_the_shape_of_the_facet) {
    // A quad8 whose middles are lifted by 1: its serendipity centre is lifted by 2.
    const Mesh quad8 = test::tiny_mesh(
        {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 1}, {2, 1, 1}, {1, 2, 1}, {0, 1, 1}},
        {{ElementType::Quad8, {1, 2, 3, 4, 5, 6, 7, 8}}}
    );
    const Surface surface = skin_of(quad8);
    ASSERT_EQ(surface.blends.size(), 1U);
    EXPECT_EQ(surface.positions[raw(surface.blends[0].vertex)], (Point3{1, 1, 2}));

    const Surface quad9 = skin_of(test::one_element(ElementType::Quad9));
    EXPECT_TRUE(quad9.blends.empty());
    EXPECT_EQ(quad9.report.vertices, 9U);

    SkinOptions corners_only;
    corners_only.subdivide = 0;
    const Surface flat = skin_of(quad8, corners_only);
    EXPECT_EQ(flat.report.triangles, 4U);
    EXPECT_EQ(flat.report.vertices, 4U);
    EXPECT_EQ(flat.positions[raw(flat.blends.at(0).vertex)], (Point3{1, 1, 0}));
}

SkinOptions cut(unsigned subdivide) {
    SkinOptions options;
    options.subdivide = subdivide;
    return options;
}

TEST(Subdivide, cuts_each_edge_of_a_quadratic_facet_into_a_power_of_two) {
    const auto triangles = [](ElementType type, unsigned subdivide) {
        return skin_of(test::one_element(type), cut(subdivide)).report.triangles;
    };
    for (const ElementType type : {ElementType::Tri6, ElementType::Quad8, ElementType::Quad9}) {
        const std::uint64_t coarse = triangles(type, 1);
        EXPECT_EQ(triangles(type, 2), 4 * coarse);
        EXPECT_EQ(triangles(type, 3), 16 * coarse);
    }
    EXPECT_EQ(triangles(ElementType::Quad4, 3), 4U);
    EXPECT_EQ(skin_of(test::one_element(ElementType::Quad8), cut(3)).edges.size(), 4U * 8);
    EXPECT_EQ(skin_of(test::one_element(ElementType::Tri6), cut(2)).report.vertices, 6U);
}

TEST(Subdivide, follows_the_shape_functions) {
    // z = x² - y² + x y, which the 6- and 9-node functions hold exactly, and the 8-node ones too.
    const auto height = [](double x, double y) { return x * x - y * y + x * y; };
    for (const ElementType type : {ElementType::Tri6, ElementType::Quad8, ElementType::Quad9}) {
        Mesh mesh = test::one_element(type);
        for (Point3& at : mesh.coordinates) at[2] = height(at[0], at[1]);

        const Surface surface = skin_of(mesh, cut(3));

        EXPECT_GT(surface.blends.size(), 30U);
        for (const Point3& at : surface.positions) EXPECT_NEAR(at[2], height(at[0], at[1]), 1e-15);
        for (const Blend& blend : surface.blends) {
            double sum = 0;
            for (std::uint32_t i = blend.first; i < blend.first + blend.count; ++i) {
                EXPECT_NE(surface.vertex_node[raw(surface.blend_sources[i])], kNoNode);
                sum += surface.blend_weights[i];
            }
            EXPECT_EQ(sum, 1);
        }
        for (const auto& [a, b, c] : surface.triangles) {
            const Point3 &p = surface.positions[raw(a)], &q = surface.positions[raw(b)],
                         &r = surface.positions[raw(c)];
            EXPECT_GT((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]), 0);
        }
        for (const auto& [a, b] : surface.edges) {
            const Point3 &p = surface.positions[raw(a)], &q = surface.positions[raw(b)];
            EXPECT_LE(std::hypot(p[0] - q[0], p[1] - q[1]), 0.125 * std::sqrt(2.0) + 1e-12);
        }
    }
}

TEST(Subdivide, neighbours_put_the_same_points_on_their_edge) {
    const Surface surface = skin_of(curved_pipe(8), cut(3));
    std::map<std::pair<Point3, Point3>, int> balance;
    for (const auto& t : surface.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point3& a = surface.positions[raw(t[k])];
            const Point3& b = surface.positions[raw(t[(k + 1) % 3])];
            ++balance[{a, b}];
            --balance[{b, a}];
        }
    }
    // Only the two rims are open: 8 facets with 8 pieces each, both ways.
    EXPECT_EQ(std::ranges::count_if(balance, [](const auto& side) { return side.second != 0; }), 2 * 2 * 64);
}

TEST(Subdivide, beyond_reason_is_refused) {
    EXPECT_THROW(skin_of(test::one_element(ElementType::Tri6), cut(7)), Error);
}

TEST(ElementNode, no_vertex_is_shared_by_two_elements) {
    SkinOptions options;
    options.domain = Domain::ElementNode;
    const Mesh mesh = test::brick_grid(3, 2, 1);
    const Surface surface = skin_of(mesh, options);

    ASSERT_EQ(surface.vertex_element.size(), surface.positions.size());
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        for (const VertexIndex v : surface.triangles[i])
            EXPECT_EQ(surface.vertex_element[raw(v)], surface.triangle_element[i]);
    }
    const Surface shared = skin_of(mesh);
    EXPECT_EQ(surface.report.vertices, shared.report.vertices);
    EXPECT_EQ(surface.report.triangles, shared.report.triangles);
    EXPECT_TRUE(surface.report.closed);
    EXPECT_TRUE(shared.vertex_element.empty());
    // Flat colours, but the same smooth shading: sides are still plane.
    for (const auto& normal : surface.normals)
        EXPECT_EQ(std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]), 1);
}

TEST(ElementNode, vertices_are_unique_within_an_element_where_it_is_smooth) {
    SkinOptions options;
    options.domain = Domain::ElementNode;
    const Surface surface = skin_of(
        test::tiny_mesh(
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
            {{ElementType::Quad4, {1, 2, 3, 4}}, {ElementType::Quad4, {2, 5, 6, 3}}}
        ),
        options
    );

    EXPECT_EQ(vertices_with_node(surface), 8U);
    EXPECT_EQ(surface.report.vertices, 6U);
}

TEST(NodeMap, is_the_papers) {
    // Fig. 4: of a box, nodes 1 and 4 are inner, the map is 1001 = 9.
    const std::vector<NodeIndex> box{
        NodeIndex{0},
        NodeIndex{1},
        NodeIndex{2},
        NodeIndex{3},
        NodeIndex{4},
        NodeIndex{5},
        NodeIndex{6},
        NodeIndex{7}};
    std::vector<bool> is_surface_node(8, true);
    is_surface_node[0] = is_surface_node[3] = false;

    EXPECT_EQ(node_map_bits(box, is_surface_node), 9U);
    EXPECT_EQ(node_map_bits(std::span(box).first(4), is_surface_node), 9U);
    EXPECT_EQ(node_map_bits(std::span(box).subspan(4), is_surface_node), 0U);
    const std::vector<NodeIndex> with_missing{NodeIndex{3}, kNoNode, NodeIndex{0}};
    EXPECT_EQ(node_map_bits(with_missing, is_surface_node), 5U);
}

TEST(NodeMap, a_facet_stays_when_none_of_its_corners_is_inner) {
    const Mesh mesh = test::brick_grid(3, 3, 3);
    SkinOptions options;
    options.method = SkinMethod::NodeList;
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
        const Point3& at = mesh.coordinates[i];
        const bool outside = std::ranges::any_of(at, [](double v) { return v == 0 || v == 3; });
        if (outside) options.surface_nodes.push_back(mesh.node_ids[i]);
    }
    const Surface surface = skin_of(mesh, options);
    // Thick enough: the node map is right here.
    EXPECT_EQ(surface.report.solid_facets_kept, 54U);

    const Mesh plate = test::brick_grid(3, 3, 1);
    options.surface_nodes = plate.node_ids;
    const Surface thin = skin_of(plate, options);
    // One element thick: it keeps everything, 12 inner sides twice.
    EXPECT_EQ(thin.report.solid_facets_kept, 54U);
    EXPECT_EQ(skin_of(plate).report.solid_facets_kept, 30U);
    options.method = SkinMethod::All;
    EXPECT_EQ(skin_of(mesh, options).report.solid_facets_kept, 27U * 6);
}

}  // namespace
}  // namespace feelem
