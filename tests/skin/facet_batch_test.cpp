// SPDX-License-Identifier: Apache-2.0
// The fast hashes of many facets are those of the single ones, on every processor.
#include "skin/facet_batch.hpp"
#include "skin/facet_hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <span>
#include <vector>

namespace feelem {
namespace {

constexpr FacetHashes kWhats[]{FacetHashes::Signed, FacetHashes::Corners, FacetHashes::Both};
constexpr ElementType kSolids[]{
    ElementType::Tet4,
    ElementType::Tet10,
    ElementType::Pyramid5,
    ElementType::Pyramid13,
    ElementType::Wedge6,
    ElementType::Wedge15,
    ElementType::Wedge18,
    ElementType::Hex8,
    ElementType::Hex20,
    ElementType::Hex27};

/// Elements with distinct nodes over all 32 bits; in some a corner repeats, in some a middle is left out.
std::vector<NodeIndex> odd_elements(ElementType type, std::size_t count, std::uint32_t seed) {
    const ElementRow& row = element_row(type);
    std::mt19937 random(seed);
    std::vector<NodeIndex> nodes(count * row.node_count);
    for (NodeIndex& node : nodes) node = NodeIndex{static_cast<std::uint32_t>(random() - 1)};
    for (std::size_t e = 0; e < count; ++e) {
        NodeIndex* element = nodes.data() + e * row.node_count;
        if (e % 5 == 1) element[random() % row.corner_count] = element[random() % row.corner_count];
        if (e % 3 == 1 && row.order == 2)
            element[row.corner_count + random() % (row.node_count - row.corner_count)] = kNoNode;
    }
    return nodes;
}

void expect_single_hashes(const ElementRun& run, FacetHashes what, const FacetBatch& batch) {
    const ElementRow& row = element_row(run.type);
    std::size_t at = 0;
    for (std::size_t e = 0; e < run.count; ++e) {
        const std::span nodes(run.nodes + e * row.node_count, row.node_count);
        for (const FacetRow& facet : facets_of(run.type)) {
            const FacetHash one = facet_hash::of(facet, nodes);
            if (what != FacetHashes::Corners) {
                ASSERT_EQ(batch.hashes[at], one.value) << row.name << " element " << e << " facet " << at;
            }
            if (what != FacetHashes::Signed) {
                ASSERT_EQ(batch.corners[at], one.corners) << row.name << " element " << e << " facet " << at;
            }
            ASSERT_EQ(batch.lowest[at], one.lowest);
            ++at;
        }
    }
}

TEST(FacetBatch, has_the_hash_of_each_single_facet) {
    const auto batch = std::make_unique<FacetBatch>();
    for (const ElementType type : kSolids) {
        const auto nodes = odd_elements(type, FacetBatch::kElements, 1);
        for (const FacetHashes what : kWhats) {
            // One, an odd number, and as many as there may be.
            for (const std::size_t count : {std::size_t{1}, std::size_t{7}, FacetBatch::kElements}) {
                const ElementRun run{type, nodes.data(), count};
                hash_facets(run, what, *batch);
                expect_single_hashes(run, what, *batch);
                hash_facets_portably(run, what, *batch);
                expect_single_hashes(run, what, *batch);
            }
        }
    }
}

using Fast = bool (*)(ElementRun, FacetHashes, FacetBatch&);

/// Whether the processor has what `fast` needs.
bool expect_the_portable_bytes(Fast fast) {
    bool any = false;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        for (const ElementType type : kSolids) {
            const auto nodes = odd_elements(type, FacetBatch::kElements, seed);
            for (const FacetHashes what : kWhats) {
                const ElementRun run{type, nodes.data(), FacetBatch::kElements - seed};
                const auto quick = std::make_unique<FacetBatch>(), portable = std::make_unique<FacetBatch>();
                if (!fast(run, what, *quick)) continue;
                any = true;
                hash_facets_portably(run, what, *portable);
                const std::size_t facets = run.count * element_row(type).facet_count;
                const auto same = [&](const auto& a, const auto& b) {
                    return std::ranges::equal(std::span(a).first(facets), std::span(b).first(facets));
                };
                if (what != FacetHashes::Corners) {
                    EXPECT_TRUE(same(quick->hashes, portable->hashes)) << element_row(type).name;
                }
                if (what != FacetHashes::Signed) {
                    EXPECT_TRUE(same(quick->corners, portable->corners)) << element_row(type).name;
                }
                EXPECT_TRUE(same(quick->lowest, portable->lowest)) << element_row(type).name;
                EXPECT_EQ(quick->may_repeat, portable->may_repeat) << element_row(type).name;
            }
        }
    }
    return any;
}

TEST(FacetBatch, with_avx2_is_bit_for_bit_the_portable_one) {
    if (!expect_the_portable_bytes(hash_facets_with_avx2)) GTEST_SKIP() << "this processor has no AVX2";
}

TEST(FacetBatch, with_avx512_is_bit_for_bit_the_portable_one) {
    if (!expect_the_portable_bytes(hash_facets_with_avx512)) GTEST_SKIP() << "this processor has no AVX-512";
}

}  // namespace
}  // namespace feelem
