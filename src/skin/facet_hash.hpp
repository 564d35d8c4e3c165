// SPDX-License-Identifier: Apache-2.0
// A 64-bit number for a facet: the same from both its owners, but of opposite sign.
#pragma once

#include "model/element_table.hpp"
#include "skin/outline.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace feelem {

/// `value` depends on the nodes only, its sign on the direction in which the owner winds round them.
struct FacetHash {
    std::uint32_t lowest = 0;  ///< Smallest corner.
    std::uint64_t value = 0;   ///< 0: not a facet (its corners collapse).
};

namespace facet_hash {

__extension__ using Product = unsigned __int128;

// Both halves are above any node index that fits into memory, so that no factor below becomes 0.
inline constexpr std::uint64_t kPair = 0xF7E1'5163'FB8A'ED2BULL;
inline constexpr std::uint64_t kTriangle = 0xFD45'A7C9'F0B3'9E6DULL;
inline constexpr std::uint64_t kMiddle = 0xF9D3'8C15'F6A1'7B4FULL;
inline constexpr std::uint64_t kLast = 0x9E37'79B9'7F4A'7C15ULL;

/// Both halves of the product, joined: not linear in either factor, so that the facets round a node do not
/// cancel as sums of keys of their nodes would.
[[gnu::always_inline]] inline std::uint64_t fold(std::uint64_t a, std::uint64_t b) noexcept {
    const Product product = static_cast<Product>(a) * b;
    return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

[[gnu::always_inline]] inline std::uint64_t pair(std::uint32_t low, std::uint32_t high) noexcept {
    return (std::uint64_t{high} << 32) | low;
}

[[gnu::always_inline]] inline std::uint64_t last_mix(std::uint64_t joined, bool negative) noexcept {
    const std::uint64_t value = fold(joined ^ kPair, kLast);
    return negative ? 0 - value : value;
}

/// What the middles add: the same in any order; nothing where they are left out.
inline std::uint64_t middle(NodeIndex node) noexcept {
    return node == kNoNode ? 0 : fold(raw(node) ^ kMiddle, kLast);
}

[[gnu::always_inline]] inline FacetHash triangle(
    std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint64_t middles
) noexcept {
    const std::uint32_t low = std::min(a, std::min(b, c));
    const std::uint32_t high = std::max(a, std::max(b, c));
    const std::uint32_t between = a ^ b ^ c ^ low ^ high;
    const bool odd = (a < b) ^ (b < c) ^ (a < c);
    return {low, last_mix(fold(pair(low, between) ^ kPair, high ^ kTriangle) + middles, odd)};
}

[[gnu::always_inline]] inline FacetHash quad(
    std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint64_t middles
) noexcept {
    // The diagonals a-c and b-d are the same whichever corner comes first; going round the other way swaps
    // the ends of one of them, going on by one corner swaps the diagonals and the ends of one.
    const std::uint32_t low_ac = std::min(a, c);
    const std::uint32_t low_bd = std::min(b, d);
    const std::uint64_t first = pair(low_ac, std::max(a, c)) ^ kPair;
    const std::uint64_t second = pair(low_bd, std::max(b, d)) ^ kPair;
    const bool negative = (a < c) ^ (b < d) ^ (low_bd < low_ac);
    return {std::min(low_ac, low_bd), last_mix(fold(first, second) + middles, negative)};
}

inline FacetHash of(const Outline& outline) noexcept {
    if (outline.count == 0) return {};
    std::uint64_t middles = 0;
    for (std::size_t i = 0; i < outline.count; ++i) middles += middle(outline.middles[i]);
    const auto& at = outline.corners;
    return outline.count == 3 ? triangle(raw(at[0]), raw(at[1]), raw(at[2]), middles)
                              : quad(raw(at[0]), raw(at[1]), raw(at[2]), raw(at[3]), middles);
}

/// Sum of what the middles of facet `row` add, from node `first` of the facet on.
template <std::size_t kFirst, std::size_t kCount>
std::uint64_t middles(const FacetRow& row, std::span<const NodeIndex> nodes) noexcept {
    std::uint64_t sum = 0;
    for (std::size_t i = kFirst; i < kFirst + kCount; ++i) sum += middle(nodes[row.nodes[i]]);
    return sum;
}

/// Facet `row`, a triangle, of an element.
template <bool kQuadratic>
[[gnu::always_inline]] inline FacetHash of_triangle(
    const FacetRow& row, std::span<const NodeIndex> nodes
) noexcept {
    const std::uint32_t a = raw(nodes[row.nodes[0]]);
    const std::uint32_t b = raw(nodes[row.nodes[1]]);
    const std::uint32_t c = raw(nodes[row.nodes[2]]);
    if ((a == b) | (b == c) | (c == a)) return {};
    if constexpr (kQuadratic) return triangle(a, b, c, middles<3, 3>(row, nodes));
    return triangle(a, b, c, 0);
}

/// Facet `row`, a quad, of an element. Its centre node does not count: brick20 and brick27 may be neighbours.
template <bool kQuadratic>
[[gnu::always_inline]] inline FacetHash of_quad(
    const FacetRow& row, std::span<const NodeIndex> nodes
) noexcept {
    const std::uint32_t a = raw(nodes[row.nodes[0]]);
    const std::uint32_t b = raw(nodes[row.nodes[1]]);
    const std::uint32_t c = raw(nodes[row.nodes[2]]);
    const std::uint32_t d = raw(nodes[row.nodes[3]]);
    const bool repeats = (a == b) | (b == c) | (c == d) | (d == a) | (a == c) | (b == d);
    if (repeats) return of(outline_of(row, nodes));
    if constexpr (kQuadratic) return quad(a, b, c, d, middles<4, 4>(row, nodes));
    return quad(a, b, c, d, 0);
}

/// Any facet `row` of an element.
[[gnu::always_inline]] inline FacetHash of(const FacetRow& row, std::span<const NodeIndex> nodes) noexcept {
    switch (row.type) {
    case ElementType::Tri3: return of_triangle<false>(row, nodes);
    case ElementType::Tri6: return of_triangle<true>(row, nodes);
    case ElementType::Quad4: return of_quad<false>(row, nodes);
    default: return of_quad<true>(row, nodes);
    }
}

/// The hashes of an element's facets, for a type that is known when this is compiled.
template <ElementType kType>
struct OfElement {
    template <class Visit>
    [[gnu::always_inline]] static void visit(std::span<const NodeIndex> nodes, Visit&& visit_one) {
        [&]<std::size_t... kFacets>(std::index_sequence<kFacets...>) {
            (visit_one(kFacets, of(kRow.facets[kFacets], nodes)), ...);
        }
        (std::make_index_sequence<kRow.facet_count>());
    }
    static constexpr const ElementRow& kRow = element_table::kTable[static_cast<std::size_t>(kType)];
};

/// The same for any type, by the table.
struct OfAnyElement {
    ElementType type;

    template <class Visit>
    void visit(std::span<const NodeIndex> nodes, Visit&& visit_one) const {
        const auto facets = facets_of(type);
        for (std::size_t i = 0; i < facets.size(); ++i) visit_one(i, of(facets[i], nodes));
    }
};

/// Calls body with what visits the facets of elements of `type`: the types that big meshes are made of have
/// code of their own.
template <class Body>
void with_facets_of(ElementType type, Body&& body) {
    switch (type) {
    case ElementType::Hex8: return body(OfElement<ElementType::Hex8>{});
    case ElementType::Tet4: return body(OfElement<ElementType::Tet4>{});
    case ElementType::Hex20: return body(OfElement<ElementType::Hex20>{});
    case ElementType::Tet10: return body(OfElement<ElementType::Tet10>{});
    default: return body(OfAnyElement{type});
    }
}

}  // namespace facet_hash
}  // namespace feelem
