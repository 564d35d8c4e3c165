// SPDX-License-Identifier: Apache-2.0
// The stage: which facets are kept, and what they look like.
#include "feelem/skin.hpp"

#include "base/huge_pages.hpp"
#include "skin/draw_facets.hpp"
#include "skin/element_checks.hpp"
#include "skin/facet_cancellation.hpp"
#include "skin/glyphs.hpp"
#include "skin/node_list_filter.hpp"
#include "skin/outline.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace feelem {
namespace {

constexpr unsigned kMostSubdivisions = 6;

struct SolidFacets {
    std::vector<FacetRef> kept;
    std::vector<bool> set_aside;
    bool check_all_for_inversion = false;
};

bool has_solids(const Mesh& mesh) {
    return std::ranges::any_of(mesh.blocks, [](const ElementBlock& block) {
        return element_row(block.type).dimension == 3 && !block.ids.empty();
    });
}

SolidFacets exact_solid_facets(const Mesh& mesh, SkinReport& report) {
    SolidFacets solids;
    OuterFacets found = find_outer_facets(mesh, solids.set_aside);
    // Solids without any skin: each was listed twice, once in mirrored order.
    const bool vanished = found.outer.empty() && found.collapsed < found.in;
    if (found.duplicates || vanished) {
        solids.set_aside = find_duplicate_solids(mesh);
        report.duplicate_elements = static_cast<std::uint64_t>(std::ranges::count(solids.set_aside, true));
        found = find_outer_facets(mesh, solids.set_aside);
    }
    report.solid_facets_in = found.in;
    report.facets_inner = found.inner;
    report.facets_many_owners = found.many_owners;
    report.facets_collapsed = found.collapsed;
    report.facets_of_duplicates = found.of_set_aside;
    report.unmatched_facets = found.unmatched;
    solids.kept = std::move(found.outer);
    solids.check_all_for_inversion = found.same_winding;
    return solids;
}

SolidFacets listed_solid_facets(const Mesh& mesh, const SkinOptions& options, SkinReport& report) {
    ListedFacets listed = options.method == SkinMethod::All
                              ? every_facet(mesh)
                              : facets_by_node_map(mesh, surface_node_flags(mesh, options.surface_nodes));
    report.solid_facets_in = listed.in;
    report.facets_inner = listed.skipped;
    report.facets_collapsed = listed.collapsed;
    SolidFacets solids;
    solids.kept = std::move(listed.kept);
    return solids;
}

SolidFacets solid_facets(const Mesh& mesh, const SkinOptions& options, SkinReport& report) {
    SolidFacets solids = options.method == SkinMethod::Exact ? exact_solid_facets(mesh, report)
                                                             : listed_solid_facets(mesh, options, report);
    const bool any_flipped = flip_facets_of_inverted_solids(mesh, solids.kept);
    if (any_flipped || solids.check_all_for_inversion)
        report.inverted_elements = count_inverted_solids(mesh, solids.set_aside);
    return solids;
}

std::vector<FacetRef> shell_facets(const Mesh& mesh) {
    std::vector<FacetRef> out;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
        if (element_row(mesh.blocks[b].type).dimension != 2) continue;
        for (std::size_t i = 0; i < mesh.blocks[b].ids.size(); ++i)
            out.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(b)});
    }
    return out;
}

/// The outline as it is drawn; no corners when a corner's place is not known.
Outline drawable(const Mesh& mesh, FacetRef ref, unsigned subdivide) {
    Outline outline = outline_of(mesh, ref);
    for (std::size_t i = 0; i < outline.count; ++i) {
        if (!has_place(mesh, outline.corners[i])) return {};
        NodeIndex& middle = outline.middles[i];
        if (middle != kNoNode && (subdivide == 0 || !has_place(mesh, middle))) middle = kNoNode;
    }
    NodeIndex& centre = outline.centre;
    if (centre != kNoNode && (subdivide == 0 || !has_place(mesh, centre))) centre = kNoNode;
    return outline;
}

