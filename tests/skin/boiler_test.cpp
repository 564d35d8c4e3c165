// SPDX-License-Identifier: Apache-2.0
// The example's boiler, whose facets were counted by other programs.
#include "support/paths.hpp"
#include "support/skin_checks.hpp"

#include "feelem/derive.hpp"
#include "feelem/model.hpp"
#include "feelem/read.hpp"
#include "feelem/skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace feelem {
namespace {

std::unique_ptr<ModelSource> open_boiler(const std::string& path) {
    static Diagnostics diagnostics;
    const std::string paths[]{path};
    return open_model(paths, {}, diagnostics);
}

std::unique_ptr<ModelSource> shipped_boiler(const std::string& file) {
    return open_boiler(test::project_file("examples/boiler/" + file));
}

Surface skin_by(const Mesh& mesh, SkinMethod method, std::vector<NodeId> surface_nodes = {}) {
    SkinOptions options;
    options.method = method;
    options.surface_nodes = std::move(surface_nodes);
    Diagnostics diagnostics;
    return make_skin(mesh, options, diagnostics);
}

/// Nodes on the true skin, centres of cut quads apart.
std::vector<NodeId> nodes_of(const Mesh& mesh, const Surface& surface) {
    std::vector<NodeId> ids;
    for (const NodeIndex node : surface.vertex_node) {
        if (node != kNoNode) ids.push_back(mesh.node_ids[raw(node)]);
    }
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

struct Expected {
    std::uint64_t facets_in, facets_kept, triangles, vertices, kept_by_node_list;
};

void expect_boiler(const Mesh& mesh, const Expected& expected) {
    const Surface exact = test::check_skin(mesh);
    EXPECT_EQ(exact.report.solid_facets_in, expected.facets_in);
    EXPECT_EQ(exact.report.solid_facets_kept, expected.facets_kept);
    EXPECT_EQ(exact.report.triangles, expected.triangles);
    EXPECT_EQ(exact.report.vertices, expected.vertices);
    EXPECT_EQ(exact.report.unmatched_facets, 0U);
    EXPECT_EQ(exact.report.inverted_elements, 0U);

    const auto owners = test::facet_owners(mesh);
    const auto outer = std::ranges::count_if(owners, [](const auto& facet) { return facet.second == 1; });
    EXPECT_EQ(exact.report.solid_facets_kept, static_cast<std::uint64_t>(outer));

    const Surface listed = skin_by(mesh, SkinMethod::NodeList, nodes_of(mesh, exact));
    EXPECT_EQ(listed.report.solid_facets_kept, expected.kept_by_node_list);
    EXPECT_EQ(skin_by(mesh, SkinMethod::All).report.solid_facets_kept, expected.facets_in);

    for (const std::size_t count : {std::size_t{100}, mesh.element_count()}) {
        const Surface twice = skin_by(test::with_duplicates(mesh, 0, count), SkinMethod::Exact);
        EXPECT_EQ(twice.report.solid_facets_kept, expected.facets_kept) << count;
        EXPECT_TRUE(twice.report.closed) << count;
        EXPECT_DOUBLE_EQ(twice.report.volume, exact.report.volume) << count;
        EXPECT_GE(twice.report.duplicate_elements, count) << count;
    }
}

TEST(Boiler, bricks_and_wedges_of_first_order) {
    expect_boiler(shipped_boiler("hex_linear/static.frd")->mesh(), {7608, 2568, 10128, 2546, 7608});
}

TEST(Boiler, straight_quadratic_tetrahedra) {
    expect_boiler(shipped_boiler("small/static.frd")->mesh(), {15236, 2576, 10304, 5146, 15152});
}

TEST(Boiler, curved_quadratic_bricks_and_wedges) {
    const auto file = test::corpus_file("boiler/hex_small/static.frd");
    if (!file) GTEST_SKIP() << "the corpus is not here";
    expect_boiler(open_boiler(*file)->mesh(), {7608, 2568, 20352, 7658, 7608});
}

TEST(Boiler, its_curved_walls_are_smooth_and_its_rims_are_creases) {
    const auto model = shipped_boiler("hex_linear/static.frd");
    const Surface split = skin_by(model->mesh(), SkinMethod::Exact);
    SkinOptions options;
    options.crease_angle = 180;
    Diagnostics diagnostics;
    const Surface whole = make_skin(model->mesh(), options, diagnostics);

    // A vertex a facet corner would be 10 032; the walls are cut into 24 round the axis, 15 degrees each.
    const auto with_node = [](const Surface& surface) {
        return std::ranges::count_if(surface.vertex_node, [](NodeIndex node) { return node != kNoNode; });
    };
    EXPECT_EQ(with_node(whole), 2546);
    EXPECT_GT(with_node(split), 2546);
    EXPECT_LT(with_node(split), 2 * 2546);
}

}  // namespace
}  // namespace feelem
