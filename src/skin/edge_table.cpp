// SPDX-License-Identifier: Apache-2.0
// Must: be exact, in order of first use, and fast where the surface is the model (a thin plate). Assumes:
// little. Algorithm: each edge stands at its lower end, in a hash table that follows the order of nodes
// (node_buckets.hpp). Data: 12 bytes a side.
#include "skin/edge_table.hpp"

#include "base/huge_pages.hpp"
#include "skin/facet_hash.hpp"
#include "skin/node_buckets.hpp"

#include <algorithm>

namespace feelem {
namespace {

struct EdgeSlot {
    NodeIndex high{}, middle{};  ///< With the bucket's node: the edge.
    std::uint32_t entry = 0;     ///< Edge + 1.
};

struct Side {
    NodeIndex low, high, middle;
};

Side side_of(const Outline& facet, std::size_t i) {
    const NodeIndex a = facet.corners[i];
    const NodeIndex b = facet.corners[facet.after(i)];
    return {std::min(a, b), std::max(a, b), facet.middles[i]};
}

std::uint32_t hash_of(const Side& side) {
    using namespace facet_hash;
    return static_cast<std::uint32_t>(fold(pair(raw(side.high), raw(side.middle)) ^ kPair, kTriangle) >> 32U);
}

template <class Visit>
void for_each_side(std::span<const Outline> facets, Visit visit) {
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
        for (std::uint32_t i = 0; i < facets[f].count; ++i) visit(f * 4 + i, side_of(facets[f], i));
    }
}

/// The lower ends of all sides.
NodeRanks rank_lower_ends(std::span<const Outline> facets) {
    NodeIndex last{0};
    for (const Outline& facet : facets) {
        for (std::size_t i = 0; i < facet.count; ++i) last = std::max(last, facet.corners[i]);
    }
    NodeRanks ranks(std::size_t{raw(last)} + 1);
    for_each_side(facets, [&](std::uint32_t, const Side& side) { ranks.mark(side.low); });
    ranks.seal();
    return ranks;
}

}  // namespace

EdgeTable find_edges(std::span<const Outline> facets) {
    EdgeTable out;
    reserve_big(out.next, facets.size() * 4);
    out.next.assign(facets.size() * 4, kNoSide);
    const NodeRanks ranks = rank_lower_ends(facets);
    NodeBuckets<EdgeSlot> buckets(ranks.count());
    for_each_side(facets, [&](std::uint32_t, const Side& side) { buckets.count(ranks(side.low)); });
    buckets.seal();
    reserve_big(out.first, facets.size() * 2);
    std::vector<std::uint32_t> last;  // per edge
    reserve_big(last, facets.size() * 2);
    for_each_side(facets, [&](std::uint32_t number, const Side& side) {
        EdgeSlot& slot = buckets.slot(ranks(side.low), hash_of(side), [&](const EdgeSlot& there) {
            return there.high == side.high && there.middle == side.middle;
        });
        if (slot.entry != 0) {
            std::uint32_t& end = last[slot.entry - 1];
            out.next[end] = number;
            end = number;
            return;
        }
        out.first.push_back(number);
        last.push_back(number);
        slot = {side.high, side.middle, static_cast<std::uint32_t>(out.first.size())};
    });
    return out;
}

}  // namespace feelem
