// SPDX-License-Identifier: Apache-2.0
// Facets beside what is left at their nodes: the fast way says what the portable one says.
#include "skin/rest_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <random>
#include <vector>

namespace feelem {
namespace {

constexpr std::uint32_t kNodes = 500;

/// Facets at random nodes, some collapsed; nodes that keep nothing, a facet's hash, or anything.
void fill(std::mt19937_64& random, FacetBatch& batch, std::vector<std::uint64_t>& sums) {
    for (std::uint64_t& sum : sums) sum = random() % 3 == 0 ? 0 : random();
    for (std::size_t i = 0; i < FacetBatch::kFacets; ++i) {
        batch.hashes[i] = random() % 16 == 0 ? 0 : random();
        batch.corners[i] = random();
        batch.lowest[i] = static_cast<std::uint32_t>(random() % kNodes);
        if (random() % 3 == 0) sums[batch.lowest[i]] = batch.hashes[i];
    }
    // Beyond the facets that are asked for stands anything.
    std::fill_n(batch.lowest.begin() + FacetBatch::kFacets, FacetBatch::kSlack, ~std::uint32_t{0});
}

TEST(RestBatch, tells_rests_and_keeps_bits_of_them_and_of_positive_facets) {
    std::mt19937_64 random(1);
    const auto batch = std::make_unique<FacetBatch>();
    const auto found = std::make_unique<RestBatch>();
    std::vector<std::uint64_t> sums(kNodes);
    fill(random, *batch, sums);

    compare_with_rests_portably(*batch, FacetBatch::kFacets, sums, *found);

    int rests = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < FacetBatch::kFacets; ++i) {
        const std::uint64_t hash = batch->hashes[i], sum = sums[batch->lowest[i]];
        const bool is_rest = hash != 0 && hash == sum;
        rests += is_rest ? 1 : 0;
        EXPECT_EQ((found->is_rest[i / 8] >> (i % 8)) & 1, is_rest ? 1 : 0);
        if (hash == 0 || sum == 0 || (!is_rest && hash >> 63U != 0)) continue;
        EXPECT_EQ(found->seen.nodes[at], batch->lowest[i]);
        EXPECT_EQ(found->seen.bits[at] >= kRestSeen, is_rest);
        EXPECT_EQ(std::popcount(found->seen.bits[at] & ~kRestSeen), 4);
        ++at;
    }
    EXPECT_EQ(found->seen.count, at);
    EXPECT_GT(rests, 20);
}

TEST(RestBatch, with_avx512_is_bit_for_bit_the_portable_one) {
    std::mt19937_64 random(2);
    const auto batch = std::make_unique<FacetBatch>();
    std::vector<std::uint64_t> sums(kNodes);
    for (const std::size_t count : {std::size_t{1}, std::size_t{8}, std::size_t{75}, FacetBatch::kFacets}) {
        fill(random, *batch, sums);
        for (std::size_t i = count; i < FacetBatch::kFacets; ++i) batch->lowest[i] = ~std::uint32_t{0};
        const auto fast = std::make_unique<RestBatch>(), portable = std::make_unique<RestBatch>();
        if (!compare_with_rests_with_avx512(*batch, count, sums, *fast))
            GTEST_SKIP() << "this processor has no AVX-512";
        compare_with_rests_portably(*batch, count, sums, *portable);
        ASSERT_EQ(fast->seen.count, portable->seen.count);
        for (std::size_t i = 0; i < fast->seen.count; ++i) {
            EXPECT_EQ(fast->seen.nodes[i], portable->seen.nodes[i]) << i;
            EXPECT_EQ(fast->seen.bits[i], portable->seen.bits[i]) << i;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const auto bit = [&](const RestBatch& rests) { return (rests.is_rest[i / 8] >> (i % 8)) & 1; };
            EXPECT_EQ(bit(*fast), bit(*portable)) << i;
        }
    }
}

TEST(RestBatch, unsettled_nodes_keep_something_that_was_not_seen_or_was_seen_twice) {
    std::vector<std::uint64_t> sums(150), seen(150);
    sums[0] = 1, seen[0] = kRestSeen;
    sums[1] = 1, seen[1] = kNotSettled;
    sums[2] = 1, seen[2] = 3;
    seen[3] = 3;
    sums[149] = 1;
    std::vector<std::uint64_t> words(3, 7);

    find_unsettled_portably(sums, seen, words);
    EXPECT_EQ(words, (std::vector<std::uint64_t>{6, 0, std::uint64_t{1} << 21U}));

    words.assign(3, 7);
    if (!find_unsettled_with_avx512(sums, seen, words)) GTEST_SKIP() << "this processor has no AVX-512";
    EXPECT_EQ(words, (std::vector<std::uint64_t>{6, 0, std::uint64_t{1} << 21U}));
}

}  // namespace
}  // namespace feelem
