// SPDX-License-Identifier: Apache-2.0
// Must: find exactly the facets with one owner, in element order, whatever the thread count, in little
// memory. Assumes: both owners of a facet name the same nodes, and wind round it in opposite directions.
// Algorithm: pass 1 adds each facet's signed hash (facet_hash.hpp) at its smallest corner; a facet with two
// owners cancels, so that only nodes on the skin keep a rest. Pass 2 looks at the facets of those nodes alone
// and matches them exactly by their corners (facet_match.cpp). Duplicates, inverted elements, third owners
// and unequal mid-side nodes do not cancel either, so that finding them costs nothing where there are none. A
// facet is missed only if the hashes at a node add up to zero by chance: 2^-64 a node.
// Data: 8 bytes a node in pass 1, 1 bit a node and 32 bytes a candidate in pass 2.
#include "skin/facet_cancellation.hpp"

#include "base/parallel.hpp"
#include "skin/facet_hash.hpp"
#include "skin/facet_match.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

namespace feelem {
namespace {

/// A block of solids and where its elements start in the mesh.
struct SolidBlock {
    const ElementBlock* block = nullptr;
    const ElementRow* row = nullptr;
    std::uint8_t index = 0;
    std::size_t first_element = 0;

    std::span<const NodeIndex> nodes(std::size_t position) const {
        return std::span(block->nodes).subspan(position * row->node_count, row->node_count);
    }
};

std::vector<SolidBlock> solid_blocks(const Mesh& mesh) {
    std::vector<SolidBlock> out;
    std::size_t first = 0;
    for (std::size_t i = 0; i < mesh.blocks.size(); ++i) {
        const ElementRow& row = element_row(mesh.blocks[i].type);
        if (row.dimension == 3) out.push_back({&mesh.blocks[i], &row, static_cast<std::uint8_t>(i), first});
        first += mesh.blocks[i].ids.size();
    }
    return out;
}

bool is_set_aside(const std::vector<bool>& set_aside, const SolidBlock& solids, std::size_t position) {
    return !set_aside.empty() && set_aside[solids.first_element + position];
}

/// One bit a node: whether a hash is left there.
class NodeMarks {
public:
    explicit NodeMarks(const std::vector<std::uint64_t>& sums) : words_((sums.size() + 63) / 64) {
        parallel_chunks(words_.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const std::size_t end = std::min(sums.size(), (i + 1) * 64);
                std::uint64_t word = 0;
                for (std::size_t node = i * 64; node < end; ++node)
                    word |= std::uint64_t{sums[node] != 0} << (node % 64);
                words_[i] = word;
            }
        });
    }

    bool operator()(std::uint32_t node) const { return (words_[node / 64] >> (node % 64)) & 1U; }

    bool any(std::span<const NodeIndex> nodes) const {
        std::uint64_t marked = 0;
        for (const NodeIndex node : nodes) marked |= words_[raw(node) / 64] >> (raw(node) % 64);
        return (marked & 1U) != 0;
    }

private:
    std::vector<std::uint64_t> words_;
};

/// Adds the facets of elements [first, last) at their smallest corners; returns how many collapse. `kShared`:
/// other threads add there too.
template <bool kShared, class Facets>
std::uint64_t add_hashes(
    const Facets& facets,
    const SolidBlock& solids,
    const std::vector<bool>& set_aside,
    std::array<std::size_t, 2> range,
    std::uint64_t* sums
) {
    std::uint64_t collapsed = 0;
    const std::size_t width = solids.row->node_count;
    const NodeIndex* nodes = solids.block->nodes.data() + range[0] * width;
    for (std::size_t i = range[0]; i < range[1]; ++i, nodes += width) {
        if (is_set_aside(set_aside, solids, i)) continue;
        facets.visit(std::span(nodes, width), [&](std::size_t, FacetHash hash) {
            collapsed += hash.value == 0 ? 1U : 0U;  // Adding 0 does no harm.
            if constexpr (kShared) {
                std::atomic_ref(sums[hash.lowest]).fetch_add(hash.value, std::memory_order_relaxed);
            } else {
                sums[hash.lowest] += hash.value;
            }
        });
    }
    return collapsed;
}

