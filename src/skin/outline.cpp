// SPDX-License-Identifier: Apache-2.0
#include "skin/outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace feelem {
namespace {

void turn_round(Outline& outline) noexcept {
    // Corners 0 1 2 3 with sides 01 12 23 30 become 0 3 2 1 with sides 03 32 21 10.
    const auto last = outline.corners.begin() + outline.count;
    std::reverse(outline.corners.begin() + 1, last);
    std::reverse(outline.middles.begin(), outline.middles.begin() + outline.count);
}

NodeIndex middle_between(const Outline& outline, NodeIndex a, NodeIndex b) noexcept {
    for (std::size_t i = 0; i < outline.count; ++i) {
        const NodeIndex from = outline.corners[i];
        const NodeIndex to = outline.corners[outline.after(i)];
        if ((from == a && to == b) || (from == b && to == a)) return outline.middles[i];
    }
    return kNoNode;
}

}  // namespace

Outline outline_of(const FacetRow& row, std::span<const NodeIndex> element_nodes) noexcept {
    const bool is_triangle = row.type == ElementType::Tri3 || row.type == ElementType::Tri6;
    const bool is_quadratic = row.type != ElementType::Tri3 && row.type != ElementType::Quad4;
    const std::size_t corners = is_triangle ? 3 : 4;
    Outline out;
    for (std::size_t i = 0; i < corners; ++i) {
        const NodeIndex here = element_nodes[row.nodes[i]];
        const NodeIndex next = element_nodes[row.nodes[i + 1 == corners ? 0 : i + 1]];
        // Of corners that repeat in sequence the last stays: the side after it is the one that has a length.
        if (here == next) continue;
        out.corners[out.count] = here;
        if (is_quadratic) {
            const NodeIndex middle = element_nodes[row.nodes[corners + i]];
            if (middle != here && middle != next) out.middles[out.count] = middle;
        }
        ++out.count;
    }
    const bool folded =
        out.count == 4 && (out.corners[0] == out.corners[2] || out.corners[1] == out.corners[3]);
    if (out.count < 3 || folded) return {};
    if (row.type == ElementType::Quad9 && out.count == 4) out.centre = element_nodes[row.nodes[8]];
    return out;
}

std::span<const NodeIndex> element_nodes(const Mesh& mesh, FacetRef ref) noexcept {
    const ElementBlock& block = mesh.blocks[ref.block];
    const std::size_t count = element_row(block.type).node_count;
    return std::span(block.nodes).subspan(ref.position * count, count);
}

Outline outline_of(const Mesh& mesh, FacetRef ref) noexcept {
    Outline out = outline_of(facets_of(mesh.blocks[ref.block].type)[ref.facet], element_nodes(mesh, ref));
    if (ref.flipped && out.count > 0) turn_round(out);
    return out;
}

void fetch_elements(const Mesh& mesh, std::span<const FacetRef> facets, std::size_t i) noexcept {
    constexpr std::size_t kAhead = 16;
    if (i + kAhead >= facets.size()) return;
    const FacetRef later = facets[i + kAhead], sooner = facets[i + kAhead / 2];
    const auto nodes = element_nodes(mesh, later);
    __builtin_prefetch(nodes.data());
    __builtin_prefetch(nodes.data() + nodes.size() - 1);
    const std::size_t corners = element_row(mesh.blocks[sooner.block].type).corner_count;
    for (const NodeIndex corner : element_nodes(mesh, sooner).first(corners))
        __builtin_prefetch(&mesh.coordinates[raw(corner)]);
}

bool has_place(const Mesh& mesh, NodeIndex node) noexcept {
    return std::ranges::all_of(mesh.coordinates[raw(node)], [](double v) { return std::isfinite(v); });
}

bool same_middles(const Outline& a, const Outline& b) noexcept {
    for (std::size_t i = 0; i < a.count; ++i) {
        if (middle_between(b, a.corners[i], a.corners[a.after(i)]) != a.middles[i]) return false;
    }
    return true;
}

}  // namespace feelem
