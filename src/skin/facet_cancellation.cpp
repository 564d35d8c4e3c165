// SPDX-License-Identifier: Apache-2.0
// Must: find exactly the facets with one owner, in element order, whatever the thread count, in little
// memory. Assumes: both owners of a facet name the same nodes, and wind round it in opposite directions.
// Algorithm: pass 1 (facet_sums.cpp) adds each facet's signed hash (facet_hash.hpp) at its smallest corner; a
// facet with two owners cancels, so that only nodes on the skin keep a rest. Where many nodes do, as on thin
// plates, and all elements are linear, pass 2 finds the facets that are the whole rest of their node
// (lone_facets.cpp). Pass 3 looks at the facets of the nodes that are left and matches them exactly by their
// corners (facet_match.cpp). Duplicates, inverted elements, third owners and unequal mid-side nodes do not
// cancel either, so that finding them costs nothing where there are none. A facet is missed only if the
// hashes at a node add up to zero by chance: 2^-64 a node; the stage's check that the skin is closed would
// show it. Data: 8 bytes a node in pass 1, 8 more in pass 2; 1 bit a node, 1 byte an element and the table of
// candidates in pass 3.
#include "skin/facet_cancellation.hpp"

#include "base/huge_pages.hpp"
#include "base/parallel.hpp"
#include "skin/facet_batch.hpp"
#include "skin/facet_match.hpp"
#include "skin/facet_sums.hpp"
#include "skin/lone_facets.hpp"
#include "skin/node_buckets.hpp"
#include "skin/solid_blocks.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

