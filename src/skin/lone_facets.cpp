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

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <utility>

namespace feelem {
namespace {

/// Bits of facets seen at a node, and of their rest; all bits: not to be settled.
constexpr std::uint64_t kRestSeen = std::uint64_t{1} << 63U;
constexpr std::uint64_t kNotSettled = ~std::uint64_t{0};

/// Four bits below kRestSeen.
std::uint64_t bits_of(std::uint64_t hash) {
    return std::uint64_t{1} << (hash % 16) | std::uint64_t{1} << (16 + (hash >> 4U) % 16) |
           std::uint64_t{1} << (32 + (hash >> 8U) % 16) | std::uint64_t{1} << (48 + (hash >> 12U) % 8);
}

/// What nodes have seen, for one thread alone.
class OwnSeen {
public:
    explicit OwnSeen(std::uint64_t* seen) : seen_(seen) {}
    void add(std::uint32_t node, std::uint64_t bits, std::uint64_t rest_seen) {
        const std::uint64_t before = seen_[node];
        const bool again = bits != 0 && (before & bits) == bits;
        seen_[node] = before | bits | rest_seen | (0 - std::uint64_t{again});
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
    void add(std::uint32_t node, std::uint64_t bits, std::uint64_t rest_seen) {
        Line& line = lines_[node % lines_.size()];
        if (line.node != node) {
            pass_on(line);
            line = {0, node};
        }
        OwnSeen(&line.bits).add(0, bits, rest_seen);
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
    const std::size_t facet_count = solids.row->facet_count;
    for_each_run(solids, set_aside, range, [&](ElementRun run, std::size_t first) {
        hash_facets(run, FacetHashes::Both, batch);
        const std::size_t count = run.count * facet_count;
        std::size_t at = 0;
        for (std::size_t e = 0; e < run.count; ++e) {
            std::uint64_t bits = 0;
            for (std::size_t f = 0; f < facet_count; ++f, ++at) {
                if (at + kFacetsAhead < count) {
                    __builtin_prefetch(&sums[batch.lowest[at + kFacetsAhead]]);
                    __builtin_prefetch(&memory[batch.lowest[at + kFacetsAhead]], 1);
                }
                const std::uint64_t hash = batch.hashes[at], rest = sums[batch.lowest[at]];
                if (rest == 0 || hash == 0) continue;
                const bool is_rest = hash == rest, is_positive = hash < kRestSeen;
                bits |= std::uint64_t{is_rest} << f;
                const std::uint64_t kept =
                    0 - std::uint64_t{static_cast<unsigned>(is_rest) | static_cast<unsigned>(is_positive)};
                seen.add(batch.lowest[at], bits_of(batch.corners[at]) & kept, std::uint64_t{is_rest} << 63U);
            }
            outer_bits[solids.first_element + first + e] = static_cast<std::uint8_t>(bits);
        }
    });
}

/// The nodes for which is_marked says so.
template <class IsMarked>
NodeRanks marked(std::size_t nodes, IsMarked is_marked) {
    std::vector<std::uint64_t> words((nodes + 63) / 64);
    parallel_chunks(words.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            std::uint64_t word = 0;
            const std::size_t end = std::min<std::size_t>(nodes - i * 64, 64);
            for (std::size_t k = 0; k < end; ++k) word |= std::uint64_t{is_marked(i * 64 + k)} << k;
            words[i] = word;
        }
    });
    return NodeRanks(std::move(words));
}

}  // namespace

NodeRanks nodes_with_a_rest(std::span<const std::uint64_t> sums) {
    return marked(sums.size(), [&](std::size_t node) { return sums[node] != 0; });
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
        parallel_chunks(solids.block->ids.size(), kParallelChunk, [&](std::size_t first, std::size_t last) {
            const std::array range{first, last};
            is_shared ? look_for_rests<SharedSeen>(solids, set_aside, range, sums, seen.data(), outer_bits)
                      : look_for_rests<OwnSeen>(solids, set_aside, range, sums, seen.data(), outer_bits);
        });
    }
    return marked(sums.size(), [&](std::size_t node) {
        return sums[node] != 0 && (seen[node] < kRestSeen || seen[node] == kNotSettled);
    });
}

}  // namespace feelem
