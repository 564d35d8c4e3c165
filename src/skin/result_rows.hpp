// SPDX-License-Identifier: Apache-2.0
// Which row of a result holds the value of a node, at the place where it is asked for.
#pragma once

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <utility>

namespace feelem {

inline constexpr std::size_t kNoRow = std::numeric_limits<std::size_t>::max();

/// Where a vertex stands: what is needed to find its row, or that of another node there.
struct ResultPlace {
    PartIndex part{};
    ElementIndex element = kNoElement;
};

/// Finds rows of a result by node and place.
class ResultRows {
public:
    ResultRows(const Result& result, std::size_t node_count)
        : result_(result), row_count_(result.row_count()) {
        assert(result.info.location != Location::Nodal || row_count_ == node_count);
        (void)node_count;
        const bool has_owners =
            result.info.location == Location::PartNodal || result.info.location == Location::ElementNodal;
        if (has_owners) row_count_ = std::min({row_count_, result.row_owner.size(), result.row_node.size()});
    }

    std::size_t find(NodeIndex node, ResultPlace place) const {
        switch (result_.info.location) {
        case Location::Nodal: return known(raw(node));
        case Location::Elemental: return place.element == kNoElement ? kNoRow : known(raw(place.element));
        case Location::PartNodal: {
            const auto [first, last] = rows_of(raw(place.part));
            const auto begin = result_.row_node.begin();
            const auto end = begin + static_cast<std::ptrdiff_t>(last);
            const auto found = std::lower_bound(begin + static_cast<std::ptrdiff_t>(first), end, node);
            return found == end || *found != node ? kNoRow : static_cast<std::size_t>(found - begin);
        }
        case Location::ElementNodal: {
            if (place.element == kNoElement) return kNoRow;
            const auto [first, last] = rows_of(raw(place.element));
            for (std::size_t row = first; row < last; ++row) {
                if (result_.row_node[row] == node) return row;
            }
            return kNoRow;
        }
        }
        return kNoRow;
    }

private:
    std::size_t known(std::size_t row) const { return row < row_count_ ? row : kNoRow; }

    std::pair<std::size_t, std::size_t> rows_of(std::uint32_t owner) const {
        const auto begin = result_.row_owner.begin();
        const auto range = std::equal_range(begin, begin + static_cast<std::ptrdiff_t>(row_count_), owner);
        return {
            static_cast<std::size_t>(range.first - begin), static_cast<std::size_t>(range.second - begin)};
    }

    const Result& result_;
    std::size_t row_count_;
};

/// Decision 16: a mid-side node of a corner-only result has the mean of its corners, made in double, rounded
/// once.
inline float middle_value(float a, float b) noexcept {
    return static_cast<float>((static_cast<double>(a) + static_cast<double>(b)) / 2);
}

}  // namespace feelem
