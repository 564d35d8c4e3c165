// SPDX-License-Identifier: Apache-2.0
// Must: give the bytes of the portable twin (facet_batch.cpp). Algorithm: eight nodes at a time, one
// hexahedron or two tetrahedra: their keys, and in one lane a facet its smallest corner and its sign. The
// products are ordinary ones, since AVX2 has none of 64 bits. Facets on which a corner repeats are looked at
// once more: triangles are left of most of them. Other elements than linear hexahedra go to the twin then.
#include "skin/collapsed_facets.hpp"
#include "skin/facet_batch.hpp"
#include "skin/facet_hash.hpp"

#if defined(__x86_64__)

#include <immintrin.h>

#define FEELEM_AVX2 __attribute__((target("avx2")))
#define FEELEM_AVX2_INLINE __attribute__((target("avx2"), always_inline)) inline

namespace feelem::avx2 {
namespace {

/// Where keys_of_eight puts the key of lane i.
constexpr std::array<std::size_t, 8> kPlace{0, 1, 4, 5, 2, 3, 6, 7};
struct alignas(32) EightKeys {
    std::array<std::uint64_t, 8> at;
    std::uint64_t operator[](std::size_t lane) const { return at[kPlace[lane]]; }
};
using EightLanes = std::array<std::int32_t, 8>;

FEELEM_AVX2_INLINE __m256i load(const void* from) {
    return _mm256_loadu_si256(static_cast<const __m256i*>(from));
}
FEELEM_AVX2_INLINE __m128i load_four(const void* from) {
    return _mm_loadu_si128(static_cast<const __m128i*>(from));
}
FEELEM_AVX2_INLINE void store(void* to, __m256i lanes) {
    _mm256_storeu_si256(static_cast<__m256i*>(to), lanes);
}

FEELEM_AVX2_INLINE __m256i all(std::uint32_t value) {
    return _mm256_set1_epi32(static_cast<int>(value));
}

FEELEM_AVX2_INLINE __m256i mix(__m256i x, const facet_hash::Mix& how) {
    x = _mm256_mullo_epi32(_mm256_xor_si256(x, _mm256_srli_epi32(x, 16)), all(how.first));
    x = _mm256_mullo_epi32(_mm256_xor_si256(x, _mm256_srli_epi32(x, 15)), all(how.second));
    return _mm256_xor_si256(x, _mm256_srli_epi32(x, how.last_shift));
}

struct Halves {
    __m256i low, high;  ///< Keys of lanes 0 1 4 5, and of 2 3 6 7.
};

template <bool kMiddles>
FEELEM_AVX2_INLINE Halves keys_of_eight(__m256i nodes) {
    using facet_hash::kHighMix;
    using facet_hash::kLowMix;
    const __m256i low_start = all(kMiddles ? kLowMix.start_middle : kLowMix.start_corner);
    const __m256i high_start = all(kMiddles ? kHighMix.start_middle : kHighMix.start_corner);
    __m256i low = mix(_mm256_xor_si256(nodes, low_start), kLowMix);
    __m256i high = mix(_mm256_xor_si256(nodes, high_start), kHighMix);
    if constexpr (kMiddles) {
        const __m256i left_out = _mm256_cmpeq_epi32(nodes, _mm256_set1_epi32(-1));
        low = _mm256_andnot_si256(left_out, low);
        high = _mm256_andnot_si256(left_out, high);
    }
    return {_mm256_unpacklo_epi32(low, high), _mm256_unpackhi_epi32(low, high)};
}

template <bool kMiddles>
FEELEM_AVX2_INLINE EightKeys stored_keys(__m256i nodes) {
    const Halves halves = keys_of_eight<kMiddles>(nodes);
    EightKeys keys;
    store(keys.at.data(), halves.low);
    store(keys.at.data() + 4, halves.high);
    return keys;
}

FEELEM_AVX2_INLINE std::uint64_t with_sign(std::uint64_t value, std::int32_t sign) {
    const auto mask = static_cast<std::uint64_t>(std::int64_t{sign});
    return (value ^ mask) - mask;
}

/// Lane f: local node `corner` of facet f.
constexpr EightLanes lanes_of(const ElementRow& row, std::size_t corner) {
    EightLanes lanes{};
    for (std::size_t f = 0; f < lanes.size(); ++f)
        lanes[f] = row.facets[f < row.facet_count ? f : 0].nodes[corner];
    return lanes;
}

/// Smallest corner and sign of each lane's facet; whether a facet has a corner twice.
struct LaneFacets {
    __m256i lowest, negative, repeats;
};

FEELEM_AVX2_INLINE LaneFacets quads(__m256i a, __m256i b, __m256i c, __m256i d) {
    const __m256i low_ac = _mm256_min_epu32(a, c), low_bd = _mm256_min_epu32(b, d);
    const __m256i lowest = _mm256_min_epu32(low_ac, low_bd);
    const __m256i ends = _mm256_xor_si256(_mm256_cmpeq_epi32(low_ac, a), _mm256_cmpeq_epi32(low_bd, b));
    const __m256i round = _mm256_or_si256(
        _mm256_cmpeq_epi32(a, b), _mm256_or_si256(_mm256_cmpeq_epi32(b, c), _mm256_cmpeq_epi32(c, d))
    );
    const __m256i across = _mm256_or_si256(
        _mm256_cmpeq_epi32(d, a), _mm256_or_si256(_mm256_cmpeq_epi32(a, c), _mm256_cmpeq_epi32(b, d))
    );
    return {
        lowest, _mm256_xor_si256(ends, _mm256_cmpeq_epi32(lowest, low_bd)), _mm256_or_si256(round, across)};
}

FEELEM_AVX2_INLINE LaneFacets triangles(__m256i a, __m256i b, __m256i c) {
    const __m256i ab = _mm256_min_epu32(a, b), bc = _mm256_min_epu32(b, c), ac = _mm256_min_epu32(a, c);
    const __m256i odd = _mm256_xor_si256(
        _mm256_cmpeq_epi32(ab, a), _mm256_xor_si256(_mm256_cmpeq_epi32(bc, b), _mm256_cmpeq_epi32(ac, a))
    );
    const __m256i repeats = _mm256_or_si256(
        _mm256_cmpeq_epi32(a, b), _mm256_or_si256(_mm256_cmpeq_epi32(b, c), _mm256_cmpeq_epi32(a, c))
    );
    return {_mm256_min_epu32(ab, c), odd, repeats};
}

template <ElementType kType, FacetHashes kWhat>
FEELEM_AVX2 void hash_hexes(ElementRun run, FacetBatch& out) {
    static constexpr const ElementRow& kRow = element_table::kTable[static_cast<std::size_t>(kType)];
    static constexpr bool kQuadratic = kRow.order == 2;
    static constexpr std::array kLanes{
        lanes_of(kRow, 0), lanes_of(kRow, 1), lanes_of(kRow, 2), lanes_of(kRow, 3)};
    const __m256i lane_a = load(&kLanes[0]), lane_b = load(&kLanes[1]), lane_c = load(&kLanes[2]),
                  lane_d = load(&kLanes[3]);
    const NodeIndex* nodes = run.nodes;
    for (std::size_t e = 0; e < run.count; ++e, nodes += kRow.node_count) {
        fetch_elements_after(nodes);
        const __m256i eight = load(nodes);
        const LaneFacets facets = quads(
            _mm256_permutevar8x32_epi32(eight, lane_a),
            _mm256_permutevar8x32_epi32(eight, lane_b),
            _mm256_permutevar8x32_epi32(eight, lane_c),
            _mm256_permutevar8x32_epi32(eight, lane_d)
        );
        const auto repeats = static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(facets.repeats)));
        if (kQuadratic && repeats != 0) {
            hash_facets_portably({kType, nodes, 1}, kWhat, out, e * 6);
            continue;
        }
        alignas(32) EightLanes sign;
        store(&sign, facets.negative);
        store(&out.lowest[e * 6], facets.lowest);
        const EightKeys keys = stored_keys<false>(eight);
        EightKeys first{}, last{};  // Of middles 8 to 15, and 12 to 19.
        if constexpr (kQuadratic && kWhat != FacetHashes::Corners) {
            first = stored_keys<true>(load(nodes + 8));
            last = stored_keys<true>(load(nodes + 12));
        }
#pragma GCC unroll 6
        for (std::size_t f = 0; f < 6; ++f) {
            const auto& at = kRow.facets[f].nodes;
            const std::uint64_t ac = keys[at[0]] + keys[at[2]], bd = keys[at[1]] + keys[at[3]];
            if constexpr (kWhat != FacetHashes::Signed) out.corners[e * 6 + f] = ac + bd;
            if constexpr (kWhat == FacetHashes::Corners) continue;
            std::uint64_t middles = 0;
            if constexpr (kQuadratic) {
                for (std::size_t i = 4; i < 8; ++i)
                    middles += at[i] < 16 ? first[at[i] - 8U] : last[at[i] - 12U];
            }
            out.hashes[e * 6 + f] = with_sign(facet_hash::quad_value(ac, bd, middles, false), sign[f]);
        }
        if (repeats != 0) {
            out.may_repeat = true;
            hash_collapsed<kWhat>(
                repeats & 0x3F, kRow, nodes, [&](std::size_t i) { return keys[i]; }, out, e * 6
            );
        }
    }
}

