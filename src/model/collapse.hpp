// SPDX-License-Identifier: Apache-2.0
// Degenerate solids: a brick that repeats nodes is the wedge, pyramid or tetrahedron it looks like.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace feelem {

struct CollapsedElement {
    ElementType type = ElementType::Point1;
    std::array<NodeIndex, kMaxElementNodes> nodes{};
};

/// Whether no two corners are one, on any processor.
inline bool all_differ_portable(std::span<const NodeIndex> corners) {
    unsigned equal = 0;  // Counted: a branch each would cost more.
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < corners.size(); ++j) equal += corners[i] == corners[j];
    }
    return equal == 0;
}

#if defined(__SSE2__)

/// Of four: each is compared with the next and the one after it.
inline __m128i equal_within(__m128i four) {
    return _mm_or_si128(
        _mm_cmpeq_epi32(four, _mm_shuffle_epi32(four, 0x39)),
        _mm_cmpeq_epi32(four, _mm_shuffle_epi32(four, 0x4E))
    );
}

/// The same as all_differ_portable(): those of a tetrahedron, a quadrilateral or a brick all at once.
inline bool all_differ(std::span<const NodeIndex> corners) {
    if (corners.size() != 4 && corners.size() != 8) return all_differ_portable(corners);
    const auto load = [&](std::size_t i) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(corners.data() + i));
    };
    const __m128i low = load(0);
    __m128i equal = equal_within(low);
    if (corners.size() == 8) {
        const __m128i high = load(4);
        equal = _mm_or_si128(equal, equal_within(high));
        equal = _mm_or_si128(equal, _mm_cmpeq_epi32(low, high));
        equal = _mm_or_si128(equal, _mm_cmpeq_epi32(low, _mm_shuffle_epi32(high, 0x39)));
        equal = _mm_or_si128(equal, _mm_cmpeq_epi32(low, _mm_shuffle_epi32(high, 0x4E)));
        equal = _mm_or_si128(equal, _mm_cmpeq_epi32(low, _mm_shuffle_epi32(high, 0x93)));
    }
    return _mm_movemask_epi8(equal) == 0;
}

#else

inline bool all_differ(std::span<const NodeIndex> corners) {
    return all_differ_portable(corners);
}

#endif

/// The simpler standard element behind a row with repeated corners, or nothing when it has no repeats or is
/// no standard shape (then it stays as it is, and its facets are collapsed one by one in the skin). Mid-side
/// nodes of collapsed edges repeat a corner and are dropped; quadratic wedges become wedge15.
std::optional<CollapsedElement> collapse(ElementType type, std::span<const NodeIndex> nodes);

/// The corners of a facet without those that repeat in sequence; at most four.
struct FacetCorners {
    std::array<NodeIndex, 4> nodes{};
    std::size_t count = 0;
};
FacetCorners collapsed_corners(const FacetRow& facet, std::span<const NodeIndex> element_nodes);

}  // namespace feelem
