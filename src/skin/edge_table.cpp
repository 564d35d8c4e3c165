// SPDX-License-Identifier: Apache-2.0
#include "skin/edge_table.hpp"

#include "skin/facet_hash.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace feelem {
namespace {

using EdgeKey = std::array<NodeIndex, 3>;

EdgeKey key_of(const Outline& facet, std::size_t side) {
    const NodeIndex a = facet.corners[side];
    const NodeIndex b = facet.corners[facet.after(side)];
    return {std::min(a, b), std::max(a, b), facet.middles[side]};
}

std::size_t place_of(const EdgeKey& key, std::size_t mask) {
    using namespace facet_hash;
    return static_cast<std::size_t>(fold(pair(raw(key[0]), raw(key[1])) ^ kPair, raw(key[2]) ^ kTriangle)) &
           mask;
}

}  // namespace

EdgeTable find_edges(std::span<const Outline> facets) {
    EdgeTable out;
    out.next.assign(facets.size() * 4, kNoSide);
    std::vector<std::uint32_t> last;                                         // per edge
    std::vector<std::uint32_t> table(std::bit_ceil(facets.size() * 6 + 1));  // edge + 1; 0: free
    const std::size_t mask = table.size() - 1;
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
        for (std::uint32_t i = 0; i < facets[f].count; ++i) {
            const EdgeKey key = key_of(facets[f], i);
            const auto is_other = [&](std::uint32_t entry) {
                const std::uint32_t side = out.first[entry - 1];
                return key_of(facets[side / 4], side % 4) != key;
            };
            std::size_t place = place_of(key, mask);
            while (table[place] != 0 && is_other(table[place])) place = (place + 1) & mask;
            const std::uint32_t side = f * 4 + i;
            if (table[place] == 0) {
                out.first.push_back(side);
                last.push_back(side);
                table[place] = static_cast<std::uint32_t>(out.first.size());
            } else {
                std::uint32_t& end = last[table[place] - 1];
                out.next[end] = side;
                end = side;
            }
        }
    }
    return out;
}

}  // namespace feelem
