// SPDX-License-Identifier: Apache-2.0
// The search for outer facets against owners counted one by one, on meshes that are as bad as can be.
#include "base/parallel.hpp"
#include "skin/element_checks.hpp"
#include "skin/facet_cancellation.hpp"
#include "skin/outline.hpp"
#include "support/meshes.hpp"
#include "support/skin_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace feelem {
namespace {

using Corners = std::vector<std::uint32_t>;

Corners sorted_corners(const Outline& outline) {
    Corners out;
    for (std::size_t i = 0; i < outline.count; ++i) out.push_back(raw(outline.corners[i]));
    std::ranges::sort(out);
    return out;
}

/// Linear ones. Corners from the smallest one on towards its smaller neighbour; and which way round that is.
std::pair<Corners, int> shape_of(const Outline& outline) {
    Corners corners;
    for (std::size_t i = 0; i < outline.count; ++i) corners.push_back(raw(outline.corners[i]));
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    const bool is_turned = corners.back() < corners[1];
    if (is_turned) std::reverse(corners.begin() + 1, corners.end());
    return {corners, is_turned ? -1 : 1};
}

struct Owner {
    FacetRef ref;
    Outline outline;
};

/// Quads that lie on two triangles, all outer.
std::uint64_t quads_on_triangles(const std::vector<Owner>& outer) {
    std::set<Corners> triangles;
    for (const Owner& owner : outer) {
        if (owner.outline.count == 3) triangles.insert(sorted_corners(owner.outline));
    }
    const auto has = [&](const Outline& quad, std::initializer_list<std::size_t> which) {
        Corners corners;
        for (const std::size_t i : which) corners.push_back(raw(quad.corners[i]));
        std::ranges::sort(corners);
        return triangles.contains(corners);
    };
    return static_cast<std::uint64_t>(std::ranges::count_if(outer, [&](const Owner& owner) {
        const Outline& quad = owner.outline;
        return quad.count == 4 && ((has(quad, {0, 1, 2}) && has(quad, {0, 2, 3})) ||
                                   (has(quad, {0, 1, 3}) && has(quad, {1, 2, 3})));
    }));
}

/// What the search promises, the slow way. Owners are judged where something is left at their smallest
/// corner: those that cancel in fours do not show elsewhere.
OuterFacets by_counting(const Mesh& mesh, const std::vector<bool>& set_aside) {
    OuterFacets found;
    std::map<Corners, std::vector<Owner>> owners;
    std::map<std::uint32_t, std::map<Corners, int>> left;
    std::size_t element = 0;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
        const auto facets = facets_of(mesh.blocks[b].type).size();
        for (std::size_t i = 0; i < mesh.blocks[b].ids.size(); ++i, ++element) {
            for (std::size_t f = 0; f < facets; ++f) {
                ++found.in;
                const FacetRef ref{
                    static_cast<std::uint32_t>(i),
                    static_cast<std::uint8_t>(b),
                    static_cast<std::uint8_t>(f)};
                const Outline outline = outline_of(mesh, ref);
                const bool is_aside = !set_aside.empty() && set_aside[element];
                found.of_set_aside += is_aside ? 1U : 0U;
                if (is_aside) continue;
                found.collapsed += outline.count == 0 ? 1U : 0U;
                if (outline.count == 0) continue;
                const auto [shape, sign] = shape_of(outline);
                left[shape[0]][shape] += sign;
                owners[sorted_corners(outline)].push_back({ref, outline});
            }
        }
    }
    const auto is_marked = [&](std::uint32_t node) {
        return std::ranges::any_of(left[node], [](const auto& shape) { return shape.second != 0; });
    };
    std::vector<Owner> outer;
    for (const auto& [corners, all] : owners) {
        if (!is_marked(corners[0])) continue;
        if (all.size() == 1) {
            outer.push_back(all[0]);
            continue;
        }
        if (all.size() == 2 && shape_of(all[0].outline).first == shape_of(all[1].outline).first &&
            shape_of(all[0].outline).second != shape_of(all[1].outline).second)
            continue;
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const FacetRef a = all[i].ref, c = all[k].ref;
                const bool is_same = a.block == c.block && a.position == c.position;
                found.duplicates =
                    found.duplicates || (!is_same && corner_set(mesh.blocks[a.block], a.position) ==
                                                         corner_set(mesh.blocks[c.block], c.position));
            }
        }
        if (all.size() > 2) {
            found.many_owners += all.size();
        } else {
            found.same_winding = true;
        }
    }
    std::ranges::sort(outer, {}, [](const Owner& owner) {
        return std::array<std::size_t, 3>{owner.ref.block, owner.ref.position, owner.ref.facet};
    });
    for (const Owner& owner : outer) found.outer.push_back(owner.ref);
    found.unmatched += 3 * quads_on_triangles(outer);
    found.inner = found.in - found.outer.size() - found.many_owners - found.collapsed - found.of_set_aside;
    return found;
}

