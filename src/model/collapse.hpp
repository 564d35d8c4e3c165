// SPDX-License-Identifier: Apache-2.0
// Degenerate solids: a brick that repeats nodes is the wedge, pyramid or tetrahedron it looks like.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace feelem {

struct CollapsedElement {
    ElementType type = ElementType::Point1;
    std::array<NodeIndex, kMaxElementNodes> nodes{};
};

/// Whether no two corners are one.
inline bool all_differ(std::span<const NodeIndex> corners) {
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
