// SPDX-License-Identifier: Apache-2.0
// Must: give the bytes of the portable twin (rest_batch.cpp). Eight facets, or nodes, at a time.
#include "skin/rest_batch.hpp"

#if defined(__x86_64__)

#include <immintrin.h>

#include <algorithm>

#define FEELEM_RESTS_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw,popcnt")))
#define FEELEM_RESTS_AVX512_INLINE                                                                           \
    __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw,popcnt"), always_inline)) inline

namespace feelem {
namespace {

bool has_avx512() {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}

FEELEM_RESTS_AVX512_INLINE __m512i eight(const std::uint64_t* from) {
    return _mm512_loadu_si512(from);
}
/// One bit a lane, `from` places up and by the four bits of the hash at `shift` more.
FEELEM_RESTS_AVX512_INLINE __m512i one_bit(__m512i hash, unsigned shift, std::int64_t width, unsigned from) {
    const __m512i by =
        _mm512_and_si512(_mm512_maskz_srli_epi64(0xFF, hash, shift), _mm512_set1_epi64(width - 1));
    return _mm512_maskz_sllv_epi64(0xFF, _mm512_set1_epi64(std::int64_t{1} << from), by);
}

FEELEM_RESTS_AVX512 void compare_eights(
    const FacetBatch& batch, std::size_t count, const std::uint64_t* sums, RestBatch& out
) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < count; i += 8) {
        const auto lanes = static_cast<__mmask8>(0xFFU >> (8 - std::min<std::size_t>(count - i, 8)));
        const __m256i lowest = _mm256_maskz_loadu_epi32(lanes, &batch.lowest[i]);
        // Node indices have 32 bits, of which the one for signs is used as well.
        const __m512i at = _mm512_maskz_cvtepu32_epi64(0xFF, lowest);
        const __m512i rests = _mm512_mask_i64gather_epi64(_mm512_setzero_si512(), lanes, at, sums, 8);
        const __m512i hashes = eight(&batch.hashes[i]), corners = eight(&batch.corners[i]);
        const __mmask8 counts =
            _mm512_mask_test_epi64_mask(_mm512_mask_test_epi64_mask(lanes, rests, rests), hashes, hashes);
        const __mmask8 is_rest = _mm512_mask_cmpeq_epi64_mask(counts, rests, hashes);
        const __mmask8 negative = _mm512_movepi64_mask(hashes);
        const auto kept = static_cast<__mmask8>(
            static_cast<unsigned>(counts) &
            (static_cast<unsigned>(is_rest) | ~static_cast<unsigned>(negative))
        );
        const __m512i lower = _mm512_or_si512(one_bit(corners, 0, 16, 0), one_bit(corners, 4, 16, 16));
        const __m512i upper = _mm512_or_si512(one_bit(corners, 8, 16, 32), one_bit(corners, 12, 8, 48));
        const __m512i rest_bit = _mm512_set1_epi64(static_cast<std::int64_t>(kRestSeen));
        const __m512i four_bits = _mm512_or_si512(lower, upper);
        const __m512i bits = _mm512_mask_or_epi64(four_bits, is_rest, four_bits, rest_bit);
        _mm512_storeu_si512(&out.seen.bits[end], _mm512_maskz_compress_epi64(kept, bits));
        _mm256_storeu_si256(
            reinterpret_cast<__m256i*>(&out.seen.nodes[end]), _mm256_maskz_compress_epi32(kept, lowest)
        );
        end += static_cast<std::size_t>(__builtin_popcount(kept));
        out.is_rest[i / 8] = static_cast<std::uint8_t>(is_rest);
    }
    out.seen.count = end;
}

FEELEM_RESTS_AVX512 std::uint64_t unsettled_word(const std::uint64_t* sums, const std::uint64_t* seen) {
    std::uint64_t word = 0;
    for (unsigned k = 0; k < 64; k += 8) {
        const __m512i rests = eight(sums + k), bits = eight(seen + k);
        const __mmask8 some = _mm512_test_epi64_mask(rests, rests);
        const auto settled = static_cast<__mmask8>(
            static_cast<unsigned>(_mm512_movepi64_mask(bits)) &
            static_cast<unsigned>(_mm512_cmpneq_epi64_mask(bits, _mm512_set1_epi64(-1)))
        );
        word |= std::uint64_t{static_cast<std::uint8_t>(some & ~static_cast<unsigned>(settled))} << k;
    }
    return word;
}

}  // namespace

bool compare_with_rests_with_avx512(
    const FacetBatch& batch, std::size_t count, std::span<const std::uint64_t> sums, RestBatch& out
) {
    if (!has_avx512()) return false;
    compare_eights(batch, count, sums.data(), out);
    return true;
}

bool find_unsettled_with_avx512(
    std::span<const std::uint64_t> sums, std::span<const std::uint64_t> seen, std::span<std::uint64_t> words
) {
    if (!has_avx512()) return false;
    const std::size_t whole = std::min(sums.size() / 64, words.size());
    for (std::size_t i = 0; i < whole; ++i) words[i] = unsettled_word(&sums[i * 64], &seen[i * 64]);
    if (whole < words.size())
        find_unsettled_portably(sums.subspan(whole * 64), seen.subspan(whole * 64), words.subspan(whole));
    return true;
}

}  // namespace feelem

#else

namespace feelem {

bool compare_with_rests_with_avx512(const FacetBatch&, std::size_t, std::span<const std::uint64_t>, RestBatch&) {
    return false;
}

bool find_unsettled_with_avx512(std::span<const std::uint64_t>, std::span<const std::uint64_t>, std::span<std::uint64_t>) {
    return false;
}

}  // namespace feelem

#endif
