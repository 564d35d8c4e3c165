// SPDX-License-Identifier: Apache-2.0
// Must: find exactly the facets with one owner, in element order, whatever the thread count, in little
// memory. Assumes: both owners of a facet name the same nodes, and wind round it in opposite directions.
// Algorithm: pass 1 adds each facet's signed hash (facet_hash.hpp) at its smallest corner; a facet with two
// owners cancels, so that only nodes on the skin keep a rest. Pass 2 looks at the facets of those nodes alone
// and matches them exactly by their corners (facet_match.cpp). Duplicates, inverted elements, third owners
// and unequal mid-side nodes do not cancel either, so that finding them costs nothing where there are none. A
// facet is missed only if the hashes at a node add up to zero by chance: 2^-64 a node.
// Data: 8 bytes a node in pass 1; 1 bit a node, 1 byte an element and the table of candidates in pass 2.
#include "skin/facet_cancellation.hpp"

#include "base/huge_pages.hpp"
#include "base/parallel.hpp"
#include "skin/facet_batch.hpp"
#include "skin/facet_match.hpp"
#include "skin/node_buckets.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

namespace feelem {
namespace {

/// How many sums before its turn a sum is fetched from memory.
constexpr std::size_t kAhead = 24;
/// Elements that are passed over together when none of them is on the skin.
constexpr std::size_t kBytesAtOnce = sizeof(std::uint64_t);
/// Elements whose candidates wait in the cache to be matched.
constexpr std::size_t kCandidateChunk = 4096;

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

/// Calls visit(run, position of its first element) for elements [first, last) that are not set aside.
template <class Visit>
void for_each_run(
    const SolidBlock& solids,
    const std::vector<bool>& set_aside,
    std::array<std::size_t, 2> range,
    Visit visit
) {
    for (std::size_t i = range[0]; i < range[1];) {
        std::size_t end = i;
        const std::size_t last = std::min(range[1], i + FacetBatch::kElements);
        while (end < last && !is_set_aside(set_aside, solids, end)) ++end;
        if (end > i) visit(ElementRun{solids.block->type, solids.nodes(i).data(), end - i}, i);
        i = end > i ? end : end + 1;
    }
}

/// What pass 1 notices.
struct Noticed {
    std::atomic<std::uint64_t> collapsed{0};
    std::atomic<bool> may_repeat{false};  ///< FacetBatch::may_repeat.
};

/// Sums that one thread alone adds to.
class OwnSums {
public:
    explicit OwnSums(std::uint64_t* sums) : sums_(sums) {}
    void add(std::uint32_t node, std::uint64_t hash) { sums_[node] += hash; }

private:
    std::uint64_t* sums_;
};

/// Sums that other threads add to. What is added to the same node soon after, which most often leaves
/// nothing, is joined in the cache, since an addition that others see costs as much as many that they do not.
class SharedSums {
public:
    explicit SharedSums(std::uint64_t* sums) : sums_(sums) {}
    SharedSums(const SharedSums&) = delete;
    SharedSums& operator=(const SharedSums&) = delete;
    ~SharedSums() {
        for (const Line& line : lines_) pass_on(line);
    }
    void add(std::uint32_t node, std::uint64_t hash) {
        Line& line = lines_[node % lines_.size()];
        if (line.node != node) {
            pass_on(line);
            line = {0, node};
        }
        line.sum += hash;
    }

private:
    struct Line {
        std::uint64_t sum = 0;
        std::uint32_t node = 0;
    };
    void pass_on(const Line& line) {
        if (line.sum != 0) std::atomic_ref(sums_[line.node]).fetch_add(line.sum, std::memory_order_relaxed);
    }

    std::uint64_t* sums_;
    std::array<Line, 1024> lines_{};
};

/// Adds the facets of elements [first, last) at their smallest corners.
template <class Sums>
void add_hashes(
    const SolidBlock& solids,
    const std::vector<bool>& set_aside,
    std::array<std::size_t, 2> range,
    std::uint64_t* memory,
    Noticed& noticed
) {
    Sums sums(memory);
    std::uint64_t collapsed = 0;
    FacetBatch batch;
    for_each_run(solids, set_aside, range, [&](ElementRun run, std::size_t) {
        hash_facets(run, FacetHashes::Signed, batch);
        const std::size_t count = run.count * solids.row->facet_count;
        const auto fetch = [&](std::size_t i) { __builtin_prefetch(&memory[batch.lowest[i]], 1); };
        for (std::size_t i = 0; i < std::min(count, kAhead); ++i) fetch(i);
        for (std::size_t i = 0; i < count; ++i) {
            if (i + kAhead < count) fetch(i + kAhead);
            collapsed += batch.hashes[i] == 0 ? 1U : 0U;  // Adding 0 does no harm.
            sums.add(batch.lowest[i], batch.hashes[i]);
        }
    });
    noticed.collapsed += collapsed;
    if (batch.may_repeat) noticed.may_repeat = true;
}

/// The nodes at which a hash is left.
NodeRanks marked(std::span<const std::uint64_t> sums) {
    std::vector<std::uint64_t> words((sums.size() + 63) / 64);
    parallel_chunks(words.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const auto here = sums.subspan(i * 64, std::min<std::size_t>(sums.size() - i * 64, 64));
            std::uint64_t any = 0;
            for (const std::uint64_t sum : here) any |= sum;
            for (std::size_t k = 0; any != 0 && k < here.size(); ++k)
                words[i] |= std::uint64_t{here[k] != 0} << k;
        }
    });
    return NodeRanks(std::move(words));
}

