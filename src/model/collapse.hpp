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

/// Four corners in one register, and a lane of ones for each that is another one too.
using FourCorners __attribute__((vector_size(16))) = std::uint32_t;
using FourRepeats __attribute__((vector_size(16))) = std::int32_t;

inline FourCorners four_corners(const NodeIndex* at) {
    FourCorners corners;
    std::memcpy(&corners, at, sizeof corners);
    return corners;
}

inline FourRepeats repeats_of_four(FourCorners a) {
    return (a == __builtin_shufflevector(a, a, 1, 2, 3, 0)) |
           (a == __builtin_shufflevector(a, a, 2, 3, 0, 1));
}

inline FourRepeats repeats_of_eight(FourCorners a, FourCorners b) {
    const FourRepeats across = (a == b) | (a == __builtin_shufflevector(b, b, 1, 2, 3, 0)) |
                               (a == __builtin_shufflevector(b, b, 2, 3, 0, 1)) |
                               (a == __builtin_shufflevector(b, b, 3, 0, 1, 2));
    return across | repeats_of_four(a) | repeats_of_four(b);
}

inline bool has_none(FourRepeats repeats) {
    return (repeats[0] | repeats[1] | repeats[2] | repeats[3]) == 0;
}

/// Whether no two corners are one.
inline bool all_differ(std::span<const NodeIndex> corners) {
    if (corners.size() == 8)
        return has_none(repeats_of_eight(four_corners(&corners[0]), four_corners(&corners[4])));
    if (corners.size() == 4) return has_none(repeats_of_four(four_corners(&corners[0])));
    unsigned equal = 0;  // Counted: a branch each would cost more.
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < corners.size(); ++j) equal += corners[i] == corners[j];
    }
    return equal == 0;
}

/// The same for the first `corners` of each row of `width` nodes.
bool all_differ_in_rows(std::span<const NodeIndex> rows, std::size_t width, std::size_t corners);

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
