// SPDX-License-Identifier: Apache-2.0
// A hash table whose slots lie in the order of nodes: what belongs to neighbouring nodes is found in
// neighbouring memory, which one table for all would scatter. Filled in three steps: count() everything,
// seal(), then slot() as often as it was counted.
#pragma once

#include "base/huge_pages.hpp"

#include "feelem/ids.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace feelem {

/// How many bits are set: in line where the processor's instruction for it may not be assumed.
inline std::uint32_t ones(std::uint64_t x) noexcept {
    x -= (x >> 1) & 0x5555'5555'5555'5555ULL;
    x = (x & 0x3333'3333'3333'3333ULL) + ((x >> 2) & 0x3333'3333'3333'3333ULL);
    x = (x + (x >> 4)) & 0x0F0F'0F0F'0F0F'0F0FULL;
    return static_cast<std::uint32_t>((x * 0x0101'0101'0101'0101ULL) >> 56);
}

/// The nodes that were marked, numbered in their order.
class NodeRanks {
public:
    explicit NodeRanks(std::size_t node_count) : bits_(node_count / 64 + 1) {}
    /// Node i is marked when bit i % 64 of word i / 64 is set.
    explicit NodeRanks(std::vector<std::uint64_t> bits) : bits_(std::move(bits)) { seal(); }

    void mark(NodeIndex node) { bits_[raw(node) / 64] |= std::uint64_t{1} << (raw(node) % 64); }
    void seal() {
        before_.resize(bits_.size());
        for (std::size_t i = 0; i < bits_.size(); ++i) {
            before_[i] = count_;
            count_ += ones(bits_[i]);
        }
    }
    std::size_t count() const { return count_; }
    bool has(std::uint32_t node) const { return (bits_[node / 64] >> (node % 64)) & 1U; }
    bool has_any(std::span<const NodeIndex> nodes) const {
        std::uint64_t marked = 0;
        for (const NodeIndex node : nodes) marked |= bits_[raw(node) / 64] >> (raw(node) % 64);
        return (marked & 1U) != 0;
    }
    std::uint32_t operator()(NodeIndex node) const {
        // Where all are marked, they need not be counted.
        if (bits_[raw(node) / 64] == ~std::uint64_t{0}) return before_[raw(node) / 64] + raw(node) % 64;
        const std::uint64_t below = bits_[raw(node) / 64] & ((std::uint64_t{1} << (raw(node) % 64)) - 1);
        return before_[raw(node) / 64] + ones(below);
    }

    /// Calls visit with each marked node, ascending.
    template <class Visit>
    void for_each(Visit visit) const {
        for (std::size_t i = 0; i < bits_.size(); ++i) {
            for (std::uint64_t rest = bits_[i]; rest != 0; rest &= rest - 1)
                visit(
                    static_cast<std::uint32_t>(i * 64) + static_cast<std::uint32_t>(std::countr_zero(rest))
                );
        }
    }

private:
    std::vector<std::uint64_t> bits_;
    std::vector<std::uint32_t> before_;
    std::uint32_t count_ = 0;
};

/// `Slot` has a member `entry`, 0 while it is free, as all its bits are. A node's slots are as many as things
/// were counted there, so that they suffice whatever is looked up, and a node that everything hangs on is
/// searched no longer than others.
template <class Slot>
class NodeBuckets {
public:
    explicit NodeBuckets(std::size_t nodes) : first_(big_zeros<std::uint32_t>(nodes + 1)) {}

    void count(std::uint32_t node) { ++first_[node + 1]; }
    void seal() {
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        slots_ = ZeroedArray<Slot>(first_.back());
    }
    /// The slot for which is_same says so, else a free one. `hash`: 32 good bits.
    template <class IsSame>
    Slot& slot(std::uint32_t node, std::uint32_t hash, IsSame is_same) {
        const std::uint32_t begin = first_[node], size = first_[node + 1] - begin;
        std::uint32_t at = begin + static_cast<std::uint32_t>((std::uint64_t{hash} * size) >> 32U);
        while (slots_[at].entry != 0 && !is_same(slots_[at])) at = at + 1 == begin + size ? begin : at + 1;
        return slots_[at];
    }

private:
    std::vector<std::uint32_t> first_;
    ZeroedArray<Slot> slots_{0};
};

}  // namespace feelem