/// The sums of the keys at the facets' corners: of all four, without the one that is opposite.
struct alignas(32) TetSums {
    std::array<std::uint64_t, 4> without_0_1;  ///< Of the first tet, then of the second.
    std::array<std::uint64_t, 4> without_2_3;
    std::uint64_t of(std::size_t tet, std::size_t facet) const {
        constexpr std::array<std::size_t, 4> kOpposite{2, 0, 1, 3};
        const std::size_t node = kOpposite[facet];
        return node < 2 ? without_0_1[tet * 2 + node] : without_2_3[tet * 2 + node - 2];
    }
};

FEELEM_AVX2_INLINE TetSums tet_sums(__m256i nodes) {
    const Halves keys = keys_of_eight<false>(nodes);
    const __m256i pairs = _mm256_add_epi64(keys.low, keys.high);
    const __m256i all = _mm256_add_epi64(pairs, _mm256_shuffle_epi32(pairs, _MM_SHUFFLE(1, 0, 3, 2)));
    TetSums sums;
    store(&sums.without_0_1, _mm256_sub_epi64(all, keys.low));
    store(&sums.without_2_3, _mm256_sub_epi64(all, keys.high));
    return sums;
}

template <ElementType kType, FacetHashes kWhat>
FEELEM_AVX2 void hash_tets(ElementRun run, FacetBatch& out) {
    static constexpr const ElementRow& kRow = element_table::kTable[static_cast<std::size_t>(kType)];
    static constexpr std::size_t kWidth = kRow.node_count;
    const NodeIndex* nodes = run.nodes;
    std::size_t e = 0;
    for (; e + 2 <= run.count; e += 2, nodes += 2 * kWidth) {
        fetch_elements_after(nodes);
        const __m256i eight = _mm256_set_m128i(load_four(nodes + kWidth), load_four(nodes));
        // Lane f of each half: the corners of facet f.
        const LaneFacets facets = triangles(
            _mm256_shuffle_epi32(eight, _MM_SHUFFLE(0, 2, 1, 0)),
            _mm256_shuffle_epi32(eight, _MM_SHUFFLE(2, 0, 2, 1)),
            _mm256_shuffle_epi32(eight, _MM_SHUFFLE(1, 3, 3, 3))
        );
        if (!_mm256_testz_si256(facets.repeats, facets.repeats)) {
            hash_facets_portably({kType, nodes, 2}, kWhat, out, e * 4);
            continue;
        }
        alignas(32) EightLanes sign;
        store(&sign, facets.negative);
        store(&out.lowest[e * 4], facets.lowest);
        const TetSums sums = tet_sums(eight);
        for (std::size_t tet = 0; tet < 2; ++tet) {
            EightKeys keys{};  // Of nodes 2 to 9: middles from lane 2 on.
            if constexpr (kRow.order == 2 && kWhat != FacetHashes::Corners)
                keys = stored_keys<true>(load(nodes + tet * kWidth + 2));
#pragma GCC unroll 4
            for (std::size_t f = 0; f < 4; ++f) {
                const auto& at = kRow.facets[f].nodes;
                std::uint64_t middles = 0;
                if constexpr (kRow.order == 2 && kWhat != FacetHashes::Corners)
                    middles = keys[at[3] - 2U] + keys[at[4] - 2U] + keys[at[5] - 2U];
                const std::uint64_t sum = sums.of(tet, f);
                const std::size_t at_facet = (e + tet) * 4 + f;
                if constexpr (kWhat != FacetHashes::Signed) out.corners[at_facet] = sum;
                if constexpr (kWhat == FacetHashes::Corners) continue;
                out.hashes[at_facet] =
                    with_sign(facet_hash::triangle_value(sum, middles, false), sign[tet * 4 + f]);
            }
        }
    }
    hash_facets_portably({kType, nodes, run.count - e}, kWhat, out, e * 4);
}

