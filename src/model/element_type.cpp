// SPDX-License-Identifier: Apache-2.0
#include "feelem/element_type.hpp"

#include "model/element_table.hpp"

namespace feelem {

const ElementRow& element_row(ElementType type) noexcept {
    return element_table::kTable[static_cast<std::size_t>(type)];
}

std::span<const FacetRow> facets_of(ElementType type) noexcept {
    const ElementRow& r = element_row(type);
    return std::span(r.facets).first(r.facet_count);
}

std::span<const EdgeRow> edges_of(ElementType type) noexcept {
    const ElementRow& r = element_row(type);
    return std::span(r.edges).first(r.edge_count);
}

std::span<const std::uint8_t> facet_nodes(const FacetRow& facet) noexcept {
    return std::span(facet.nodes).first(element_row(facet.type).node_count);
}

std::span<const std::uint8_t> facet_corners(const FacetRow& facet) noexcept {
    return std::span(facet.nodes).first(element_row(facet.type).corner_count);
}

}  // namespace feelem
