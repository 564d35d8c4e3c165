// SPDX-License-Identifier: Apache-2.0
// Triangles, lines and points that only name the sides, edges and corners of other elements: meshers write
// them for boundary conditions. They are no shells and beams, and would cover the skin a second time.
#pragma once

#include "feelem/element_type.hpp"
#include "feelem/ids.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>

namespace feelem {

/// First all candidates, then all elements as owners, then the question. Nodes are in Feelem's order; corners
/// decide.
class SideMarkers {
public:
    /// Solids are no candidates and cost nothing.
    void add_candidate(ElementType type, std::span<const NodeId> nodes);
    void add_owner(ElementType type, std::span<const NodeId> nodes);
    bool empty() const noexcept { return marked_.empty(); }
    /// Whether an element is a facet, an edge or a corner of one of higher dimension.
    bool is_side(ElementType type, std::span<const NodeId> nodes) const;

private:
    using Key = std::array<std::int64_t, 4>;
    static Key key_of(std::span<const NodeId> nodes, std::span<const std::uint8_t> corners);
    void mark(const Key& key);

    struct Mix {
        std::size_t operator()(const Key& key) const noexcept;
    };
    std::unordered_map<Key, bool, Mix> marked_;
    std::array<bool, 3> has_dimension_{};
};

}  // namespace feelem
