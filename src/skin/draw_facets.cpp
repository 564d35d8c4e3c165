// SPDX-License-Identifier: Apache-2.0
#include "skin/draw_facets.hpp"

#include "base/huge_pages.hpp"
#include "skin/drawn_report.hpp"
#include "skin/edge_table.hpp"
#include "skin/facet_grid.hpp"
#include "skin/pattern.hpp"
#include "skin/smooth_groups.hpp"

#include "feelem/error.hpp"

#include <array>
#include <utility>

namespace feelem {
namespace {

constexpr std::uint32_t kNoVertex = 0xFFFF'FFFF;

/// Appends vertices; a place in the surface's arrays for everything that happens in order of facets.
class Drawer {
public:
    Drawer(
        const Mesh& mesh, const FacetsToDraw& drawn, SmoothGroups&& groups, unsigned pieces, Surface& surface
    )
        : mesh_(mesh), drawn_(drawn), groups_(std::move(groups)), surface_(surface), is_fine_(pieces > 2) {
        reserve_big(vertex_of_group_, groups_.normals.size());
        vertex_of_group_.resize(groups_.normals.size(), kNoVertex);
        if (!is_fine_) return;
        triangle_grid_ = grid_of(3, pieces);
        quad_grid_ = grid_of(4, pieces);
        first_between_.resize(drawn.facets.size());
    }

    void draw(std::uint32_t facet) {
        const Outline& outline = drawn_.facets[facet];
        const FacetPlaces at = places_of(outline, mesh_.coordinates);
        std::array<std::uint32_t, kFacetPoints> vertices{};
        if (surface_.domain == Domain::ElementNode) forget_other_elements(facet);
        for (std::size_t k = 0; k < outline.count; ++k)
            vertices[k] = shared_vertex(facet, k, outline.corners[k], at[k]);
        if (outline.has_middles()) draw_middles(facet, at, vertices);
        if (outline.count == 4) draw_centre(facet, at, vertices);
        if (is_fine_ && outline.has_middles()) {
            draw_finely(facet, at, vertices);
            return;
        }
        const auto pattern = pattern_of(outline);
        std::array<std::array<VertexIndex, 3>, 8> triangles;
        for (std::size_t i = 0; i < pattern.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) triangles[i][k] = VertexIndex{vertices[pattern[i][k]]};
        }
        const auto count = static_cast<std::ptrdiff_t>(pattern.size());
        surface_.triangles.insert(surface_.triangles.end(), triangles.begin(), triangles.begin() + count);
        surface_.triangle_element.insert(
            surface_.triangle_element.end(), pattern.size(), drawn_.elements[facet]
        );
    }

    /// Segments of a side, through its middle node if it has one.
    void draw_side(std::uint32_t side) {
        const Outline& outline = drawn_.facets[side / 4];
        const std::size_t i = side % 4;
        const auto vertex = [&](std::size_t point) { return VertexIndex{drawn_point(side / 4, point)}; };
        if (outline.middles[i] == kNoNode) {
            surface_.edges.push_back({vertex(i), vertex(outline.after(i))});
            return;
        }
        if (is_fine_) {
            draw_curved_side(side);
            return;
        }
        surface_.edges.push_back({vertex(i), vertex(kFirstMiddle + i)});
        surface_.edges.push_back({vertex(kFirstMiddle + i), vertex(outline.after(i))});
    }

private:
    /// With a vertex for each (element, node), groups are shared only among the facets of one element.
    void forget_other_elements(std::uint32_t facet) {
        if (facet == 0 || drawn_.elements[facet] == drawn_.elements[facet - 1]) return;
        for (const std::uint32_t group : groups_of_element_) vertex_of_group_[group] = kNoVertex;
        groups_of_element_.clear();
    }

    std::uint32_t drawn_point(std::uint32_t facet, std::size_t point) const {
        return groups_.of_point[std::size_t{facet} * groups_.stride + point];
    }

    std::uint32_t add_vertex(
        const Point3& at, const std::array<float, 3>& normal, NodeIndex node, ElementIndex element
    ) {
        if (surface_.positions.size() >= kNoVertex)
            throw Error(Code::TooLarge, "", "more than 4 294 967 294 vertices");
        surface_.positions.push_back(at);
        surface_.normals.push_back(normal);
        surface_.vertex_node.push_back(node);
        if (surface_.domain == Domain::ElementNode) surface_.vertex_element.push_back(element);
        return static_cast<std::uint32_t>(surface_.positions.size() - 1);
    }

    std::uint32_t shared_vertex(std::uint32_t facet, std::size_t point, NodeIndex node, const Point3& at) {
        std::uint32_t& group_or_vertex = groups_.of_point[std::size_t{facet} * groups_.stride + point];
        const std::uint32_t group = group_or_vertex;
        std::uint32_t& vertex = vertex_of_group_[group];
        if (vertex == kNoVertex) {
            vertex = add_vertex(at, groups_.normals[group], node, drawn_.elements[facet]);
            if (surface_.domain == Domain::ElementNode) groups_of_element_.push_back(group);
        }
        group_or_vertex = vertex;
        return vertex;
    }

