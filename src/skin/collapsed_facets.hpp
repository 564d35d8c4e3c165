// SPDX-License-Identifier: Apache-2.0
// What the fast twins of hash_facets share: quads with a corner twice.
#pragma once

#include "skin/facet_batch.hpp"
#include "skin/facet_hash.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace feelem {

/// The facets whose bits are set are quads with a corner twice: what is left of each when sides without a
/// length go (outline_of), a triangle or nothing. `key_of(i)`: of the element's corner i.
template <FacetHashes kWhat, class KeyOf>
void hash_collapsed(
    unsigned facets,
    const ElementRow& row,
    const NodeIndex* nodes,
    KeyOf key_of,
    FacetBatch& out,
    std::size_t first
) {
    for (; facets != 0; facets &= facets - 1) {
        const auto f = static_cast<std::size_t>(std::countr_zero(facets));
        const auto& at = row.facets[f].nodes;
        std::array<std::uint32_t, 3> corners{};
        std::array<std::uint64_t, 3> corner_keys{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (nodes[at[i]] == nodes[at[(i + 1) % 4]]) continue;
            corners[count % 3] = raw(nodes[at[i]]);
            corner_keys[count % 3] = key_of(at[i]);
            ++count;
        }
        // Four: opposite corners are one, and it is folded.
        const FacetHash hash = count == 3 ? facet_hash::triangle(corners, corner_keys, 0) : FacetHash{};
        if (kWhat != FacetHashes::Corners) out.hashes[first + f] = hash.value;
        if (kWhat != FacetHashes::Signed) out.corners[first + f] = hash.corners;
        out.lowest[first + f] = hash.lowest;
    }
}

}  // namespace feelem
