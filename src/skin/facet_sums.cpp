// SPDX-License-Identifier: Apache-2.0
#include "skin/facet_sums.hpp"

#include "base/parallel.hpp"
#include "skin/facet_batch.hpp"

#include <algorithm>
#include <array>
#include <atomic>

namespace feelem {
namespace {

/// What is noticed on the way.
struct Noticed {
    std::atomic<std::uint64_t> collapsed{0};
    std::atomic<bool> may_repeat{false};
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
        if (are_far_apart(batch, count)) {
            for (std::size_t i = 0; i < count; ++i) __builtin_prefetch(&memory[batch.lowest[i]], 1);
        }
        for (std::size_t i = 0; i < count; ++i) {
            collapsed += batch.hashes[i] == 0 ? 1U : 0U;  // Adding 0 does no harm.
            sums.add(batch.lowest[i], batch.hashes[i]);
        }
    });
    noticed.collapsed += collapsed;
    if (batch.may_repeat) noticed.may_repeat = true;
}

}  // namespace

bool are_far_apart(const FacetBatch& batch, std::size_t count) {
    constexpr std::size_t kStep = 16;
    constexpr std::uint32_t kNear = 1U << 14U;
    std::uint32_t lowest = ~std::uint32_t{0}, highest = 0;
    for (std::size_t i = 0; i < count; i += kStep) {
        lowest = std::min(lowest, batch.lowest[i]);
        highest = std::max(highest, batch.lowest[i]);
    }
    return highest - lowest > kNear;
}

FacetSums sum_facets(
    const Mesh& mesh, const std::vector<SolidBlock>& blocks, const std::vector<bool>& set_aside
) {
    FacetSums sums{ZeroedArray<std::uint64_t>(mesh.node_count())};
    Noticed noticed;
    const bool is_shared = thread_count() > 1;
    for (const SolidBlock& solids : blocks) {
        const std::size_t count = solids.block->ids.size();
        sums.in += count * solids.row->facet_count;
        for (std::size_t i = 0; !set_aside.empty() && i < count; ++i) {
            if (is_set_aside(set_aside, solids, i)) sums.of_set_aside += solids.row->facet_count;
        }
        parallel_chunks_if(is_shared, count, kParallelChunk, [&](std::size_t first, std::size_t last) {
            const std::array range{first, last};
            is_shared ? add_hashes<SharedSums>(solids, set_aside, range, sums.at_nodes.data(), noticed)
                      : add_hashes<OwnSums>(solids, set_aside, range, sums.at_nodes.data(), noticed);
        });
    }
    sums.collapsed = noticed.collapsed;
    sums.may_repeat = noticed.may_repeat;
    return sums;
}

}  // namespace feelem
