// SPDX-License-Identifier: Apache-2.0
// Which sides of the kept facets lie on the same edge.
#pragma once

#include "skin/outline.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace feelem {

inline constexpr std::uint32_t kNoSide = 0xFFFF'FFFF;

/// Side i of facet f has the number 4 f + i. Sides are on one edge when they join the same two corners, in
/// either direction, through the same middle.
struct EdgeTable {
    std::vector<std::uint32_t> first;  ///< Per edge, in order of first use: its first side.
    std::vector<std::uint32_t> next;   ///< Per side: the next one on its edge, ascending; kNoSide at the end.
};
EdgeTable find_edges(std::span<const Outline> facets);

inline std::uint32_t facet_of_side(std::uint32_t side) noexcept {
    return side / 4;
}
/// Whether the side runs from its smaller to its larger node index.
inline bool runs_up(std::span<const Outline> facets, std::uint32_t side) noexcept {
    const Outline& facet = facets[side / 4];
    return facet.corners[side % 4] < facet.corners[facet.after(side % 4)];
}

}  // namespace feelem
