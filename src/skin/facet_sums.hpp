// SPDX-License-Identifier: Apache-2.0
// What is left at each node when the facets with two owners have cancelled.
#pragma once

#include "base/huge_pages.hpp"
#include "skin/solid_blocks.hpp"

#include "feelem/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace feelem {

/// How many facets before its turn what stands at a facet's node is fetched from memory.
inline constexpr std::size_t kFacetsAhead = 24;

/// Whether the nodes of a batch lie so far apart that their sums have to be asked for; neighbours stay in the
/// cache.
bool are_far_apart(const FacetBatch& batch, std::size_t count);

struct FacetSums {
    ZeroedArray<std::uint64_t>
        at_nodes;  ///< Of the signed hashes of the facets of which it is the smallest corner.
    std::uint64_t in = 0, collapsed = 0, of_set_aside = 0;  ///< As in OuterFacets.
    bool may_repeat = false;                                ///< FacetBatch::may_repeat.
};

/// `set_aside`: one flag an element (over all blocks), or empty.
FacetSums sum_facets(
    const Mesh& mesh, const std::vector<SolidBlock>& blocks, const std::vector<bool>& set_aside
);

}  // namespace feelem
