// SPDX-License-Identifier: Apache-2.0
// Must: settle a node only where matching its facets one by one would say the same. Algorithm: a facet whose
// signed hash is the whole rest of its node is the only one left there, if all others cancelled in pairs.
// They did if no two of them have the same corners and the same sign: what is left is then a sum of hashes of
// different facets, which adds up to that of one of them by chance only (2^-64). So each node remembers the
// facets of one sign, and the one that is its rest, by a few bits of their corners' hashes. A node that seems
// to meet one of them again (three or more owners, other facets on the same corners; now and then two facets
// with the same bits) is not settled, nor is one whose rest is no facet's hash (two outer facets, owners that
// wind the same way round). Data: 8 bytes a node.
#include "skin/lone_facets.hpp"

#include "base/parallel.hpp"
#include "skin/facet_batch.hpp"
#include "skin/rest_batch.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <utility>

namespace feelem {
namespace {

/// What nodes have seen, for one thread alone.
class OwnSeen {
public:
    explicit OwnSeen(std::uint64_t* seen) : seen_(seen) {}
    /// `bits`: of RestBatch::Seen.
    void add(std::uint32_t node, std::uint64_t bits) {
        const std::uint64_t before = seen_[node], of_corners = bits & ~kRestSeen;
        const bool again = (before & of_corners) == of_corners;
        seen_[node] = before | bits | (0 - std::uint64_t{again});
    }

private:
    std::uint64_t* seen_;
};

/// The same where other threads add, too: joined in the cache first, as the sums are.
class SharedSeen {
public:
    explicit SharedSeen(std::uint64_t* seen) : seen_(seen) {}
    SharedSeen(const SharedSeen&) = delete;
    SharedSeen& operator=(const SharedSeen&) = delete;
    ~SharedSeen() {
        for (const Line& line : lines_) pass_on(line);
    }
    void add(std::uint32_t node, std::uint64_t bits) {
        Line& line = lines_[node % lines_.size()];
        if (line.node != node) {
            pass_on(line);
            line = {0, node};
        }
        OwnSeen(&line.bits).add(0, bits);
    }

private:
    struct Line {
        std::uint64_t bits = 0;
        std::uint32_t node = 0;
    };
    void pass_on(const Line& line) {
        if (line.bits == 0) return;
        const std::atomic_ref seen(seen_[line.node]);
        const std::uint64_t before = seen.fetch_or(line.bits, std::memory_order_relaxed);
        // These are the bits of some facets; a facet among them may have been seen if it shares its first.
        constexpr std::uint64_t kFirst = 0xFFFF;
        if ((before & line.bits & kFirst) != 0) seen.fetch_or(kNotSettled, std::memory_order_relaxed);
    }

    std::uint64_t* seen_;
    std::array<Line, 1024> lines_{};
};

/// Elements [first, last).
template <class Seen>
void look_for_rests(
    const SolidBlock& solids,
    const std::vector<bool>& set_aside,
    std::array<std::size_t, 2> range,
    std::span<const std::uint64_t> sums,
    std::uint64_t* memory,
    std::span<std::uint8_t> outer_bits
) {
    Seen seen(memory);
    FacetBatch batch;
    RestBatch rests;
    const std::size_t facet_count = solids.row->facet_count;
    const unsigned all_facets = (1U << facet_count) - 1;
    for_each_run(solids, set_aside, range, [&](ElementRun run, std::size_t first) {
        hash_facets(run, FacetHashes::Both, batch);
        const std::size_t count = run.count * facet_count;
        if (are_far_apart(batch, count)) {
            for (std::size_t i = 0; i < count; ++i) {
                __builtin_prefetch(&sums[batch.lowest[i]]);
                __builtin_prefetch(&memory[batch.lowest[i]], 1);
            }
        }
        compare_with_rests(batch, count, sums, rests);
        for (std::size_t i = 0; i < rests.seen.count; ++i) seen.add(rests.seen.nodes[i], rests.seen.bits[i]);
        for (std::size_t e = 0; e < run.count; ++e) {
            const std::size_t bit = e * facet_count;
            const unsigned two_bytes = rests.is_rest[bit / 8] | unsigned{rests.is_rest[bit / 8 + 1]} << 8U;
            outer_bits[solids.first_element + first + e] =
                static_cast<std::uint8_t>((two_bytes >> (bit % 8)) & all_facets);
        }
    });
}

/// Ranks of the nodes whose bits `find(first, words)` sets, from node `first` on.
template <class Find>
NodeRanks marked(std::size_t nodes, Find find) {
    std::vector<std::uint64_t> words((nodes + 63) / 64);
    parallel_chunks(words.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
        find(first * 64, std::span(words).subspan(first, last - first));
    });
    return NodeRanks(std::move(words));
}

}  // namespace

NodeRanks nodes_with_a_rest(std::span<const std::uint64_t> sums) {
    return marked(sums.size(), [&](std::size_t first, std::span<std::uint64_t> words) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            const auto here =
                sums.subspan(first + i * 64, std::min<std::size_t>(sums.size() - first - i * 64, 64));
            std::uint64_t any = 0;
            for (const std::uint64_t sum : here) any |= sum;
            for (std::size_t k = 0; any != 0 && k < here.size(); ++k)
                words[i] |= std::uint64_t{here[k] != 0} << k;
        }
    });
}

bool are_mostly_rests(std::span<const std::uint64_t> sums) {
    constexpr std::size_t kGroup = 64, kGroups = 256;
    const std::size_t step = std::max<std::size_t>(sums.size() / (kGroup * kGroups), 1) * kGroup;
    std::size_t rests = 0, looked_at = 0;
    for (std::size_t i = 0; i < sums.size(); i += step) {
        const auto group = sums.subspan(i, std::min(kGroup, sums.size() - i));
        looked_at += group.size();
        rests += group.size() - static_cast<std::size_t>(std::ranges::count(group, std::uint64_t{0}));
    }
    return rests * 4 > looked_at;
}

NodeRanks settle_lone_facets(
    const std::vector<SolidBlock>& blocks,
    const std::vector<bool>& set_aside,
    std::span<const std::uint64_t> sums,
    std::span<std::uint8_t> outer_bits
) {
    ZeroedArray<std::uint64_t> seen(sums.size());
    const bool is_shared = thread_count() > 1;
    for (const SolidBlock& solids : blocks) {
        const auto look = [&](std::size_t first, std::size_t last) {
            const std::array range{first, last};
            is_shared ? look_for_rests<SharedSeen>(solids, set_aside, range, sums, seen.data(), outer_bits)
                      : look_for_rests<OwnSeen>(solids, set_aside, range, sums, seen.data(), outer_bits);
        };
        parallel_chunks_if(is_shared, solids.block->ids.size(), kParallelChunk, look);
    }
    return marked(sums.size(), [&](std::size_t first, std::span<std::uint64_t> words) {
        find_unsettled(sums.subspan(first), seen.span().subspan(first), words);
    });
}

}  // namespace feelem
