// SPDX-License-Identifier: Apache-2.0
// Which facets of the solids are outer: used by one element only.
#pragma once

#include "skin/outline.hpp"

#include "feelem/mesh.hpp"

#include <cstdint>
#include <vector>

namespace feelem {

/// What became of the facets of the solids. Every facet counts once for each element that has it:
/// in = outer.size() + inner + many_owners + collapsed + of_set_aside.
struct OuterFacets {
    std::vector<FacetRef> outer;  ///< In element order, then facet order.
    std::uint64_t in = 0;
    std::uint64_t inner = 0;
    std::uint64_t many_owners = 0;
    std::uint64_t collapsed = 0;
    std::uint64_t of_set_aside = 0;
    std::uint64_t unmatched = 0;   ///< Of the outer ones: unequal middles, or a quad facing two triangles.
    std::uint64_t candidates = 0;  ///< Facets that were matched by their corners: how much work it was,
    std::uint64_t probes = 0;      ///< and how often one was compared with a place in the table.
    bool same_winding = false;     ///< Two owners wind the same way round: one of them is inverted.
    bool duplicates = false;       ///< Two elements have the same corners: set them aside and ask again.
};

/// `set_aside`: one flag an element (over all blocks), or empty.
OuterFacets find_outer_facets(const Mesh& mesh, const std::vector<bool>& set_aside);

}  // namespace feelem