/// Facets sorted by (part, kind), in their order within each.
FacetsToDraw in_pieces(
    const Mesh& mesh,
    const std::vector<FacetRef>& solids,
    const std::vector<FacetRef>& shells,
    unsigned subdivide,
    Diagnostics& diagnostics
) {
    std::vector<std::uint32_t> block_first;
    std::uint32_t first_element = 0;
    for (const ElementBlock& block : mesh.blocks) {
        block_first.push_back(first_element);
        first_element += static_cast<std::uint32_t>(block.ids.size());
    }
    const auto piece_of = [&](FacetRef ref) {
        const bool is_shell = element_row(mesh.blocks[ref.block].type).dimension == 2;
        return std::size_t{raw(mesh.blocks[ref.block].parts[ref.position])} * 2 + (is_shell ? 1 : 0);
    };
    std::vector<std::uint32_t> counts(mesh.parts.size() * 2 + 1);
    const auto for_each = [&](auto visit) {
        for (const FacetRef ref : solids) visit(ref);
        for (const FacetRef ref : shells) visit(ref);
    };
    for_each([&](FacetRef ref) { ++counts[piece_of(ref) + 1]; });
    for (std::size_t i = 1; i < counts.size(); ++i) counts[i] += counts[i - 1];
    auto sorted = big_zeros<FacetRef>(solids.size() + shells.size());
    std::vector<std::uint32_t> next(counts.begin(), counts.end() - 1);
    for_each([&](FacetRef ref) { sorted[next[piece_of(ref)]++] = ref; });

    FacetsToDraw drawn;
    reserve_big(drawn.facets, sorted.size());
    reserve_big(drawn.elements, sorted.size());
    std::uint64_t without_place = 0;
    for (std::size_t piece = 0; piece + 1 < counts.size(); ++piece) {
        const auto first = static_cast<std::uint32_t>(drawn.facets.size());
        for (std::uint32_t i = counts[piece]; i < counts[piece + 1]; ++i) {
            fetch_elements(mesh, sorted, i);
            const Outline outline = drawable(mesh, sorted[i], subdivide);
            if (outline.count == 0) {
                if (outline_of(mesh, sorted[i]).count > 0) ++without_place;
                continue;
            }
            drawn.facets.push_back(outline);
            drawn.elements.push_back(ElementIndex{block_first[sorted[i].block] + sorted[i].position});
        }
        if (drawn.facets.size() == first) continue;
        drawn.pieces.push_back(
            {PartIndex{static_cast<std::uint32_t>(piece / 2)},
             piece % 2 == 1 ? PartKind::Shell : PartKind::Solid}
        );
        drawn.piece_first.push_back(first);
    }
    drawn.piece_first.push_back(static_cast<std::uint32_t>(drawn.facets.size()));
    if (without_place > 0) {
        diagnostics.add(
            Code::UnknownNode,
            std::string(),
            "facets have a corner without coordinates and are not drawn",
            without_place
        );
    }
    return drawn;
}

void count_kinds(const FacetsToDraw& drawn, SkinReport& report) {
    for (std::size_t piece = 0; piece < drawn.pieces.size(); ++piece) {
        const bool is_shell = drawn.pieces[piece].kind == PartKind::Shell;
        for (std::uint32_t f = drawn.piece_first[piece]; f < drawn.piece_first[piece + 1]; ++f) {
            const bool is_quad = drawn.facets[f].count == 4;
            ++(is_shell ? (is_quad ? report.shell_quad : report.shell_tri)
                        : (is_quad ? report.solid_quad_kept : report.solid_tri_kept));
        }
    }
}

void tell(const SkinReport& report, Diagnostics& diagnostics) {
    const auto add = [&](Code code, std::uint64_t count, const char* text) {
        if (count > 0) diagnostics.add(code, std::string(), text, count);
    };
    add(Code::DuplicateElement,
        report.duplicate_elements,
        "solids have the same corner nodes as an earlier one and are set aside");
    add(Code::InvertedElement,
        report.inverted_elements,
        "solids have negative volume; their outer facets were turned round");
    add(Code::FacetWithManyOwners,
        report.facets_many_owners,
        "facets have three or more owners and are taken as inner (counted once for each owner)");
    add(Code::UnmatchedFacets,
        report.unmatched_facets,
        "facets lie on each other but do not match (other mid-side nodes, or a quad on two triangles): both "
        "sides are kept");
}

std::string why_nothing_is_drawn(const Mesh& mesh) {
    const bool has_places =
        std::ranges::any_of(mesh.coordinates, [](const Point3& place) { return !std::isnan(place[0]); });
    if (mesh.element_count() > 0 && !has_places)
        return "the inputs list elements, but not where their nodes are. Add the file of the same model that "
               "lists its nodes (Ansys: NLIST,ALL,,,COORD).";
    if (mesh.element_count() > 0) return "no element has a surface that could be drawn";
    return "the inputs list no elements: values alone cannot be drawn. Add the files of the same model that "
           "list "
           "its elements and nodes (Ansys: ELIST and NLIST,ALL,,,COORD).";
}

}  // namespace

Surface make_skin(const Mesh& mesh, const SkinOptions& options, Diagnostics& diagnostics) {
    if (options.subdivide > kMostSubdivisions) {
        throw Error(
            Code::BadOption,
            "",
            "an edge cannot be subdivided more than 6 times: into 64 pieces, 8192 triangles a facet"
        );
    }
    Surface surface;
    surface.domain = options.domain;
    SkinReport& report = surface.report;
    report.has_solids = has_solids(mesh);
    const FacetsToDraw drawn = [&] {
        const SolidFacets solids = solid_facets(mesh, options, report);
        report.solid_facets_kept = solids.kept.size();
        return in_pieces(mesh, solids.kept, shell_facets(mesh), options.subdivide, diagnostics);
    }();
    count_kinds(drawn, report);
    tell(report, diagnostics);
    draw_facets(mesh, drawn, {options.crease_angle, 1U << std::max(options.subdivide, 1U)}, surface);
    add_glyphs(mesh, surface, diagnostics);
    if (surface.triangles.empty()) throw Error(Code::NoElements, "", why_nothing_is_drawn(mesh));
    return surface;
}

}  // namespace feelem
