// SPDX-License-Identifier: Apache-2.0
#include "skin/node_list_filter.hpp"

#include "model/node_lookup.hpp"

#include "feelem/skin.hpp"

#include <cassert>

namespace feelem {
namespace {

/// Facets of all solids; `skips` is asked with the element's node map.
template <class Skips>
ListedFacets list_facets(const Mesh& mesh, const std::vector<bool>* is_surface_node, Skips skips) {
    ListedFacets out;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
        const ElementBlock& block = mesh.blocks[b];
        const ElementRow& row = element_row(block.type);
        if (row.dimension != 3) continue;
        const auto facets = facets_of(block.type);
        for (std::size_t i = 0; i < block.ids.size(); ++i) {
            const auto nodes = std::span(block.nodes).subspan(i * row.node_count, row.node_count);
            const std::uint64_t map = is_surface_node ? node_map_bits(nodes, *is_surface_node) : 0;
            for (std::size_t f = 0; f < facets.size(); ++f) {
                ++out.in;
                if (outline_of(facets[f], nodes).count == 0) {
                    ++out.collapsed;
                } else if (skips(map, facets[f])) {
                    ++out.skipped;
                } else {
                    out.kept.push_back(
                        {static_cast<std::uint32_t>(i),
                         static_cast<std::uint8_t>(b),
                         static_cast<std::uint8_t>(f)}
                    );
                }
            }
        }
    }
    return out;
}

}  // namespace

std::uint64_t node_map_bits(std::span<const NodeIndex> nodes, const std::vector<bool>& is_surface_node) {
    assert(nodes.size() <= 64);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const bool inner = nodes[i] != kNoNode && !is_surface_node[raw(nodes[i])];
        if (inner) bits |= std::uint64_t{1} << i;
    }
    return bits;
}

ListedFacets facets_by_node_map(const Mesh& mesh, const std::vector<bool>& is_surface_node) {
    return list_facets(mesh, &is_surface_node, [](std::uint64_t map, const FacetRow& facet) {
        for (const std::uint8_t corner : facet_corners(facet)) {
            if ((map >> corner) & 1U) return true;
        }
        return false;
    });
}

ListedFacets every_facet(const Mesh& mesh) {
    return list_facets(mesh, nullptr, [](std::uint64_t, const FacetRow&) { return false; });
}

std::vector<bool> surface_node_flags(const Mesh& mesh, std::span<const NodeId> surface_nodes) {
    std::vector<bool> flags(mesh.node_count());
    const NodeLookup lookup(mesh.node_ids);
    for (const NodeId id : surface_nodes) {
        if (const NodeIndex node = lookup(id); node != kNoNode) flags[raw(node)] = true;
    }
    return flags;
}

}  // namespace feelem
