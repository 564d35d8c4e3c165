// SPDX-License-Identifier: Apache-2.0
#include "skin/drawn_report.hpp"

#include "base/huge_pages.hpp"
#include "skin/pattern.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace feelem {
namespace {

bool is_closed(const FacetsToDraw& drawn, const EdgeTable& edges) {
    std::vector<bool> is_solid(drawn.facets.size());
    bool any_solid = false;
    for (std::size_t piece = 0; piece < drawn.pieces.size(); ++piece) {
        for (std::uint32_t f = drawn.piece_first[piece]; f < drawn.piece_first[piece + 1]; ++f)
            is_solid[f] = drawn.pieces[piece].kind == PartKind::Solid;
        any_solid = any_solid || drawn.pieces[piece].kind == PartKind::Solid;
    }
    for (const std::uint32_t first : edges.first) {
        std::int64_t balance = 0;
        for (std::uint32_t side = first; side != kNoSide; side = edges.next[side]) {
            if (is_solid[facet_of_side(side)]) balance += runs_up(drawn.facets, side) ? 1 : -1;
        }
        if (balance != 0) return false;
    }
    return any_solid;
}

/// Distinct (part, node) on the facets; pieces of one part follow each other.
std::uint64_t count_part_nodes(const Mesh& mesh, const FacetsToDraw& drawn) {
    ZeroedArray<std::uint8_t> seen(mesh.node_count());
    std::uint64_t count = 0;
    const auto for_each_node = [&](std::size_t piece, auto visit) {
        for (std::uint32_t f = drawn.piece_first[piece]; f < drawn.piece_first[piece + 1]; ++f) {
            const Outline& facet = drawn.facets[f];
            for (std::size_t i = 0; i < facet.count; ++i) visit(facet.corners[i]);
            if (facet.has_middles()) {
                for (std::size_t i = 0; i < facet.count; ++i) {
                    if (facet.middles[i] != kNoNode) visit(facet.middles[i]);
                }
            }
            if (facet.centre != kNoNode) visit(facet.centre);
        }
    };
    std::size_t first_of_part = 0;
    for (std::size_t piece = 0; piece < drawn.pieces.size(); ++piece) {
        for_each_node(piece, [&](NodeIndex node) {
            count += 1U - seen[raw(node)];
            seen[raw(node)] = 1;
        });
        const bool another_part_follows =
            piece + 1 < drawn.pieces.size() && drawn.pieces[piece + 1].part != drawn.pieces[piece].part;
        if (!another_part_follows) continue;
        for (; first_of_part <= piece; ++first_of_part) {
            for_each_node(first_of_part, [&](NodeIndex node) { seen[raw(node)] = 0; });
        }
    }
    return count;
}

}  // namespace

void report_triangles(Surface& surface) {
    SkinReport& report = surface.report;
    if (surface.positions.empty()) return;
    // Volumes are taken from a vertex, not from the model's origin, which may be far away.
    const Point3 origin = surface.positions.front();
    for (const SurfacePart& part : surface.parts) {
        for (std::uint32_t i = part.first_triangle; i < part.first_triangle + part.triangle_count; ++i) {
            const auto& t = surface.triangles[i];
            const Point3 a = minus(surface.positions[raw(t[0])], origin);
            const Point3 b = minus(surface.positions[raw(t[1])], origin);
            const Point3 c = minus(surface.positions[raw(t[2])], origin);
            const Point3 area = area_vector(a, b, c);
            report.area += std::sqrt(dot(area, area)) / 2;
            if (part.kind == PartKind::Solid) report.volume += dot(a, cross(b, c)) / 6;
        }
    }
    report.triangles = surface.triangles.size();
}

void report_facets(const Mesh& mesh, const FacetsToDraw& drawn, const EdgeTable& edges, SkinReport& report) {
    report.vertices = count_part_nodes(mesh, drawn);
    report.closed = is_closed(drawn, edges);
}

}  // namespace feelem
