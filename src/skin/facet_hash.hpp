// SPDX-License-Identifier: Apache-2.0
// A 64-bit number for a facet: the same from both its owners, but of opposite sign.
#pragma once

#include "model/element_table.hpp"
#include "skin/outline.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

namespace feelem {

/// `value` depends on the nodes only, its sign on the direction in which the owner winds round them.
struct FacetHash {
    std::uint32_t lowest = 0;   ///< Smallest corner.
    std::uint64_t value = 0;    ///< 0: not a facet (its corners collapse).
    std::uint64_t corners = 0;  ///< Of the corners alone, in whatever order; 0: not a facet.
};

namespace facet_hash {

__extension__ using Product = unsigned __int128;

inline constexpr std::uint64_t kPair = 0xF7E1'5163'FB8A'ED2BULL;
inline constexpr std::uint64_t kTriangle = 0xFD45'A7C9'F0B3'9E6DULL;
inline constexpr std::uint64_t kLast = 0x9E37'79B9'7F4A'7C15ULL;

/// Both halves of the product, joined: not linear in either factor, so that the facets round a node do not
/// cancel as sums of keys of their nodes would.
[[gnu::always_inline]] inline std::uint64_t fold(std::uint64_t a, std::uint64_t b) noexcept {
    const Product product = static_cast<Product>(a) * b;
    return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

/// The products of the lower and of the upper halves, joined: like fold(), but many at once are soon done.
[[gnu::always_inline]] inline std::uint64_t fold_halves(std::uint64_t a, std::uint64_t b) noexcept {
    const std::uint64_t lower = std::uint64_t{static_cast<std::uint32_t>(a)} * static_cast<std::uint32_t>(b);
    const std::uint64_t upper = (a >> 32U) * (b >> 32U);
    return lower ^ ((upper << 32U) | (upper >> 32U));
}

[[gnu::always_inline]] inline std::uint64_t pair(std::uint32_t low, std::uint32_t high) noexcept {
    return (std::uint64_t{high} << 32) | low;
}

/// Two one-to-one mixes of 32 bits (C. Wellons' "lowbias32" and a second of his search): one half each of a
/// node's key. `start` keeps node 0 from having the key 0, and keys of corners and of middles apart.
struct Mix {
    std::uint32_t start_corner, start_middle, first, second;
    int last_shift;
};
inline constexpr Mix kLowMix{0x9E37'79B9, 0x3C6E'F372, 0x7FEB'352D, 0x846C'A68B, 16};
inline constexpr Mix kHighMix{0x7F4A'7C15, 0xDAA6'6D2B, 0x21F0'AAAD, 0xD35A'2D97, 15};

[[gnu::always_inline]] inline std::uint32_t mix(std::uint32_t x, const Mix& how) noexcept {
    x = (x ^ (x >> 16)) * how.first;
    x = (x ^ (x >> 15)) * how.second;
    return x ^ (x >> how.last_shift);
}

[[gnu::always_inline]] inline std::uint64_t corner_key(std::uint32_t node) noexcept {
    return pair(mix(node ^ kLowMix.start_corner, kLowMix), mix(node ^ kHighMix.start_corner, kHighMix));
}

/// What a middle adds; nothing where it is left out.
[[gnu::always_inline]] inline std::uint64_t middle_key(std::uint32_t node) noexcept {
    if (node == raw(kNoNode)) return 0;
    return pair(mix(node ^ kLowMix.start_middle, kLowMix), mix(node ^ kHighMix.start_middle, kHighMix));
}

/// `sum`: of the keys of three corners; `middles`: of the keys of the middles, in whatever order.
[[gnu::always_inline]] inline std::uint64_t triangle_value(
    std::uint64_t sum, std::uint64_t middles, bool negative
) noexcept {
    const std::uint64_t all = sum + middles;
    const std::uint64_t value = fold_halves(all, all ^ kTriangle);
    return negative ? 0 - value : value;
}

/// `ac`, `bd`: sums of the keys at the ends of the diagonals, which are the same whichever corner comes
/// first.
[[gnu::always_inline]] inline std::uint64_t quad_value(
    std::uint64_t ac, std::uint64_t bd, std::uint64_t middles, bool negative
) noexcept {
    const std::uint64_t value = fold_halves(ac + middles, bd + middles);
    return negative ? 0 - value : value;
}

[[gnu::always_inline]] inline FacetHash triangle(
    std::array<std::uint32_t, 3> n, std::array<std::uint64_t, 3> keys, std::uint64_t middles
) noexcept {
    const bool odd = (n[0] < n[1]) ^ (n[1] < n[2]) ^ (n[0] < n[2]);
    const std::uint64_t sum = keys[0] + keys[1] + keys[2];
    return {std::min(n[0], std::min(n[1], n[2])), triangle_value(sum, middles, odd), sum};
}

[[gnu::always_inline]] inline FacetHash quad(
    std::array<std::uint32_t, 4> n, std::array<std::uint64_t, 4> keys, std::uint64_t middles
) noexcept {
    // Going round the other way swaps the ends of one diagonal; going on by one corner swaps the diagonals
    // and the ends of one.
    const std::uint32_t low_ac = std::min(n[0], n[2]);
    const std::uint32_t low_bd = std::min(n[1], n[3]);
    const bool negative = (n[0] < n[2]) ^ (n[1] < n[3]) ^ (low_bd < low_ac);
    const std::uint64_t ac = keys[0] + keys[2], bd = keys[1] + keys[3];
    return {std::min(low_ac, low_bd), quad_value(ac, bd, middles, negative), ac + bd};
}

inline FacetHash of(const Outline& outline) noexcept {
    if (outline.count == 0) return {};
    std::array<std::uint32_t, 4> n{};
    std::array<std::uint64_t, 4> keys{};
    std::uint64_t middles = 0;
    for (std::size_t i = 0; i < outline.count; ++i) {
        n[i] = raw(outline.corners[i]);
        keys[i] = corner_key(n[i]);
        middles += middle_key(raw(outline.middles[i]));
    }
    if (outline.count == 4) return quad(n, keys, middles);
    return triangle({n[0], n[1], n[2]}, {keys[0], keys[1], keys[2]}, middles);
}

/// Keys of an element's nodes, those of middles after those of corners.
using ElementKeys = std::array<std::uint64_t, kMaxElementNodes>;
[[gnu::always_inline]] inline ElementKeys keys_of(
    const ElementRow& row, std::span<const NodeIndex> nodes
) noexcept {
    ElementKeys keys;
    for (std::size_t i = 0; i < row.corner_count; ++i) keys[i] = corner_key(raw(nodes[i]));
    for (std::size_t i = row.corner_count; i < row.node_count; ++i) keys[i] = middle_key(raw(nodes[i]));
    return keys;
}

/// Facet `row` of an element. A quad's centre node does not count: brick20 and brick27 may be neighbours.
[[gnu::always_inline]] inline FacetHash of(
    const FacetRow& row, std::span<const NodeIndex> nodes, const ElementKeys& keys
) noexcept {
    const bool is_triangle = row.type == ElementType::Tri3 || row.type == ElementType::Tri6;
    const bool is_quadratic = row.type != ElementType::Tri3 && row.type != ElementType::Quad4;
    const std::size_t corners = is_triangle ? 3 : 4;
    std::array<std::uint32_t, 4> n{};
    std::array<std::uint64_t, 4> k{};
    std::uint64_t middles = 0;
    for (std::size_t i = 0; i < corners; ++i) {
        n[i] = raw(nodes[row.nodes[i]]);
        k[i] = keys[row.nodes[i]];
        if (is_quadratic) middles += keys[row.nodes[corners + i]];
    }
    if (is_triangle) {
        if (n[0] == n[1] || n[1] == n[2] || n[2] == n[0]) return {};
        return triangle({n[0], n[1], n[2]}, {k[0], k[1], k[2]}, middles);
    }
    const bool repeats =
        n[0] == n[1] || n[1] == n[2] || n[2] == n[3] || n[3] == n[0] || n[0] == n[2] || n[1] == n[3];
    return repeats ? of(outline_of(row, nodes)) : quad(n, k, middles);
}

/// Whether an element may have a corner twice on a facet.
[[gnu::always_inline]] inline bool repeats(const ElementRow& row, std::span<const NodeIndex> nodes) noexcept {
    bool any = false;
    for (std::size_t i = 0; i < row.corner_count; ++i) {
        for (std::size_t k = i + 1; k < row.corner_count; ++k) any = any || nodes[i] == nodes[k];
    }
    return any;
}

/// Any facet `row` of an element.
inline FacetHash of(const FacetRow& row, std::span<const NodeIndex> nodes) noexcept {
    return of(outline_of(row, nodes));
}

}  // namespace facet_hash
}  // namespace feelem