namespace feelem {
namespace {

/// Elements that are passed over together when none of them is on the skin.
constexpr std::size_t kBytesAtOnce = sizeof(std::uint64_t);
/// Elements whose candidates wait in the cache to be matched.
constexpr std::size_t kCandidateChunk = 4096;

constexpr std::size_t kMostFacets = 6;
/// Outer facets that are written together.
constexpr std::size_t kRefsAtOnce = 4096;

/// Calls visit(eight bytes, first, last) for all bytes, a few at a time; the last ones may be fewer.
template <class Visit>
void for_each_eight(std::span<const std::uint8_t> bytes, Visit visit) {
    for (std::size_t i = 0; i < bytes.size(); i += kBytesAtOnce) {
        const std::size_t last = std::min(bytes.size(), i + kBytesAtOnce);
        std::uint64_t eight = 0;
        std::memcpy(&eight, &bytes[i], last - i);
        visit(eight, i, last);
    }
}

/// Elements that have a marked node, next to each other.
struct Survivors {
    std::array<NodeIndex, FacetBatch::kElements * kMaxElementNodes> nodes;
    std::array<std::uint32_t, FacetBatch::kElements> positions;
    std::size_t count = 0;
};

void add_candidates_of(
    const SolidBlock& solids,
    const NodeRanks& marks,
    const Survivors& survivors,
    std::vector<FacetCandidate>& found
) {
    FacetBatch batch;
    hash_facets({solids.block->type, survivors.nodes.data(), survivors.count}, FacetHashes::Corners, batch);
    std::size_t at = 0, end = found.size();
    found.resize(end + survivors.count * solids.row->facet_count);
    for (std::size_t e = 0; e < survivors.count; ++e) {
        for (std::uint8_t facet = 0; facet < solids.row->facet_count; ++facet, ++at) {
            if (batch.corners[at] == 0 || !marks.has(batch.lowest[at])) continue;
            const FacetRef ref{survivors.positions[e], solids.index, facet};
            found[end++] = {batch.corners[at], marks(NodeIndex{batch.lowest[at]}), ref};
        }
    }
    found.resize(end);
}

/// The facets at marked nodes of elements [first, last).
void find_candidates(
    const SolidBlock& solids,
    const NodeRanks& marks,
    const std::vector<bool>& set_aside,
    std::array<std::size_t, 2> range,
    std::vector<FacetCandidate>& found
) {
    Survivors survivors;
    const std::size_t width = solids.row->node_count;
    for_each_run(solids, set_aside, range, [&](ElementRun run, std::size_t first) {
        survivors.count = 0;
        for (std::size_t i = 0; i < run.count; ++i) {
            fetch_elements_after(run.nodes + i * width);
            const std::span nodes(run.nodes + i * width, width);
            if (!marks.has_any(nodes.first(solids.row->corner_count))) continue;
            std::ranges::copy(
                nodes, survivors.nodes.begin() + static_cast<std::ptrdiff_t>(survivors.count * width)
            );
            survivors.positions[survivors.count++] = static_cast<std::uint32_t>(first + i);
        }
        if (survivors.count > 0) add_candidates_of(solids, marks, survivors, found);
    });
}

/// Calls visit for each candidate, in element order: they are found by many threads, a window at a time.
template <class Visit>
void for_each_candidate(
    const FacetTable& table,
    const NodeRanks& marks,
    const std::vector<SolidBlock>& blocks,
    const std::vector<bool>& set_aside,
    Visit visit
) {
    const std::size_t chunks = thread_count() > 1 ? thread_count() * std::size_t{8} : 1;
    std::vector<std::vector<FacetCandidate>> found(chunks);
    for (const SolidBlock& solids : blocks) {
        const std::size_t count = solids.block->ids.size();
        for (std::size_t start = 0; start < count; start += chunks * kCandidateChunk) {
            const std::size_t window = std::min(count - start, chunks * kCandidateChunk);
            parallel_chunks(window, kCandidateChunk, [&](std::size_t first, std::size_t last) {
                find_candidates(
                    solids, marks, set_aside, {start + first, start + last}, found[first / kCandidateChunk]
                );
            });
            for (std::vector<FacetCandidate>& part : found) {
                for (std::size_t i = 0; i < part.size(); ++i) {
                    if (i + kFacetsAhead < part.size()) table.fetch(part[i + kFacetsAhead]);
                    visit(part[i]);
                }
                part.clear();
            }
        }
    }
}

/// The outer facets in order.
void collect(
    const std::vector<SolidBlock>& blocks, std::span<const std::uint8_t> outer_bits, OuterFacets& found
) {
    std::size_t count = 0;
    for_each_eight(outer_bits, [&](std::uint64_t eight, std::size_t, std::size_t) { count += ones(eight); });
    reserve_big(found.outer, count);
    std::vector<FacetRef> here(kRefsAtOnce + kBytesAtOnce * kMostFacets);
    std::size_t end = 0;
    const auto pass_on = [&] {
        found.outer.insert(found.outer.end(), here.begin(), here.begin() + static_cast<std::ptrdiff_t>(end));
        end = 0;
    };
    for (const SolidBlock& solids : blocks) {
        const auto bits_of = outer_bits.subspan(solids.first_element, solids.block->ids.size());
        for_each_eight(bits_of, [&](std::uint64_t eight, std::size_t first, std::size_t last) {
            for (std::size_t i = eight == 0 ? last : first; i < last; ++i) {
                for (unsigned bits = bits_of[i]; bits != 0; bits &= bits - 1) {
                    const auto facet = static_cast<std::uint8_t>(std::countr_zero(bits));
                    here[end++] = {static_cast<std::uint32_t>(i), solids.index, facet};
                }
            }
            if (end >= kRefsAtOnce) pass_on();
        });
        pass_on();
    }
}

/// Matches all facets at the marked nodes; clears or sets their bits.
void match_facets(
    const Mesh& mesh,
    const NodeRanks& marks,
    const std::vector<SolidBlock>& blocks,
    const std::vector<bool>& set_aside,
    std::span<std::uint8_t> outer_bits,
    OuterFacets& found
) {
    FacetTable table(mesh, marks.count(), outer_bits);
    for_each_candidate(table, marks, blocks, set_aside, [&](const FacetCandidate& candidate) {
        ++found.candidates;
        table.add(candidate);
    });
    found.probes = table.probes();
    if (table.special_count() == 0) return;
    std::vector<FacetTable::SpecialOwner> owners;
    for_each_candidate(table, marks, blocks, set_aside, [&](const FacetCandidate& candidate) {
        const std::uint64_t place = table.special_place(candidate);
        if (place != FacetTable::kNotSpecial) owners.push_back({place, candidate.ref});
    });
    table.judge_specials(std::move(owners), found);
}

/// The nodes whose facets have to be matched. Others keep nothing, or one facet, whose bit is set.
NodeRanks nodes_to_match(
    const Mesh& mesh,
    const std::vector<SolidBlock>& blocks,
    const std::vector<bool>& set_aside,
    std::span<std::uint8_t> outer_bits,
    OuterFacets& found,
    bool& may_repeat
) {
    const FacetSums sums = sum_facets(mesh, blocks, set_aside);
    found.in = sums.in;
    found.collapsed = sums.collapsed;
    found.of_set_aside = sums.of_set_aside;
    may_repeat = sums.may_repeat;
    const auto at_nodes = sums.at_nodes.span();
    // Signed hashes do not tell at which side a middle stands; matching does.
    const bool are_linear =
        std::ranges::all_of(blocks, [](const SolidBlock& solids) { return solids.row->order == 1; });
    return are_linear && are_mostly_rests(at_nodes)
               ? settle_lone_facets(blocks, set_aside, at_nodes, outer_bits)
               : nodes_with_a_rest(at_nodes);
}

}  // namespace

OuterFacets find_outer_facets(const Mesh& mesh, const std::vector<bool>& set_aside) {
    OuterFacets found;
    const std::vector<SolidBlock> blocks = solid_blocks(mesh);
    if (blocks.empty()) return found;
    ZeroedArray<std::uint8_t> outer_bits(mesh.element_count());
    const std::span bits(outer_bits.data(), outer_bits.size());
    bool may_repeat = false;
    {
        const NodeRanks marks = nodes_to_match(mesh, blocks, set_aside, bits, found, may_repeat);
        if (marks.count() > 0) match_facets(mesh, marks, blocks, set_aside, bits, found);
    }
    if (!found.duplicates) {
        collect(blocks, bits, found);
        // A quad and the two triangles before it are three facets.
        found.unmatched += 3 * count_quads_facing_triangles(mesh, found.outer, may_repeat);
    }
    found.inner = found.in - found.outer.size() - found.many_owners - found.collapsed - found.of_set_aside;
    return found;
}

}  // namespace feelem
