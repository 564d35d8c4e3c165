// SPDX-License-Identifier: Apache-2.0
// Which facets are all that is left at their node: they are outer, without being matched with any other.
#pragma once

#include "base/huge_pages.hpp"
#include "skin/facet_sums.hpp"
#include "skin/node_buckets.hpp"
#include "skin/solid_blocks.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace feelem {

/// The nodes at which something is left.
NodeRanks nodes_with_a_rest(std::span<const std::uint64_t> sums);
/// Whether that is so at many nodes, by a sample of them: then it pays to look for lone facets first.
bool are_mostly_rests(std::span<const std::uint64_t> sums);

/// Sets the bits of lone facets (bit i of an element's byte for facet i) and returns the nodes that are not
/// settled by that: all their facets have to be matched, and bits may be set that are none.
NodeRanks settle_lone_facets(
    const std::vector<SolidBlock>& blocks,
    const std::vector<bool>& set_aside,
    std::span<const std::uint64_t> sums,
    std::span<std::uint8_t> outer_bits
);

}  // namespace feelem