NodeMarks nodes_with_a_rest(
    const Mesh& mesh,
    const std::vector<SolidBlock>& blocks,
    const std::vector<bool>& set_aside,
    OuterFacets& found
) {
    std::vector<std::uint64_t> sums(mesh.node_count());
    std::atomic<std::uint64_t> collapsed{0};
    const bool is_shared = thread_count() > 1;
    for (const SolidBlock& solids : blocks) {
        const std::size_t count = solids.block->ids.size();
        found.in += count * solids.row->facet_count;
        for (std::size_t i = 0; !set_aside.empty() && i < count; ++i) {
            if (is_set_aside(set_aside, solids, i)) found.of_set_aside += solids.row->facet_count;
        }
        parallel_chunks(count, kParallelChunk, [&](std::size_t first, std::size_t last) {
            facet_hash::with_facets_of(solids.block->type, [&](const auto& facets) {
                const std::array range{first, last};
                collapsed += is_shared ? add_hashes<true>(facets, solids, set_aside, range, sums.data())
                                       : add_hashes<false>(facets, solids, set_aside, range, sums.data());
            });
        });
    }
    found.collapsed = collapsed;
    return NodeMarks(sums);
}

template <class Facets>
void add_candidates(
    const Facets& facets,
    const NodeMarks& marks,
    const SolidBlock& solids,
    const std::vector<bool>& set_aside,
    std::array<std::size_t, 2> range,
    std::vector<FacetCandidate>& found
) {
    const auto rows = facets_of(solids.block->type);
    for (std::size_t i = range[0]; i < range[1]; ++i) {
        const auto nodes = solids.nodes(i);
        if (!marks.any(nodes.first(solids.row->corner_count)) || is_set_aside(set_aside, solids, i)) continue;
        facets.visit(nodes, [&](std::size_t facet, FacetHash hash) {
            if (hash.value == 0 || !marks(hash.lowest)) return;
            const FacetRef ref{static_cast<std::uint32_t>(i), solids.index, static_cast<std::uint8_t>(facet)};
            found.push_back({sorted_corners(outline_of(rows[facet], nodes)), hash.value, ref});
        });
    }
}

std::vector<FacetCandidate> candidates_at(
    const NodeMarks& marks, const std::vector<SolidBlock>& blocks, const std::vector<bool>& set_aside
) {
    std::vector<FacetCandidate> all;
    for (const SolidBlock& solids : blocks) {
        const std::size_t count = solids.block->ids.size();
        std::vector<std::vector<FacetCandidate>> found((count + kParallelChunk - 1) / kParallelChunk);
        parallel_chunks(count, kParallelChunk, [&](std::size_t first, std::size_t last) {
            facet_hash::with_facets_of(solids.block->type, [&](const auto& facets) {
                add_candidates(
                    facets, marks, solids, set_aside, {first, last}, found[first / kParallelChunk]
                );
            });
        });
        std::size_t total = all.size();
        for (const std::vector<FacetCandidate>& part : found) total += part.size();
        all.reserve(total);
        for (std::vector<FacetCandidate>& part : found) {
            all.insert(all.end(), part.begin(), part.end());
            part = {};
        }
    }
    return all;
}

}  // namespace

OuterFacets find_outer_facets(const Mesh& mesh, const std::vector<bool>& set_aside) {
    OuterFacets found;
    const std::vector<SolidBlock> blocks = solid_blocks(mesh);
    if (blocks.empty()) return found;
    std::vector<FacetCandidate> candidates;
    {
        const NodeMarks marks = nodes_with_a_rest(mesh, blocks, set_aside, found);
        candidates = candidates_at(marks, blocks, set_aside);
    }
    match_facets(mesh, candidates, found);
    found.inner = found.in - found.outer.size() - found.many_owners - found.collapsed - found.of_set_aside;
    return found;
}

}  // namespace feelem
