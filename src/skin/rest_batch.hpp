// SPDX-License-Identifier: Apache-2.0
// Many facets beside what is left at their nodes: as the processor does it best, with the same outcome
// everywhere.
#pragma once

#include "skin/facet_batch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace feelem {

/// Bits of facets seen at a node, and of their rest; all bits: not to be settled (lone_facets.cpp).
inline constexpr std::uint64_t kRestSeen = std::uint64_t{1} << 63U;
inline constexpr std::uint64_t kNotSettled = ~std::uint64_t{0};

struct RestBatch {
    /// What a node is to remember of a facet: kRestSeen if the facet is its rest; four bits of the hash of
    /// its corners.
    struct Seen {
        std::array<std::uint32_t, FacetBatch::kFacets + FacetBatch::kSlack> nodes;
        std::array<std::uint64_t, FacetBatch::kFacets + FacetBatch::kSlack> bits;
        std::size_t count = 0;
    };
    /// Of the facets, in order, at nodes where something is left, that are the rest or have a positive hash.
    Seen seen;
    /// Bit i % 8 of byte i / 8: facet i is the rest.
    std::array<std::uint8_t, FacetBatch::kFacets / 8 + 2> is_rest;
};

/// The first `count` facets of a batch that has both hashes.
void compare_with_rests(
    const FacetBatch& batch, std::size_t count, std::span<const std::uint64_t> sums, RestBatch& out
);
/// Word i: the nodes of 64 * i on, bit by bit, that keep something and have not seen it, or are not settled.
void find_unsettled(
    std::span<const std::uint64_t> sums, std::span<const std::uint64_t> seen, std::span<std::uint64_t> words
);

/// What these choose from; tests compare them. Those with AVX-512 do nothing and say false where there is
/// none.
void compare_with_rests_portably(
    const FacetBatch& batch, std::size_t count, std::span<const std::uint64_t> sums, RestBatch& out
);
bool compare_with_rests_with_avx512(
    const FacetBatch& batch, std::size_t count, std::span<const std::uint64_t> sums, RestBatch& out
);
void find_unsettled_portably(
    std::span<const std::uint64_t> sums, std::span<const std::uint64_t> seen, std::span<std::uint64_t> words
);
bool find_unsettled_with_avx512(
    std::span<const std::uint64_t> sums, std::span<const std::uint64_t> seen, std::span<std::uint64_t> words
);

}  // namespace feelem