    void draw_middles(
        std::uint32_t facet, const FacetPlaces& at, std::array<std::uint32_t, kFacetPoints>& vertices
    ) {
        const Outline& outline = drawn_.facets[facet];
        for (std::size_t i = 0; i < outline.count; ++i) {
            const std::size_t point = kFirstMiddle + i;
            const std::size_t before = surface_.positions.size();
            vertices[point] = shared_vertex(facet, point, outline.middles[i], at[point]);
            const bool is_new = surface_.positions.size() > before;
            if (is_new && outline.middles[i] == kNoNode)
                add_blend(vertices[point], blend_of_middle(outline, i), vertices);
        }
    }

    void draw_centre(
        std::uint32_t facet, const FacetPlaces& at, std::array<std::uint32_t, kFacetPoints>& vertices
    ) {
        const Outline& outline = drawn_.facets[facet];
        Point3 normal{};
        for (const FacetTriangle& t : pattern_of(outline)) {
            const Point3 area = area_vector(at[t[0]], at[t[1]], at[t[2]]);
            for (std::size_t axis = 0; axis < 3; ++axis) normal[axis] += area[axis];
        }
        vertices[kCentre] = add_vertex(at[kCentre], unit(normal), outline.centre, drawn_.elements[facet]);
        if (outline.centre == kNoNode) add_blend(vertices[kCentre], blend_of_centre(outline), vertices);
    }

    const FacetGrid& grid(const Outline& outline) const {
        return outline.count == 3 ? triangle_grid_ : quad_grid_;
    }

    void add_triangle(std::uint32_t facet, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        surface_.triangles.push_back({VertexIndex{a}, VertexIndex{b}, VertexIndex{c}});
        surface_.triangle_element.push_back(drawn_.elements[facet]);
    }

    /// Vertices between the facet's points, in the order of its grid, then the triangles of the grid.
    void draw_finely(
        std::uint32_t facet, const FacetPlaces& at, const std::array<std::uint32_t, kFacetPoints>& vertices
    ) {
        const Outline& outline = drawn_.facets[facet];
        first_between_[facet] = static_cast<std::uint32_t>(surface_.positions.size());
        std::vector<std::uint32_t>& vertex_at = scratch_;
        vertex_at.clear();
        for (const FacetGrid::Point& point : grid(outline).points) {
            if (point.point != FacetGrid::kNoPoint) {
                vertex_at.push_back(vertices[point.point]);
                continue;
            }
            const WeightedPoints blend = shape_weights(outline, point.u, point.v);
            Point3 place{};
            Point3 normal{};
            for (std::size_t i = 0; i < blend.count; ++i) {
                const auto& there = surface_.normals[vertices[blend.points[i]]];
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    place[axis] += blend.weights[i] * at[blend.points[i]][axis];
                    normal[axis] += blend.weights[i] * static_cast<double>(there[axis]);
                }
            }
            vertex_at.push_back(add_vertex(place, unit(normal), kNoNode, drawn_.elements[facet]));
            add_blend(vertex_at.back(), blend, vertices);
        }
        for (const auto& [a, b, c] : grid(outline).triangles)
            add_triangle(facet, vertex_at[a], vertex_at[b], vertex_at[c]);
    }

    void draw_curved_side(std::uint32_t side) {
        const std::uint32_t facet = side / 4;
        const FacetGrid& points = grid(drawn_.facets[facet]);
        const auto vertex = [&](std::uint32_t i) {
            const std::uint8_t point = points.points[i].point;
            if (point != FacetGrid::kNoPoint) return VertexIndex{drawn_point(facet, point)};
            return VertexIndex{first_between_[facet] + points.rank[i]};
        };
        const std::vector<std::uint32_t>& along = points.sides[side % 4];
        for (std::size_t k = 1; k < along.size(); ++k)
            surface_.edges.push_back({vertex(along[k - 1]), vertex(along[k])});
    }

    void add_blend(
        std::uint32_t vertex,
        const WeightedPoints& blend,
        const std::array<std::uint32_t, kFacetPoints>& vertices
    ) {
        surface_.blends.push_back(
            {VertexIndex{vertex},
             static_cast<std::uint32_t>(surface_.blend_sources.size()),
             static_cast<std::uint32_t>(blend.count)}
        );
        std::array<VertexIndex, kFacetPoints> sources{};
        for (std::size_t i = 0; i < blend.count; ++i) sources[i] = VertexIndex{vertices[blend.points[i]]};
        const auto count = static_cast<std::ptrdiff_t>(blend.count);
        surface_.blend_sources.insert(surface_.blend_sources.end(), sources.begin(), sources.begin() + count);
        surface_.blend_weights.insert(
            surface_.blend_weights.end(), blend.weights.begin(), blend.weights.begin() + count
        );
    }