NodeRanks nodes_with_a_rest(
    const Mesh& mesh,
    const std::vector<SolidBlock>& blocks,
    const std::vector<bool>& set_aside,
    Noticed& noticed,
    OuterFacets& found
) {
    ZeroedArray<std::uint64_t> sums(mesh.node_count());
    const bool is_shared = thread_count() > 1;
    for (const SolidBlock& solids : blocks) {
        const std::size_t count = solids.block->ids.size();
        found.in += count * solids.row->facet_count;
        for (std::size_t i = 0; !set_aside.empty() && i < count; ++i) {
            if (is_set_aside(set_aside, solids, i)) found.of_set_aside += solids.row->facet_count;
        }
        parallel_chunks(count, kParallelChunk, [&](std::size_t first, std::size_t last) {
            const std::array range{first, last};
            is_shared ? add_hashes<SharedSums>(solids, set_aside, range, sums.data(), noticed)
                      : add_hashes<OwnSums>(solids, set_aside, range, sums.data(), noticed);
        });
    }
    found.collapsed = noticed.collapsed;
    return marked(sums.span());
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
            if (batch.hashes[at] == 0 || !marks.has(batch.lowest[at])) continue;
            const FacetRef ref{survivors.positions[e], solids.index, facet};
            found[end++] = {batch.hashes[at], marks(NodeIndex{batch.lowest[at]}), ref};
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
                    if (i + kAhead < part.size()) table.fetch(part[i + kAhead]);
                    visit(part[i]);
                }
                part.clear();
            }
        }
    }
}

/// The outer facets in order.
void collect(const std::vector<SolidBlock>& blocks, const FacetTable& table, OuterFacets& found) {
    reserve_big(found.outer, table.outer_count());
    for (const SolidBlock& solids : blocks) {
        const auto bits_of = table.outer_facets().subspan(solids.first_element, solids.block->ids.size());
        for (std::size_t i = 0; i < bits_of.size();) {
            std::uint64_t many = 1;
            if (i + kBytesAtOnce <= bits_of.size()) std::memcpy(&many, &bits_of[i], kBytesAtOnce);
            const std::size_t end = many == 0 ? i : std::min(i + kBytesAtOnce, bits_of.size());
            for (; i < end; ++i) {
                for (unsigned bits = bits_of[i]; bits != 0; bits &= bits - 1) {
                    const auto facet = static_cast<std::uint8_t>(std::countr_zero(bits));
                    found.outer.push_back({static_cast<std::uint32_t>(i), solids.index, facet});
                }
            }
            if (many == 0) i += kBytesAtOnce;
        }
    }
}

}  // namespace

OuterFacets find_outer_facets(const Mesh& mesh, const std::vector<bool>& set_aside) {
    OuterFacets found;
    const std::vector<SolidBlock> blocks = solid_blocks(mesh);
    if (blocks.empty()) return found;
    Noticed noticed;
    const NodeRanks marks = nodes_with_a_rest(mesh, blocks, set_aside, noticed, found);
    FacetTable table(mesh, marks.count());
    for_each_candidate(table, marks, blocks, set_aside, [&](const FacetCandidate& candidate) {
        ++found.candidates;
        table.add(candidate);
    });
    found.probes = table.probes();
    if (table.special_count() > 0) {
        std::vector<FacetTable::SpecialOwner> owners;
        for_each_candidate(table, marks, blocks, set_aside, [&](const FacetCandidate& candidate) {
            const std::uint64_t place = table.special_place(candidate);
            if (place != FacetTable::kNotSpecial) owners.push_back({place, candidate.ref});
        });
        table.judge_specials(std::move(owners), found);
    }
    if (!found.duplicates) {
        collect(blocks, table, found);
        // A quad and the two triangles before it are three facets.
        found.unmatched += 3 * count_quads_facing_triangles(mesh, found.outer, noticed.may_repeat);
    }
    found.inner = found.in - found.outer.size() - found.many_owners - found.collapsed - found.of_set_aside;
    return found;
}

}  // namespace feelem
