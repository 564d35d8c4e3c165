// SPDX-License-Identifier: Apache-2.0
// A 64-bit number for a facet: the same from both its owners, but of opposite sign.
#pragma once

#include "skin/outline.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

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
inline std::uint64_t fold(std::uint64_t a, std::uint64_t b) noexcept {
    const Product product = static_cast<Product>(a) * b;
    return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

inline std::uint64_t pair(std::uint32_t low, std::uint32_t high) noexcept {
    return (std::uint64_t{high} << 32) | low;
}

inline std::uint64_t last_mix(std::uint64_t joined, bool negative) noexcept {
    const std::uint64_t value = fold(joined ^ kPair, kLast);
    return negative ? 0 - value : value;
}

/// What the middles add: the same in any order; nothing where they are left out.
inline std::uint64_t middle(NodeIndex node) noexcept {
    return node == kNoNode ? 0 : fold(raw(node) ^ kMiddle, kLast);
}

inline FacetHash triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint64_t middles) noexcept {
    const std::uint32_t low = std::min(a, std::min(b, c));
    const std::uint32_t high = std::max(a, std::max(b, c));
    const std::uint32_t between = a ^ b ^ c ^ low ^ high;
    const bool odd = (a < b) ^ (b < c) ^ (a < c);
    return {low, last_mix(fold(pair(low, between) ^ kPair, high ^ kTriangle) + middles, odd)};
}

inline FacetHash quad(
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

/// Facet `row` of an element; quick where no corner repeats.
inline FacetHash of(const FacetRow& row, std::span<const NodeIndex> nodes) noexcept {
    const auto node = [&](std::size_t i) { return raw(nodes[row.nodes[i]]); };
    const auto middle_at = [&](std::size_t i) { return middle(nodes[row.nodes[i]]); };
    const std::uint32_t a = node(0), b = node(1), c = node(2);
    if (row.type == ElementType::Tri3 || row.type == ElementType::Tri6) {
        if (a == b || b == c || c == a) return {};
        const bool quadratic = row.type == ElementType::Tri6;
        if (!quadratic) return triangle(a, b, c, 0);
        return triangle(a, b, c, middle_at(3) + middle_at(4) + middle_at(5));
    }
    const std::uint32_t d = node(3);
    if (a == b || b == c || c == d || d == a || a == c || b == d) return of(outline_of(row, nodes));
    if (row.type == ElementType::Quad4) return quad(a, b, c, d, 0);
    return quad(a, b, c, d, middle_at(4) + middle_at(5) + middle_at(6) + middle_at(7));
}

}  // namespace facet_hash
}  // namespace feelem
