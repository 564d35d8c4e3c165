// SPDX-License-Identifier: Apache-2.0
#include "skin/rest_batch.hpp"

#include <algorithm>

namespace feelem {
namespace {

/// Four bits below kRestSeen.
std::uint64_t four_bits(std::uint64_t hash) {
    return std::uint64_t{1} << (hash % 16) | std::uint64_t{1} << (16 + (hash >> 4U) % 16) |
           std::uint64_t{1} << (32 + (hash >> 8U) % 16) | std::uint64_t{1} << (48 + (hash >> 12U) % 8);
}

}  // namespace

void compare_with_rests_portably(
    const FacetBatch& batch, std::size_t count, std::span<const std::uint64_t> sums, RestBatch& out
) {
    std::fill_n(out.is_rest.begin(), (count + 7) / 8, std::uint8_t{0});
    std::size_t end = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t hash = batch.hashes[i], rest = sums[batch.lowest[i]];
        const bool is_rest = hash == rest, is_positive = hash < kRestSeen;
        if (rest == 0 || hash == 0 || (!is_rest && !is_positive)) continue;
        out.seen.nodes[end] = batch.lowest[i];
        out.seen.bits[end++] = four_bits(batch.corners[i]) | (is_rest ? kRestSeen : 0);
        out.is_rest[i / 8] = static_cast<std::uint8_t>(out.is_rest[i / 8] | (unsigned{is_rest} << (i % 8)));
    }
    out.seen.count = end;
}

void compare_with_rests(
    const FacetBatch& batch, std::size_t count, std::span<const std::uint64_t> sums, RestBatch& out
) {
    if (!compare_with_rests_with_avx512(batch, count, sums, out))
        compare_with_rests_portably(batch, count, sums, out);
}

void find_unsettled_portably(
    std::span<const std::uint64_t> sums, std::span<const std::uint64_t> seen, std::span<std::uint64_t> words
) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        std::uint64_t word = 0;
        const std::size_t end = std::min<std::size_t>(sums.size() - i * 64, 64);
        for (std::size_t k = 0; k < end; ++k) {
            const std::uint64_t here = seen[i * 64 + k];
            const bool is_unsettled = sums[i * 64 + k] != 0 && (here < kRestSeen || here == kNotSettled);
            word |= std::uint64_t{is_unsettled} << k;
        }
        words[i] = word;
    }
}

void find_unsettled(
    std::span<const std::uint64_t> sums, std::span<const std::uint64_t> seen, std::span<std::uint64_t> words
) {
    if (!find_unsettled_with_avx512(sums, seen, words)) find_unsettled_portably(sums, seen, words);
}

}  // namespace feelem
