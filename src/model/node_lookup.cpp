// SPDX-License-Identifier: Apache-2.0
#include "model/node_lookup.hpp"

#include <algorithm>
#include <limits>

namespace feelem {

NodeLookup::NodeLookup(std::span<const NodeId> sorted_ids) : ids_(sorted_ids) {
    if (ids_.empty()) return;
    first_ = raw(ids_.front());
    const auto extent = static_cast<std::uint64_t>(raw(ids_.back())) - static_cast<std::uint64_t>(first_);
    consecutive_ = extent == ids_.size() - 1;
    if (consecutive_ || extent >= 4 * ids_.size()) return;
    dense_.assign(extent + 1, kNoNode);
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        dense_[static_cast<std::size_t>(raw(ids_[i]) - first_)] = NodeIndex{static_cast<std::uint32_t>(i)};
    }
}

NodeIndex NodeLookup::search(NodeId id) const noexcept {
    const auto found = std::ranges::lower_bound(ids_, id);
    if (found == ids_.end() || *found != id) return kNoNode;
    return NodeIndex{static_cast<std::uint32_t>(found - ids_.begin())};
}

bool NodeLookup::find(std::span<const std::int64_t> ids, NodeIndex* out) const noexcept {
    return find_all(ids, out);
}

bool NodeLookup::find(std::span<const std::uint32_t> ids, NodeIndex* out) const noexcept {
    return find_all(ids, out);
}

bool NodeLookup::find(std::span<const NodeIndex> ids, NodeIndex* out) const noexcept {
    return find_all(ids, out);
}

template <class Id>
bool NodeLookup::find_all(std::span<const Id> ids, NodeIndex* out) const noexcept {
    bool missing = false;
    constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max();
    if (consecutive_ && sizeof(Id) == sizeof(std::uint32_t) && first_ >= 0 && raw(ids_.back()) <= kMost) {
        // Ids below the first become larger than any index.
        const auto first = static_cast<std::uint32_t>(first_);
        const auto last = static_cast<std::uint32_t>(ids_.size() - 1);
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const std::uint32_t offset = static_cast<std::uint32_t>(ids[i]) - first;
            missing |= offset > last;
            out[i] = NodeIndex{offset};
        }
        return !missing;
    }
    if (consecutive_) {
        const std::uint64_t count = ids_.size();
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const auto offset = static_cast<std::uint64_t>(ids[i]) - static_cast<std::uint64_t>(first_);
            missing |= offset >= count;
            out[i] = NodeIndex{static_cast<std::uint32_t>(offset)};
        }
        return !missing;
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
        out[i] = (*this)(NodeId{static_cast<std::int64_t>(ids[i])});
        missing |= out[i] == kNoNode;
    }
    return !missing;
}

}  // namespace feelem
