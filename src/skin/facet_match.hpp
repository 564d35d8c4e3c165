// SPDX-License-Identifier: Apache-2.0
// The exact half of the search for outer facets: candidates matched by their corners.
#pragma once

#include "skin/facet_cancellation.hpp"
#include "skin/outline.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace feelem {

/// Corners in ascending order; a triangle's fourth is kNoNode.
using FacetKey = std::array<NodeIndex, 4>;
FacetKey sorted_corners(const Outline& outline) noexcept;

struct FacetCandidate {
    FacetKey key{};
    std::uint64_t hash = 0;  ///< Signed: two owners that agree add up to 0.
    FacetRef ref;
};

/// Fills `found`: the outer facets in the candidates' order, and what was noticed of the others. All owners
/// of a facet are among the candidates, or none.
void match_facets(const Mesh& mesh, std::span<const FacetCandidate> candidates, OuterFacets& found);

}  // namespace feelem
