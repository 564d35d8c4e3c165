// SPDX-License-Identifier: Apache-2.0
#include "read/side_markers.hpp"

#include <algorithm>
#include <limits>

namespace feelem {
namespace {

constexpr std::array<std::uint8_t, 4> kFirst{0, 1, 2, 3};

std::span<const std::uint8_t> own_corners(ElementType type) {
    return std::span(kFirst).first(std::min<std::size_t>(element_row(type).corner_count, 4));
}

}  // namespace

SideMarkers::Key SideMarkers::key_of(std::span<const NodeId> nodes, std::span<const std::uint8_t> corners) {
    Key key;
    key.fill(std::numeric_limits<std::int64_t>::max());
    for (std::size_t i = 0; i < corners.size(); ++i) key[i] = raw(nodes[corners[i]]);
    std::ranges::sort(key);
    return key;
}

std::size_t SideMarkers::Mix::operator()(const Key& key) const noexcept {
    std::uint64_t mixed = 0;
    for (const std::int64_t node : key) {
        mixed = (mixed ^ static_cast<std::uint64_t>(node)) * 0x9E3779B97F4A7C15U;
        mixed ^= mixed >> 32U;
    }
    return static_cast<std::size_t>(mixed);
}

void SideMarkers::add_candidate(ElementType type, std::span<const NodeId> nodes) {
    const ElementRow& row = element_row(type);
    if (row.dimension >= 3) return;
    has_dimension_[row.dimension] = true;
    marked_.try_emplace(key_of(nodes, own_corners(type)), false);
}

void SideMarkers::mark(const Key& key) {
    if (const auto found = marked_.find(key); found != marked_.end()) found->second = true;
}

void SideMarkers::add_owner(ElementType type, std::span<const NodeId> nodes) {
    const ElementRow& row = element_row(type);
    if (row.dimension == 3 && has_dimension_[2]) {
        for (const FacetRow& facet : facets_of(type)) mark(key_of(nodes, facet_corners(facet)));
    }
    if (row.dimension >= 2 && has_dimension_[1]) {
        for (const EdgeRow& edge : edges_of(type)) mark(key_of(nodes, std::array{edge.first, edge.second}));
    }
    if (row.dimension >= 1 && has_dimension_[0]) {
        for (std::uint8_t i = 0; i < row.corner_count; ++i) mark(key_of(nodes, std::array{i}));
    }
}

bool SideMarkers::is_side(ElementType type, std::span<const NodeId> nodes) const {
    if (marked_.empty() || element_row(type).dimension >= 3) return false;
    const auto found = marked_.find(key_of(nodes, own_corners(type)));
    return found != marked_.end() && found->second;
}

}  // namespace feelem
