// SPDX-License-Identifier: Apache-2.0
// Must: give the bytes of the portable twin (facet_batch.cpp). Algorithm: sixteen nodes at a time, two linear
// hexahedra or four linear tetrahedra: in one lane a facet its smallest corner and its sign, in one of the
// wide lanes its hash. Hexahedra's facets on which a corner repeats are looked at once more, such tetrahedra
// go to the twin, and all other types to AVX2.
#include "skin/collapsed_facets.hpp"
#include "skin/facet_batch.hpp"
#include "skin/facet_hash.hpp"

#if defined(__x86_64__)

#include <immintrin.h>

#define FEELEM_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw")))
#define FEELEM_AVX512_INLINE                                                                                 \
    __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw"), always_inline)) inline

namespace feelem::avx512 {
namespace {

using Lanes16 = std::array<std::int32_t, 16>;
using Lanes8 = std::array<std::int64_t, 8>;

FEELEM_AVX512_INLINE __m512i load(const void* from) {
    return _mm512_loadu_si512(from);
}
FEELEM_AVX512_INLINE __m512i all(std::uint32_t value) {
    return _mm512_set1_epi32(static_cast<int>(value));
}

// All lanes, zeroed where there were none: the plain forms of GCC 12 start from a register that it then finds
// uninitialized.
FEELEM_AVX512_INLINE __m512i down_32(__m512i x, unsigned by) {
    return _mm512_maskz_srli_epi32(0xFFFF, x, by);
}
FEELEM_AVX512_INLINE __m512i upper(__m512i x) {
    return _mm512_maskz_srli_epi64(0xFF, x, 32);
}
FEELEM_AVX512_INLINE __m512i smaller(__m512i a, __m512i b) {
    return _mm512_maskz_min_epu32(0xFFFF, a, b);
}
FEELEM_AVX512_INLINE __m512i picked(const void* lanes, __m512i nodes) {
    return _mm512_maskz_permutexvar_epi32(0xFFFF, load(lanes), nodes);
}
FEELEM_AVX512_INLINE __m512i product(__m512i a, __m512i b) {
    return _mm512_maskz_mul_epu32(0xFF, a, b);
}

FEELEM_AVX512_INLINE __m512i mix(__m512i x, const facet_hash::Mix& how) {
    x = _mm512_xor_si512(x, all(how.start_corner));
    x = _mm512_mullo_epi32(_mm512_xor_si512(x, down_32(x, 16)), all(how.first));
    x = _mm512_mullo_epi32(_mm512_xor_si512(x, down_32(x, 15)), all(how.second));
    return _mm512_xor_si512(x, down_32(x, static_cast<unsigned>(how.last_shift)));
}

/// Keys of sixteen corners: of lanes 0 1 4 5 8 9 12 13, and of the others.
struct Keys {
    __m512i first, second;
};
FEELEM_AVX512_INLINE Keys keys_of(__m512i nodes) {
    const __m512i low = mix(nodes, facet_hash::kLowMix), high = mix(nodes, facet_hash::kHighMix);
    return {_mm512_maskz_unpacklo_epi32(0xFFFF, low, high), _mm512_maskz_unpackhi_epi32(0xFFFF, low, high)};
}
/// Where the keys of eight facets' corners are; triangles have three.
struct Places {
    __m512i a, b, c, d;
};
/// Where the key of a lane is, as vpermi2q counts.
constexpr std::int64_t place_of_key(std::size_t lane) {
    const std::size_t within = lane / 4 * 2 + lane % 2;
    return static_cast<std::int64_t>(lane % 4 < 2 ? within : 8 + within);
}

FEELEM_AVX512_INLINE __m512i fold_halves(__m512i a, __m512i b) {
    return _mm512_xor_si512(product(a, b), _mm512_maskz_rol_epi64(0xFF, product(upper(a), upper(b)), 32));
}

FEELEM_AVX512_INLINE void store_signed(std::uint64_t* to, __m512i values, __mmask8 negative) {
    _mm512_storeu_si512(to, _mm512_mask_sub_epi64(values, negative, _mm512_setzero_si512(), values));
}

constexpr const ElementRow& kHex = element_table::kTable[static_cast<std::size_t>(ElementType::Hex8)];

/// Lane f: node `corner` of facet f of the first hexahedron, from lane 6 on of the second one.
constexpr Lanes16 hex_nodes(std::size_t corner) {
    Lanes16 lanes{};
    for (std::size_t f = 0; f < 12; ++f)
        lanes[f] = kHex.facets[f % 6].nodes[corner] + static_cast<std::int32_t>(f / 6 * 8);
    return lanes;
}
/// Lane f: where the key of that node of hexahedron `hex` is.
constexpr Lanes8 hex_keys(std::size_t hex, std::size_t corner) {
    Lanes8 lanes{};
    for (std::size_t f = 0; f < 6; ++f) lanes[f] = place_of_key(hex * 8 + kHex.facets[f].nodes[corner]);
    return lanes;
}

/// What is known of twelve quads but their hashes.
struct Quads {
    __m512i lowest;
    __mmask16 negative, repeats;
};
FEELEM_AVX512_INLINE Quads quads(__m512i a, __m512i b, __m512i c, __m512i d) {
    const __m512i low_ac = smaller(a, c), low_bd = smaller(b, d);
    // Each step keeps the lanes in which nodes differed so far.
    __mmask16 differ = _mm512_cmpneq_epi32_mask(a, b);
    differ = _mm512_mask_cmpneq_epi32_mask(differ, b, c);
    differ = _mm512_mask_cmpneq_epi32_mask(differ, c, d);
    differ = _mm512_mask_cmpneq_epi32_mask(differ, d, a);
    differ = _mm512_mask_cmpneq_epi32_mask(differ, a, c);
    differ = _mm512_mask_cmpneq_epi32_mask(differ, b, d);
    const unsigned negative = static_cast<unsigned>(_mm512_cmplt_epu32_mask(a, c)) ^
                              static_cast<unsigned>(_mm512_cmplt_epu32_mask(b, d)) ^
                              static_cast<unsigned>(_mm512_cmplt_epu32_mask(low_bd, low_ac));
    return {
        smaller(low_ac, low_bd), static_cast<__mmask16>(negative), static_cast<__mmask16>(~differ & 0xFFFU)};
}

template <FacetHashes kWhat>
FEELEM_AVX512_INLINE void hash_hex(
    const Keys& keys, const Places& at, unsigned negative, FacetBatch& out, std::size_t to
) {
    const __m512i ac = _mm512_add_epi64(
        _mm512_permutex2var_epi64(keys.first, at.a, keys.second),
        _mm512_permutex2var_epi64(keys.first, at.c, keys.second)
    );
    const __m512i bd = _mm512_add_epi64(
        _mm512_permutex2var_epi64(keys.first, at.b, keys.second),
        _mm512_permutex2var_epi64(keys.first, at.d, keys.second)
    );
    if constexpr (kWhat != FacetHashes::Signed)
        _mm512_storeu_si512(&out.corners[to], _mm512_add_epi64(ac, bd));
    if constexpr (kWhat != FacetHashes::Corners)
        store_signed(&out.hashes[to], fold_halves(ac, bd), static_cast<__mmask8>(negative));
}

template <FacetHashes kWhat>
FEELEM_AVX512 void hash_collapsed_of_two(
    unsigned repeats, const NodeIndex* nodes, const Keys& keys, FacetBatch& out, std::size_t to
) {
    std::array<std::uint64_t, 16> stored;
    _mm512_storeu_si512(stored.data(), keys.first);
    _mm512_storeu_si512(stored.data() + 8, keys.second);
    for (std::size_t hex = 0; hex < 2; ++hex) {
        const auto key_of = [&](std::size_t i) {
            return stored[static_cast<std::size_t>(place_of_key(hex * 8 + i))];
        };
        hash_collapsed<kWhat>(
            (repeats >> (hex * 6)) & 0x3FU, kHex, nodes + hex * 8, key_of, out, to + hex * 6
        );
    }
}

template <FacetHashes kWhat>
FEELEM_AVX512 void hash_hexes(ElementRun run, FacetBatch& out) {
    static constexpr std::array kNodes{hex_nodes(0), hex_nodes(1), hex_nodes(2), hex_nodes(3)};
    static constexpr std::array kFirst{hex_keys(0, 0), hex_keys(0, 1), hex_keys(0, 2), hex_keys(0, 3)};
    static constexpr std::array kSecond{hex_keys(1, 0), hex_keys(1, 1), hex_keys(1, 2), hex_keys(1, 3)};
    const Places first{load(&kFirst[0]), load(&kFirst[1]), load(&kFirst[2]), load(&kFirst[3])};
    const Places second{load(&kSecond[0]), load(&kSecond[1]), load(&kSecond[2]), load(&kSecond[3])};
    const NodeIndex* nodes = run.nodes;
    std::size_t e = 0;
    for (; e + 2 <= run.count; e += 2, nodes += 16) {
        fetch_elements_after(nodes);
        const __m512i both = load(nodes);
        const Quads facets = quads(
            picked(&kNodes[0], both),
            picked(&kNodes[1], both),
            picked(&kNodes[2], both),
            picked(&kNodes[3], both)
        );
        _mm512_storeu_si512(&out.lowest[e * 6], facets.lowest);
        const Keys keys = keys_of(both);
        hash_hex<kWhat>(keys, first, facets.negative & 0x3FU, out, e * 6);
        hash_hex<kWhat>(keys, second, static_cast<unsigned>(facets.negative) >> 6U, out, e * 6 + 6);
        if (facets.repeats != 0) {
            out.may_repeat = true;
            hash_collapsed_of_two<kWhat>(facets.repeats, nodes, keys, out, e * 6);
        }
    }
    hash_facets_portably({run.type, nodes, run.count - e}, kWhat, out, e * 6);
}

constexpr const ElementRow& kTet = element_table::kTable[static_cast<std::size_t>(ElementType::Tet4)];

/// Lane f: where the key of node `corner` of facet f % 4 of tetrahedron `tet` + f / 4 is.
constexpr Lanes8 tet_keys(std::size_t tet, std::size_t corner) {
    Lanes8 lanes{};
    for (std::size_t f = 0; f < 8; ++f)
        lanes[f] = place_of_key((tet + f / 4) * 4 + kTet.facets[f % 4].nodes[corner]);
    return lanes;
}

template <FacetHashes kWhat>
FEELEM_AVX512_INLINE void hash_two_tets(
    const Keys& keys, const Places& at, unsigned negative, FacetBatch& out, std::size_t to
) {
    const __m512i sum = _mm512_add_epi64(
        _mm512_add_epi64(
            _mm512_permutex2var_epi64(keys.first, at.a, keys.second),
            _mm512_permutex2var_epi64(keys.first, at.b, keys.second)
        ),
        _mm512_permutex2var_epi64(keys.first, at.c, keys.second)
    );
    if constexpr (kWhat != FacetHashes::Signed) _mm512_storeu_si512(&out.corners[to], sum);
    if constexpr (kWhat != FacetHashes::Corners) {
        const __m512i other =
            _mm512_xor_si512(sum, _mm512_set1_epi64(static_cast<std::int64_t>(facet_hash::kTriangle)));
        store_signed(&out.hashes[to], fold_halves(sum, other), static_cast<__mmask8>(negative));
    }
}

template <FacetHashes kWhat>
FEELEM_AVX512 void hash_tets(ElementRun run, FacetBatch& out) {
    static_assert(
        kTet.facets[3].nodes[0] == 0 && kTet.facets[3].nodes[1] == 2 && kTet.facets[3].nodes[2] == 1
    );
    static constexpr std::array kFirst{tet_keys(0, 0), tet_keys(0, 1), tet_keys(0, 2)};
    static constexpr std::array kSecond{tet_keys(2, 0), tet_keys(2, 1), tet_keys(2, 2)};
    const Places first{load(&kFirst[0]), load(&kFirst[1]), load(&kFirst[2]), __m512i{}};
    const Places second{load(&kSecond[0]), load(&kSecond[1]), load(&kSecond[2]), __m512i{}};
    const NodeIndex* nodes = run.nodes;
    std::size_t e = 0;
    for (; e + 4 <= run.count; e += 4, nodes += 16) {
        fetch_elements_after(nodes);
        const __m512i four = load(nodes);
        // Lane f of each quarter: the corners of facet f, as kTet has them.
        const __m512i a =
            _mm512_maskz_shuffle_epi32(0xFFFF, four, static_cast<_MM_PERM_ENUM>(_MM_SHUFFLE(0, 2, 1, 0)));
        const __m512i b =
            _mm512_maskz_shuffle_epi32(0xFFFF, four, static_cast<_MM_PERM_ENUM>(_MM_SHUFFLE(2, 0, 2, 1)));
        const __m512i c =
            _mm512_maskz_shuffle_epi32(0xFFFF, four, static_cast<_MM_PERM_ENUM>(_MM_SHUFFLE(1, 3, 3, 3)));
        __mmask16 differ = _mm512_cmpneq_epi32_mask(a, b);
        differ = _mm512_mask_cmpneq_epi32_mask(differ, b, c);
        differ = _mm512_mask_cmpneq_epi32_mask(differ, a, c);
        if (differ != 0xFFFF) {
            hash_facets_portably({run.type, nodes, 4}, kWhat, out, e * 4);
            continue;
        }
        const unsigned negative = static_cast<unsigned>(_mm512_cmplt_epu32_mask(a, b)) ^
                                  static_cast<unsigned>(_mm512_cmplt_epu32_mask(b, c)) ^
                                  static_cast<unsigned>(_mm512_cmplt_epu32_mask(a, c));
        _mm512_storeu_si512(&out.lowest[e * 4], smaller(smaller(a, b), c));
        const Keys keys = keys_of(four);
        hash_two_tets<kWhat>(keys, first, negative & 0xFFU, out, e * 4);
        hash_two_tets<kWhat>(keys, second, negative >> 8U, out, e * 4 + 8);
    }
    hash_facets_portably({run.type, nodes, run.count - e}, kWhat, out, e * 4);
}

template <FacetHashes kWhat>
bool choose_wide(ElementRun run, FacetBatch& out) {
    switch (run.type) {
    case ElementType::Hex8: hash_hexes<kWhat>(run, out); return true;
    case ElementType::Tet4: hash_tets<kWhat>(run, out); return true;
    default: return false;
    }
}

}  // namespace
}  // namespace feelem::avx512

namespace feelem {

bool hash_facets_with_avx512(ElementRun run, FacetHashes what, FacetBatch& out) {
    if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512dq") ||
        !__builtin_cpu_supports("avx512vl") || !__builtin_cpu_supports("avx512bw"))
        return false;
    switch (what) {
    case FacetHashes::Signed: return avx512::choose_wide<FacetHashes::Signed>(run, out);
    case FacetHashes::Corners: return avx512::choose_wide<FacetHashes::Corners>(run, out);
    case FacetHashes::Both: return avx512::choose_wide<FacetHashes::Both>(run, out);
    }
    return false;
}

}  // namespace feelem

#else

namespace feelem {

bool hash_facets_with_avx512(ElementRun, FacetHashes, FacetBatch&) {
    return false;
}

}  // namespace feelem

#endif
