// SPDX-License-Identifier: Apache-2.0
// One side of one element as it really is: without repeated corners, with the mid-side nodes that exist.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"
#include "feelem/mesh.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace feelem {

/// Which side of which element: what the skin keeps of a facet until it is drawn.
struct FacetRef {
    std::uint32_t position = 0;  ///< Of the element within its block.
    std::uint8_t block = 0;
    std::uint8_t facet = 0;
    bool flipped = false;  ///< The element is inverted: turn the facet round so that it looks outward.
};
static_assert(sizeof(FacetRef) == 8);

struct Outline {
    std::array<NodeIndex, 4> corners{kNoNode, kNoNode, kNoNode, kNoNode};
    /// Middle i lies between corner i and the next one; kNoNode: the side is straight.
    std::array<NodeIndex, 4> middles{kNoNode, kNoNode, kNoNode, kNoNode};
    NodeIndex centre = kNoNode;
    std::uint8_t count = 0;  ///< Corners: 3, 4, or 0 when fewer than three differ.

    bool has_middles() const noexcept {
        // kNoNode has all bits set.
        return (raw(middles[0]) & raw(middles[1]) & raw(middles[2]) & raw(middles[3])) != raw(kNoNode);
    }
    std::size_t after(std::size_t corner) const noexcept { return corner + 1 == count ? 0 : corner + 1; }
};

/// `row` is a facet of the element's type.
Outline outline_of(const FacetRow& row, std::span<const NodeIndex> element_nodes) noexcept;
/// The facet that `ref` names, turned round when it is flipped.
Outline outline_of(const Mesh& mesh, FacetRef ref) noexcept;
/// Nodes of the element that `ref` names.
std::span<const NodeIndex> element_nodes(const Mesh& mesh, FacetRef ref) noexcept;

/// Asks memory for the corners of the element of a facet some way after `i`, and for their coordinates at
/// half that way: elements on the skin lie far apart.
void fetch_elements(const Mesh& mesh, std::span<const FacetRef> facets, std::size_t i) noexcept;
/// Asks for the coordinates of a facet some way after `i`.
inline void fetch_places(
    std::span<const Outline> facets, std::size_t i, std::span<const Point3> coordinates
) noexcept {
    constexpr std::size_t kAhead = 8;
    if (i + kAhead >= facets.size()) return;
    const Outline& facet = facets[i + kAhead];
    for (std::size_t k = 0; k < facet.count; ++k) {
        __builtin_prefetch(&coordinates[raw(facet.corners[k])]);
        if (facet.middles[k] != kNoNode) __builtin_prefetch(&coordinates[raw(facet.middles[k])]);
    }
}

/// Whether the node's coordinates are known.
bool has_place(const Mesh& mesh, NodeIndex node) noexcept;

/// Whether the outlines, which have the same corners, have the same middles between them.
bool same_middles(const Outline& a, const Outline& b) noexcept;

}  // namespace feelem
