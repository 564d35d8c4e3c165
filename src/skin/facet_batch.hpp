// SPDX-License-Identifier: Apache-2.0
// The hashes of many facets at once: as the processor does it best, with the same outcome everywhere.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace feelem {

enum class FacetHashes : std::uint8_t {
    Signed,   ///< FacetBatch::hashes.
    Corners,  ///< FacetBatch::corners.
    Both,
};

/// Facet f of element e of the batch stands at e * (facets of an element) + f.
struct FacetBatch {
    static constexpr std::size_t kElements = 64;  ///< At most.
    static constexpr std::size_t kFacets = kElements * 6;
    static constexpr std::size_t kSlack = 8;              ///< Whole registers are stored.
    std::array<std::uint64_t, kFacets + kSlack> hashes;   ///< FacetHash::value; 0: the facet collapses.
    std::array<std::uint64_t, kFacets + kSlack> corners;  ///< FacetHash::corners; 0: the facet collapses.
    std::array<std::uint32_t, kFacets + kSlack> lowest;   ///< Smallest corner; 0 of facets that collapse.
    bool may_repeat = false;  ///< Set once an element had a corner twice on a facet; never reset.
};

/// Elements of one solid type, which follow each other from `nodes` on.
struct ElementRun {
    ElementType type;
    const NodeIndex* nodes;
    std::size_t count;  ///< At most FacetBatch::kElements.
};

void hash_facets(ElementRun run, FacetHashes what, FacetBatch& out);

/// Asks memory for elements that come some way after `nodes`, maybe after the last one: processors by
/// themselves look no further than a page.
[[gnu::always_inline]] inline void fetch_elements_after(const NodeIndex* nodes) noexcept {
    constexpr std::uintptr_t kAhead = 1024;
    __builtin_prefetch(reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(nodes) + kAhead));
}

/// What hash_facets chooses from; tests compare them. The others do nothing and say false where the processor
/// or the type are not for them.
void hash_facets_portably(ElementRun run, FacetHashes what, FacetBatch& out, std::size_t first = 0);
bool hash_facets_with_avx2(ElementRun run, FacetHashes what, FacetBatch& out);
bool hash_facets_with_avx512(ElementRun run, FacetHashes what, FacetBatch& out);

}  // namespace feelem