    const Mesh& mesh_;
    const FacetsToDraw& drawn_;
    SmoothGroups groups_;  ///< Of drawn points, the vertex takes the group's place.
    Surface& surface_;
    bool is_fine_;
    std::vector<std::uint32_t> vertex_of_group_;
    std::vector<std::uint32_t> groups_of_element_;  ///< Domain::ElementNode: that have a vertex now.
    FacetGrid triangle_grid_, quad_grid_;
    std::vector<std::uint32_t> first_between_;  ///< Per facet: its first vertex between points.
    std::vector<std::uint32_t> scratch_;
};

/// Per side: whether it draws its edge, which is so for the first one in each piece.
std::vector<bool> drawing_sides(const FacetsToDraw& drawn, const EdgeTable& edges) {
    std::vector<std::uint32_t> piece_of(drawn.facets.size());
    for (std::uint32_t piece = 0; piece < drawn.pieces.size(); ++piece) {
        for (std::uint32_t f = drawn.piece_first[piece]; f < drawn.piece_first[piece + 1]; ++f)
            piece_of[f] = piece;
    }
    std::vector<bool> draws(edges.next.size());
    for (const std::uint32_t first : edges.first) {
        draws[first] = true;
        for (std::uint32_t side = first; edges.next[side] != kNoSide; side = edges.next[side]) {
            const std::uint32_t next = edges.next[side];
            if (piece_of[facet_of_side(next)] != piece_of[facet_of_side(side)]) draws[next] = true;
        }
    }
    return draws;
}

/// As much as is known before drawing: growing would hold the arrays twice.
void reserve(
    const FacetsToDraw& drawn, const SmoothGroups& groups, std::size_t edge_count, Surface& surface
) {
    std::size_t quads = 0, triangles = 0;
    for (const Outline& facet : drawn.facets) {
        quads += facet.count == 4 ? 1U : 0U;
        triangles += pattern_of(facet).size();
    }
    const std::size_t vertices = groups.normals.size() + quads;
    reserve_big(surface.positions, vertices);
    reserve_big(surface.normals, vertices);
    reserve_big(surface.vertex_node, vertices);
    if (surface.domain == Domain::ElementNode) reserve_big(surface.vertex_element, vertices);
    reserve_big(surface.triangles, triangles);
    reserve_big(surface.triangle_element, triangles);
    reserve_big(surface.edges, edge_count);
    reserve_big(surface.blends, quads);
    reserve_big(surface.blend_sources, quads * 4);
    reserve_big(surface.blend_weights, quads * 4);
}

}  // namespace

void draw_facets(const Mesh& mesh, const FacetsToDraw& drawn, const DrawOptions& options, Surface& surface) {
    if (drawn.facets.size() >= kNoVertex / 8) throw Error(Code::TooLarge, "", "more than 536 870 911 facets");
    SmoothGroups groups;
    std::vector<bool> draws;
    std::size_t edge_count = 0;
    {
        // The table goes before the surface needs its room.
        const EdgeTable edges = find_edges(drawn.facets);
        groups = find_smooth_groups(
            drawn.facets, drawn.piece_first, edges, mesh.coordinates, options.crease_angle
        );
        draws = drawing_sides(drawn, edges);
        edge_count = edges.first.size();
        report_facets(mesh, drawn, edges, surface.report);
    }
    reserve(drawn, groups, edge_count, surface);
    Drawer drawer(mesh, drawn, std::move(groups), options.pieces, surface);
    const auto size = [](const auto& values) { return static_cast<std::uint32_t>(values.size()); };
    for (std::size_t piece = 0; piece < drawn.pieces.size(); ++piece) {
        SurfacePart part;
        part.part = drawn.pieces[piece].part;
        part.kind = drawn.pieces[piece].kind;
        part.first_vertex = size(surface.positions);
        part.first_triangle = size(surface.triangles);
        part.first_edge = size(surface.edges);
        const std::uint32_t first = drawn.piece_first[piece];
        const std::uint32_t last = drawn.piece_first[piece + 1];
        for (std::uint32_t f = first; f < last; ++f) {
            fetch_places(drawn.facets, f, mesh.coordinates);
            drawer.draw(f);
        }
        for (std::uint32_t side = first * 4; side < last * 4; ++side) {
            if (draws[side]) drawer.draw_side(side);
        }
        part.vertex_count = size(surface.positions) - part.first_vertex;
        part.triangle_count = size(surface.triangles) - part.first_triangle;
        part.edge_count = size(surface.edges) - part.first_edge;
        surface.parts.push_back(part);
    }
    report_triangles(surface);
}

}  // namespace feelem
