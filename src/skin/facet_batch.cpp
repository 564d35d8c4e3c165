// SPDX-License-Identifier: Apache-2.0
#include "skin/facet_batch.hpp"

#include "skin/facet_hash.hpp"

#include <span>
#include <utility>

namespace feelem {
namespace {

/// The facets of elements of a type that is known when this is compiled.
template <ElementType kType>
void hash_elements(ElementRun run, FacetHashes what, FacetBatch& out, std::size_t at) {
    const ElementRow& row =
        element_table::kTable[static_cast<std::size_t>(kType)];  // Known, as is all in it.
    const NodeIndex* first = run.nodes;
    for (std::size_t e = 0; e < run.count; ++e, first += row.node_count) {
        fetch_elements_after(first);
        const std::span nodes(first, row.node_count);
        out.may_repeat = out.may_repeat || facet_hash::repeats(row, nodes);
        const facet_hash::ElementKeys keys = facet_hash::keys_of(row, nodes);
        const auto one = [&](const FacetRow& facet) {
            const FacetHash hash = facet_hash::of(facet, nodes, keys);
            if (what != FacetHashes::Corners) out.hashes[at] = hash.value;
            if (what != FacetHashes::Signed) out.corners[at] = hash.corners;
            out.lowest[at++] = hash.lowest;
        };
        [&]<std::size_t... kFacets>(std::index_sequence<kFacets...>) {
            (one(row.facets[kFacets]), ...);
        }
        (std::make_index_sequence<element_table::kTable[static_cast<std::size_t>(kType)].facet_count>());
    }
}

}  // namespace

void hash_facets_portably(ElementRun run, FacetHashes what, FacetBatch& out, std::size_t first) {
    switch (run.type) {
    case ElementType::Tet4: return hash_elements<ElementType::Tet4>(run, what, out, first);
    case ElementType::Tet10: return hash_elements<ElementType::Tet10>(run, what, out, first);
    case ElementType::Pyramid5: return hash_elements<ElementType::Pyramid5>(run, what, out, first);
    case ElementType::Pyramid13: return hash_elements<ElementType::Pyramid13>(run, what, out, first);
    case ElementType::Wedge6: return hash_elements<ElementType::Wedge6>(run, what, out, first);
    case ElementType::Wedge15: return hash_elements<ElementType::Wedge15>(run, what, out, first);
    case ElementType::Wedge18: return hash_elements<ElementType::Wedge18>(run, what, out, first);
    case ElementType::Hex8: return hash_elements<ElementType::Hex8>(run, what, out, first);
    case ElementType::Hex20: return hash_elements<ElementType::Hex20>(run, what, out, first);
    case ElementType::Hex27: return hash_elements<ElementType::Hex27>(run, what, out, first);
    default: return;  // Has no facets that two elements could share.
    }
}

void hash_facets(ElementRun run, FacetHashes what, FacetBatch& out) {
    if (!hash_facets_with_avx512(run, what, out) && !hash_facets_with_avx2(run, what, out))
        hash_facets_portably(run, what, out);
}

}  // namespace feelem