std::vector<std::array<std::uint32_t, 3>> places(const OuterFacets& found) {
    std::vector<std::array<std::uint32_t, 3>> out;
    for (const FacetRef ref : found.outer) out.push_back({ref.block, ref.position, ref.facet});
    return out;
}

/// How often each case was met, so that a test can tell that it tried it.
struct Met {
    int settled = 0, duplicates = 0, many_owners = 0, unmatched = 0, same_winding = 0, collapsed = 0;
};

void expect_as_counted(const Mesh& mesh, const std::vector<bool>& set_aside, Met& met) {
    const OuterFacets counted = by_counting(mesh, set_aside);
    met.duplicates += counted.duplicates ? 1 : 0;
    met.collapsed += counted.collapsed > 0 ? 1 : 0;
    for (const unsigned threads : {1U, 3U}) {
        set_thread_count(threads);
        const OuterFacets found = find_outer_facets(mesh, set_aside);
        set_thread_count(0);
        ASSERT_EQ(found.duplicates, counted.duplicates);
        ASSERT_EQ(found.in, counted.in);
        ASSERT_EQ(found.collapsed, counted.collapsed);
        ASSERT_EQ(found.of_set_aside, counted.of_set_aside);
        if (counted.duplicates) continue;
        ASSERT_EQ(places(found), places(counted));
        ASSERT_EQ(found.many_owners, counted.many_owners);
        ASSERT_EQ(found.unmatched, counted.unmatched);
        ASSERT_EQ(found.same_winding, counted.same_winding);
        ASSERT_EQ(found.inner, counted.inner);
        met.settled += found.candidates < found.outer.size() ? 1 : 0;
    }
    met.many_owners += counted.many_owners > 0 ? 1 : 0;
    met.unmatched += counted.unmatched > 0 ? 1 : 0;
    met.same_winding += counted.same_winding ? 1 : 0;
    if (counted.duplicates && set_aside.empty()) expect_as_counted(mesh, find_duplicate_solids(mesh), met);
}

/// Elements of any types on any nodes out of a few, so that owners meet in every way.
Mesh soup(std::mt19937& random) {
    Mesh mesh;
    mesh.parts.push_back({"soup"});
    const std::uint32_t nodes = 5 + static_cast<std::uint32_t>(random()) % 30;
    mesh.coordinates.resize(nodes);
    for (std::uint32_t i = 0; i < nodes; ++i) mesh.node_ids.push_back(NodeId{i + 1});
    std::int64_t id = 0;
    for (const ElementType type :
         {ElementType::Tet4, ElementType::Pyramid5, ElementType::Wedge6, ElementType::Hex8}) {
        if (random() % 2 == 0) continue;
        ElementBlock block{type, {}, {}, {}};
        for (std::size_t i = random() % 12; i > 0; --i) {
            block.ids.push_back(ElementId{++id});
            block.parts.push_back(PartIndex{0});
            for (std::size_t k = 0; k < element_row(type).node_count; ++k)
                block.nodes.push_back(NodeIndex{static_cast<std::uint32_t>(random()) % nodes});
        }
        mesh.blocks.push_back(std::move(block));
    }
    return mesh;
}

TEST(OuterFacets, of_elements_on_any_nodes_are_those_with_one_owner) {
    std::mt19937 random(1);
    Met met;
    for (int round = 0; round < 2000 && !HasFatalFailure(); ++round) {
        SCOPED_TRACE(round);
        expect_as_counted(soup(random), {}, met);
    }
    EXPECT_GT(met.duplicates, 20);
    EXPECT_GT(met.many_owners, 100);
    EXPECT_GT(met.unmatched, 100);
    EXPECT_GT(met.same_winding, 100);
    EXPECT_GT(met.collapsed, 100);
    EXPECT_GT(met.settled, 100);
}

