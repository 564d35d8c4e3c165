// SPDX-License-Identifier: Apache-2.0
// Degenerate solids: a brick that repeats nodes is the wedge, pyramid or tetrahedron it looks like.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

namespace feelem {

struct CollapsedElement {
    ElementType type = ElementType::Point1;
    std::array<NodeIndex, kMaxElementNodes> nodes{};
};

/// Whether no two of eight are one, four at a time: nearly all elements are asked this.
inline bool eight_differ(const NodeIndex* corners) {
    using Four [[gnu::vector_size(16)]] = std::uint32_t;
    Four low, high;
    std::memcpy(&low, corners, sizeof low);
    std::memcpy(&high, corners + 4, sizeof high);
    const auto turned = [](Four of) { return __builtin_shufflevector(of, of, 1, 2, 3, 0); };
    const Four low_1 = turned(low), high_1 = turned(high), high_2 = turned(high_1);
    auto equal = (low == low_1) | (low == turned(low_1)) | (high == high_1) | (high == high_2);
    equal |= (low == high) | (low == high_1) | (low == high_2) | (low == turned(high_2));
    std::array<std::uint64_t, 2> any{};
    std::memcpy(any.data(), &equal, sizeof equal);
    return (any[0] | any[1]) == 0;
}

/// Whether no two corners are one.
inline bool all_differ(std::span<const NodeIndex> corners) {
    if (corners.size() == 8) return eight_differ(corners.data());
    unsigned equal = 0;  // Counted: a branch each would cost more.
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < corners.size(); ++j) equal += corners[i] == corners[j];
    }
    return equal == 0;
}

/// The simpler standard element behind a row with repeated corners, or nothing when it has no repeats or is
/// no standard shape (then it stays as it is, and its facets are collapsed one by one in the skin). Mid-side
/// nodes of collapsed edges repeat a corner and are dropped; quadratic wedges become wedge15.
std::optional<CollapsedElement> collapse(ElementType type, std::span<const NodeIndex> nodes);

/// The corners of a facet without those that repeat in sequence; at most four.
struct FacetCorners {
    std::array<NodeIndex, 4> nodes{};
    std::size_t count = 0;
};
FacetCorners collapsed_corners(const FacetRow& facet, std::span<const NodeIndex> element_nodes);

}  // namespace feelem