template <FacetHashes kWhat>
bool choose(ElementRun run, FacetBatch& out) {
    switch (run.type) {
    case ElementType::Hex8: hash_hexes<ElementType::Hex8, kWhat>(run, out); return true;
    case ElementType::Hex20: hash_hexes<ElementType::Hex20, kWhat>(run, out); return true;
    case ElementType::Tet4: hash_tets<ElementType::Tet4, kWhat>(run, out); return true;
    case ElementType::Tet10: hash_tets<ElementType::Tet10, kWhat>(run, out); return true;
    default: return false;
    }
}

}  // namespace
}  // namespace feelem::avx2

namespace feelem {

bool hash_facets_with_avx2(ElementRun run, FacetHashes what, FacetBatch& out) {
    if (!__builtin_cpu_supports("avx2")) return false;
    switch (what) {
    case FacetHashes::Signed: return avx2::choose<FacetHashes::Signed>(run, out);
    case FacetHashes::Corners: return avx2::choose<FacetHashes::Corners>(run, out);
    case FacetHashes::Both: return avx2::choose<FacetHashes::Both>(run, out);
    }
    return false;
}

}  // namespace feelem

#else

namespace feelem {

bool hash_facets_with_avx2(ElementRun, FacetHashes, FacetBatch&) {
    return false;
}

}  // namespace feelem

#endif
