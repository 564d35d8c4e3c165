// SPDX-License-Identifier: Apache-2.0
// The work of the skin grows no faster than the model: counted, not timed, so that a busy machine does not
// matter.
#include "skin/facet_cancellation.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace feelem {
namespace {

/// The same mesh with nodes numbered at random, as free meshers may leave them.
Mesh shuffled(Mesh mesh) {
    std::vector<std::uint32_t> place(mesh.node_count());
    for (std::uint32_t i = 0; i < place.size(); ++i) place[i] = i;
    std::ranges::shuffle(place, std::mt19937(1));
    const std::vector<Point3> before = mesh.coordinates;
    for (std::size_t i = 0; i < place.size(); ++i) mesh.coordinates[place[i]] = before[i];
    for (ElementBlock& block : mesh.blocks) {
        for (NodeIndex& node : block.nodes) node = NodeIndex{place[raw(node)]};
    }
    return mesh;
}

/// Tetrahedra round an edge whose lower end has the smallest number: nearly all facets are looked for there.
Mesh ring_of_tets(std::uint32_t count) {
    Mesh mesh;
    mesh.parts.push_back({"ring"});
    ElementBlock block{ElementType::Tet4, {}, {}, {}};
    for (std::uint32_t i = 0; i < count; ++i) {
        block.ids.push_back(ElementId{i + 1});
        block.parts.push_back(PartIndex{0});
        for (const std::uint32_t node : {0U, 2 + i, 2 + (i + 1) % count, 1U})
            block.nodes.push_back(NodeIndex{node});
    }
    mesh.blocks.push_back(std::move(block));
    mesh.coordinates.resize(count + 2);
    for (std::uint32_t i = 0; i < count + 2; ++i) mesh.node_ids.push_back(NodeId{i + 1});
    return mesh;
}

double exponent(double small, double big, double small_size, double big_size) {
    return std::log(big / small) / std::log(big_size / small_size);
}

TEST(Growth, of_facets_matched_and_places_compared_is_that_of_the_skin) {
    for (const bool is_shuffled : {false, true}) {
        std::vector<OuterFacets> found;
        for (const int side : {32, 44, 64}) {
            const Mesh mesh = test::brick_grid(side, side, side);
            found.push_back(find_outer_facets(is_shuffled ? shuffled(mesh) : mesh, {}));
            const OuterFacets& last = found.back();
            ASSERT_EQ(last.outer.size(), 6U * static_cast<std::size_t>(side * side));
            EXPECT_LE(last.candidates, 6 * last.outer.size()) << side;
            EXPECT_LE(last.probes, 4 * last.candidates) << side;
        }
        const auto size = [&](std::size_t i) { return static_cast<double>(found[i].outer.size()); };
        const auto work = [&](std::size_t i) {
            // A facet is looked at once, at least.
            return static_cast<double>(found[i].outer.size() + found[i].candidates + found[i].probes);
        };
        EXPECT_LE(exponent(work(1), work(2), size(1), size(2)), 1.05)
            << (is_shuffled ? "shuffled" : "as built");
    }
}

TEST(Growth, of_places_compared_is_linear_where_everything_hangs_on_one_node) {
    std::vector<double> probes;
    for (const std::uint32_t count : {2000U, 16000U}) {
        const OuterFacets found = find_outer_facets(ring_of_tets(count), {});
        ASSERT_EQ(found.outer.size(), 2U * count);
        EXPECT_EQ(found.inner, 2U * count);
        EXPECT_LE(found.probes, 10 * found.candidates);
        probes.push_back(static_cast<double>(found.probes));
    }
    EXPECT_LE(exponent(probes[0], probes[1], 2000, 16000), 1.1);
}

}  // namespace
}  // namespace feelem
