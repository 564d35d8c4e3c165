// SPDX-License-Identifier: Apache-2.0
// A solid as tetrahedra: each triangle that the skin would draw of a facet, with the element's centre.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace feelem {

/// Nodes, halves of edges, middles of quads, the centre.
inline constexpr std::size_t kMostSolidPoints = kMaxElementNodes + 12 + 6 + 1;

/// A point between the nodes of an element.
struct BetweenNodes {
    std::vector<std::uint8_t> nodes;
    std::vector<double> weights;
};

/// Point i is node i while there are so many nodes, then `between` goes on.
struct Tetrahedra {
    std::size_t node_count = 0;
    std::vector<BetweenNodes> between;
    std::vector<std::array<std::uint8_t, 4>>
        corners;  ///< The first three look outward, the last is the centre.
    /// How far a point between may lie beyond the extremes of the nodes, in parts of the way between these.
    double overshoot = 0;
};

/// `local` has, for each node of the element, the first node of the element that is the same, or kNoNode for
/// one that is missing.
Tetrahedra tetrahedra_of(ElementType type, std::span<const NodeIndex> local);
/// Of an element whose nodes are all there and different. Made once.
const Tetrahedra& whole_tetrahedra(ElementType type);

}  // namespace feelem
