// SPDX-License-Identifier: Apache-2.0
// What lets facets cancel, and keeps everything else from cancelling.
#include "skin/facet_hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace feelem {
namespace {

Outline outline(std::vector<std::uint32_t> corners, std::vector<std::uint32_t> middles = {}) {
    Outline out;
    out.count = static_cast<std::uint8_t>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) out.corners[i] = NodeIndex{corners[i]};
    for (std::size_t i = 0; i < middles.size(); ++i) out.middles[i] = NodeIndex{middles[i]};
    return out;
}

/// All orders of the corners that go round a facet the same way.
std::vector<std::vector<std::uint32_t>> rotations(std::vector<std::uint32_t> corners) {
    std::vector<std::vector<std::uint32_t>> out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        out.push_back(corners);
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
    return out;
}

TEST(FacetHash, is_the_same_from_any_corner_and_opposite_the_other_way_round) {
    for (std::vector<std::uint32_t> corners : {std::vector<std::uint32_t>{3, 8, 5}, {3, 8, 5, 11}}) {
        // Every order of the numbers, so that each comparison falls both ways.
        std::ranges::sort(corners);
        do {
            const std::vector<std::uint32_t> back(corners.rbegin(), corners.rend());
            const FacetHash hash = facet_hash::of(outline(corners));
            EXPECT_EQ(hash.lowest, 3U);
            EXPECT_NE(hash.value, 0U);
            for (const auto& same : rotations(corners))
                EXPECT_EQ(facet_hash::of(outline(same)).value, hash.value);
            for (const auto& other : rotations(back))
                EXPECT_EQ(facet_hash::of(outline(other)).value, 0 - hash.value);
        } while (std::ranges::next_permutation(corners).found);
    }
}

TEST(FacetHash, does_not_care_where_a_middle_stands_but_which_there_are) {
    const auto with = [](std::vector<std::uint32_t> middles) {
        return facet_hash::of(outline({1, 2, 3}, std::move(middles))).value;
    };
    EXPECT_EQ(with({4, 5, 6}), with({6, 4, 5}));
    EXPECT_NE(with({4, 5, 6}), with({4, 5, 7}));
    // Equal sums, other nodes.
    EXPECT_NE(with({4, 5, 6}), with({3, 5, 7}));
    EXPECT_NE(with({4, 5, 6}), with({}));
    EXPECT_EQ(with({raw(kNoNode), raw(kNoNode), raw(kNoNode)}), with({}));
}

TEST(FacetHash, is_none_for_facets_that_collapse) {
    const std::vector<NodeIndex> nodes{NodeIndex{1}, NodeIndex{2}, NodeIndex{2}, NodeIndex{1}};
    EXPECT_EQ(facet_hash::of(facets_of(ElementType::Quad4)[0], nodes).value, 0U);
    const std::vector<NodeIndex> folded{NodeIndex{1}, NodeIndex{2}, NodeIndex{1}, NodeIndex{4}};
    EXPECT_EQ(facet_hash::of(facets_of(ElementType::Quad4)[0], folded).value, 0U);
}

TEST(FacetHash, of_a_quad_with_a_repeated_corner_is_that_of_the_triangle) {
    const std::vector<NodeIndex> nodes{NodeIndex{7}, NodeIndex{2}, NodeIndex{2}, NodeIndex{5}};
    EXPECT_EQ(
        facet_hash::of(facets_of(ElementType::Quad4)[0], nodes).value,
        facet_hash::of(outline({7, 2, 5})).value
    );
}

TEST(FacetHash, sums_round_a_node_do_not_cancel_on_regular_numbering) {
    // Closed fans of triangles round node 0 with regular ids: a hash linear in its nodes would give 0.
    std::set<std::uint64_t> sums;
    for (std::uint32_t step = 1; step < 200; ++step) {
        std::uint64_t sum = 0;
        for (std::uint32_t k = 0; k < 6; ++k)
            sum += facet_hash::of(outline({0, step + k * step, step + ((k + 1) % 6) * step})).value;
        EXPECT_NE(sum, 0U);
        sums.insert(sum);
    }
    EXPECT_EQ(sums.size(), 199U);
}

}  // namespace
}  // namespace feelem