/// What may be wrong with an element of a grid of bricks.
void spoil(std::mt19937& random, ElementBlock& block, std::size_t element) {
    const auto nodes = block.nodes.begin() + static_cast<std::ptrdiff_t>(element * 8);
    switch (random() % 4) {
    case 0: std::swap_ranges(nodes, nodes + 4, nodes + 4); return;                  // Inside out.
    case 1: nodes[3] = nodes[2], nodes[7] = nodes[6]; return;                       // A wedge.
    case 2: nodes[5] = nodes[4], nodes[6] = nodes[4], nodes[7] = nodes[4]; return;  // A pyramid.
    default:  // Again, at the end, maybe mirrored.
        block.ids.push_back(ElementId{static_cast<std::int64_t>(block.ids.size()) + 1});
        block.parts.push_back(block.parts[element]);
        const std::vector<NodeIndex> again(nodes, nodes + 8);
        const auto half = again.begin() + 4;
        const bool is_mirrored = random() % 2 == 0;
        block.nodes.insert(
            block.nodes.end(), is_mirrored ? half : again.begin(), is_mirrored ? again.end() : half
        );
        block.nodes.insert(
            block.nodes.end(), is_mirrored ? again.begin() : half, is_mirrored ? half : again.end()
        );
    }
}

TEST(OuterFacets, of_spoiled_plates_and_blocks_are_those_with_one_owner) {
    std::mt19937 random(2);
    Met met;
    for (int round = 0; round < 400 && !HasFatalFailure(); ++round) {
        SCOPED_TRACE(round);
        const auto size = [&] { return 1 + static_cast<int>(random() % 7); };
        Mesh mesh = test::brick_grid(size(), size(), round % 3 == 0 ? size() : 1);
        ElementBlock& block = mesh.blocks[0];
        for (std::size_t k = random() % 4; k > 0; --k) spoil(random, block, random() % block.ids.size());
        if (round % 2 == 0) mesh = test::renumbered(mesh, static_cast<unsigned>(round));
        expect_as_counted(mesh, {}, met);
    }
    EXPECT_GT(met.settled, 100);
    EXPECT_GT(met.duplicates, 20);
}

TEST(OuterFacets, of_a_plate_that_many_threads_share_are_those_with_one_owner) {
    // More than two chunks of elements, which lie in any order: what meets at a node comes from several
    // threads.
    std::mt19937 random(3);
    Mesh mesh = test::brick_grid(130, 130, 1);
    for (int k = 0; k < 40; ++k) spoil(random, mesh.blocks[0], random() % mesh.blocks[0].ids.size());
    Met met;

    expect_as_counted(test::shuffled(mesh, 4), {}, met);

    EXPECT_GT(met.settled, 0);
    EXPECT_GT(met.duplicates, 0);
}

TEST(OuterFacets, four_owners_that_cancel_are_found_beside_a_lone_facet) {
    // Four elements on the triangle 6 7 8, two from either side: nothing else stands at node 6 but one facet
    // of the fifth, since their tips have smaller numbers.
    const Mesh mesh = test::tiny_mesh(
        {{0, 0, 1},
         {0, 0, 2},
         {0, 0, -1},
         {0, 0, -2},
         {3, 0, 0},
         {0, 0, 0},
         {1, 0, 0},
         {0, 1, 0},
         {3, 1, 0},
         {3, 0, 1}},
        {{ElementType::Tet4, {6, 7, 8, 1}},
         {ElementType::Tet4, {6, 7, 8, 2}},
         {ElementType::Tet4, {6, 8, 7, 3}},
         {ElementType::Tet4, {6, 8, 7, 4}},
         {ElementType::Tet4, {6, 9, 10, 5}}}
    );
    Met met;

    expect_as_counted(mesh, {}, met);

    EXPECT_EQ(find_outer_facets(mesh, {}).many_owners, 4U);
}

TEST(OuterFacets, of_a_plate_are_settled_without_being_matched) {
    const Mesh mesh = test::brick_grid(60, 60, 1);

    const OuterFacets found = find_outer_facets(mesh, {});

    EXPECT_EQ(found.outer.size(), 2U * 3600 + 4 * 60);
    // Along two of its borders nodes keep two facets or more.
    EXPECT_LE(found.candidates, found.outer.size() / 5);
}

}  // namespace
}  // namespace feelem
