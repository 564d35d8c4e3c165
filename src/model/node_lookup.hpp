// SPDX-License-Identifier: Apache-2.0
// Node id -> index for many look-ups: a dense table where ids are dense, else a search.
#pragma once

#include "feelem/ids.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace feelem {

class NodeLookup {
public:
    /// `sorted_ids` strictly ascending; not copied, keep it alive.
    explicit NodeLookup(std::span<const NodeId> sorted_ids);
    /// kNoNode when there is no such node.
    NodeIndex operator()(NodeId id) const noexcept {
        const auto offset = static_cast<std::uint64_t>(raw(id)) - static_cast<std::uint64_t>(first_);
        if (consecutive_)
            return offset < ids_.size() ? NodeIndex{static_cast<std::uint32_t>(offset)} : kNoNode;
        if (!dense_.empty()) return offset < dense_.size() ? dense_[offset] : kNoNode;
        return search(id);
    }
    /// All of them to `out`; false when one is not there. The same as one after the other, without a branch
    /// each.
    bool find(std::span<const std::int64_t> ids, NodeIndex* out) const noexcept;
    bool find(std::span<const std::uint32_t> ids, NodeIndex* out) const noexcept;
    /// Of ids in memory that will hold indices.
    bool find(std::span<const NodeIndex> ids, NodeIndex* out) const noexcept;
    /// The id behind an index that was found.
    NodeId id(NodeIndex index) const noexcept { return ids_[raw(index)]; }

private:
    template <class Id>
    bool find_all(std::span<const Id> ids, NodeIndex* out) const noexcept;
    NodeIndex search(NodeId id) const noexcept;

    std::span<const NodeId> ids_;
    std::int64_t first_ = 0;
    bool consecutive_ = false;      ///< ids are first, first + 1, ...: no table needed.
    std::vector<NodeIndex> dense_;  ///< By id - first_, when at most 4 times as long as ids_.
};

}  // namespace feelem
