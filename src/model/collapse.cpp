// SPDX-License-Identifier: Apache-2.0
// Must: find the standard shape behind any pattern of repeated corners, not only the patterns Ansys writes.
// Assumes: corners are never kNoNode.
// Algorithm: collapse the facets of the table row; count what is left: 4 triangles = tet, 1 quad + 4
// triangles = pyramid, 2 triangles + 3 quads = wedge; number the corners from those facets; find mid-side
// nodes by edge. Data: a handful of facets on the stack.
#include "model/collapse.hpp"

#include <algorithm>
#include <vector>

namespace feelem {
namespace {

/// The mid-side node between two corners, from any edge of the original element that joins them.
NodeIndex middle_between(ElementType type, std::span<const NodeIndex> nodes, NodeIndex a, NodeIndex b) {
    for (const EdgeRow& edge : edges_of(type)) {
        if (edge.middle == kNoLocalNode) continue;
        const NodeIndex first = nodes[edge.first];
        const NodeIndex second = nodes[edge.second];
        const NodeIndex middle = nodes[edge.middle];
        const bool joins = (first == a && second == b) || (first == b && second == a);
        if (joins && middle != kNoNode && middle != a && middle != b) return middle;
    }
    return kNoNode;
}

/// Corner that follows `node` round the facet.
NodeIndex next_after(const FacetCorners& facet, NodeIndex node) {
    for (std::size_t i = 0; i < facet.count; ++i) {
        if (facet.nodes[i] == node) return facet.nodes[(i + 1) % facet.count];
    }
    return kNoNode;
}

bool contains(const FacetCorners& facet, NodeIndex node) {
    return std::ranges::find(
               facet.nodes.begin(), facet.nodes.begin() + static_cast<std::ptrdiff_t>(facet.count), node
           ) != facet.nodes.begin() + static_cast<std::ptrdiff_t>(facet.count);
}

struct Facets {
    std::vector<FacetCorners> tris;
    std::vector<FacetCorners> quads;
};

/// The corner on the other end of the edge that leaves triangle `base` at `node`.
NodeIndex opposite(const Facets& facets, const FacetCorners& base, NodeIndex node) {
    for (const FacetCorners& quad : facets.quads) {
        if (!contains(quad, node)) continue;
        const NodeIndex next = next_after(quad, node);
        if (!contains(base, next)) return next;
    }
    return kNoNode;
}

std::optional<CollapsedElement> corners_of_shape(const Facets& facets, std::size_t distinct) {
    CollapsedElement out;
    if (distinct == 4 && facets.tris.size() == 4 && facets.quads.empty()) {
        // Outward facet a b c seen from outside; corners 0 2 1 of a tet are such a facet.
        const FacetCorners& base = facets.tris[0];
        out.type = ElementType::Tet4;
        out.nodes = {base.nodes[0], base.nodes[2], base.nodes[1]};
        for (const FacetCorners& tri : facets.tris) {
            for (const NodeIndex node : std::span(tri.nodes).first(3)) {
                if (!contains(base, node)) out.nodes[3] = node;
            }
        }
        return out;
    }
    if (distinct == 5 && facets.tris.size() == 4 && facets.quads.size() == 1) {
        const FacetCorners& base = facets.quads[0];
        out.type = ElementType::Pyramid5;
        out.nodes = {base.nodes[0], base.nodes[3], base.nodes[2], base.nodes[1]};
        for (const NodeIndex node : std::span(facets.tris[0].nodes).first(3)) {
            if (!contains(base, node)) out.nodes[4] = node;
        }
        return out;
    }
    if (distinct == 6 && facets.tris.size() == 2 && facets.quads.size() == 3) {
        const FacetCorners& base = facets.tris[0];
        out.type = ElementType::Wedge6;
        out.nodes = {base.nodes[0], base.nodes[2], base.nodes[1]};
        for (std::size_t i = 0; i < 3; ++i) {
            out.nodes[3 + i] = opposite(facets, base, out.nodes[i]);
            if (out.nodes[3 + i] == kNoNode) return std::nullopt;
        }
        return out;
    }
    return std::nullopt;
}

ElementType quadratic_of(ElementType linear) {
    switch (linear) {
    case ElementType::Tet4: return ElementType::Tet10;
    case ElementType::Pyramid5: return ElementType::Pyramid13;
    case ElementType::Wedge6: return ElementType::Wedge15;
    case ElementType::Tri3: return ElementType::Tri6;
    default: return linear;
    }
}

std::optional<CollapsedElement> collapse_shell(ElementType type, std::span<const NodeIndex> nodes) {
    const FacetCorners corners = collapsed_corners(facets_of(type)[0], nodes);
    if (corners.count != 3 || element_row(type).corner_count != 4) return std::nullopt;
    CollapsedElement out;
    out.type = ElementType::Tri3;
    std::copy_n(corners.nodes.begin(), 3, out.nodes.begin());
    return out;
}

}  // namespace

FacetCorners collapsed_corners(const FacetRow& facet, std::span<const NodeIndex> element_nodes) {
    FacetCorners out;
    for (const std::uint8_t local : facet_corners(facet)) {
        const NodeIndex node = element_nodes[local];
        if (out.count == 0 || out.nodes[out.count - 1] != node) out.nodes[out.count++] = node;
    }
    if (out.count > 1 && out.nodes[0] == out.nodes[out.count - 1]) --out.count;
    return out;
}

bool all_differ_in_rows(std::span<const NodeIndex> rows, std::size_t width, std::size_t corners) {
    if (corners != 8 && corners != 4) {
        bool differ = true;
        for (std::size_t at = 0; at < rows.size(); at += width)
            differ &= all_differ(rows.subspan(at, corners));
        return differ;
    }
    FourRepeats repeats{};
    for (const NodeIndex *at = rows.data(), *const end = at + rows.size(); at != end; at += width) {
        repeats |= corners == 8 ? repeats_of_eight(four_corners(at), four_corners(at + 4))
                                : repeats_of_four(four_corners(at));
    }
    return has_none(repeats);
}

std::optional<CollapsedElement> collapse(ElementType type, std::span<const NodeIndex> nodes) {
    const ElementRow& row = element_row(type);
    if (row.dimension < 2 || all_differ(nodes.first(row.corner_count))) return std::nullopt;
    std::vector<NodeIndex> distinct(nodes.begin(), nodes.begin() + row.corner_count);
    std::ranges::sort(distinct);
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());

    std::optional<CollapsedElement> out;
    if (row.dimension == 2) {
        out = collapse_shell(type, nodes);
    } else {
        Facets facets;
        for (const FacetRow& facet : facets_of(type)) {
            const FacetCorners corners = collapsed_corners(facet, nodes);
            if (corners.count == 3) facets.tris.push_back(corners);
            if (corners.count == 4) facets.quads.push_back(corners);
        }
        out = corners_of_shape(facets, distinct.size());
    }
    if (!out || row.order == 1) return out;

    const ElementType linear = out->type;
    out->type = quadratic_of(linear);
    for (const EdgeRow& edge : edges_of(out->type)) {
        out->nodes[edge.middle] =
            middle_between(type, nodes, out->nodes[edge.first], out->nodes[edge.second]);
    }
    return out;
}

}  // namespace feelem
