// SPDX-License-Identifier: Apache-2.0
#include "skin/glyphs.hpp"

#include "skin/pattern.hpp"
#include "skin/smooth_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace feelem {
namespace {

constexpr std::size_t kSides = 6;
constexpr double kTubeRadius = 0.004;  ///< Of the model's largest side.
constexpr double kPointRadius = 0.008;

struct Bare {
    PartIndex part{};
    ElementIndex element{};
    std::vector<NodeIndex> nodes;  ///< In order along the beam: ends and what lies between.
};

/// Elements of one dimension, ordered by part, those without coordinates left out.
std::vector<Bare> bare_elements(const Mesh& mesh, std::uint8_t dimension) {
    std::vector<Bare> out;
    std::uint32_t first = 0;
    for (const ElementBlock& block : mesh.blocks) {
        const ElementRow& row = element_row(block.type);
        for (std::size_t i = 0; row.dimension == dimension && i < block.ids.size(); ++i) {
            const auto nodes = std::span(block.nodes).subspan(i * row.node_count, row.node_count);
            if (!std::ranges::all_of(nodes.first(row.corner_count), [&](NodeIndex n) {
                    return has_place(mesh, n);
                }))
                continue;
            Bare bare{block.parts[i], ElementIndex{first + static_cast<std::uint32_t>(i)}, {nodes[0]}};
            if (row.node_count == 3 && nodes[2] != kNoNode && has_place(mesh, nodes[2]))
                bare.nodes.push_back(nodes[2]);
            if (row.corner_count == 2) bare.nodes.push_back(nodes[1]);
            out.push_back(std::move(bare));
        }
        first += static_cast<std::uint32_t>(block.ids.size());
    }
    std::ranges::stable_sort(out, {}, &Bare::part);
    return out;
}

double largest_side(const Mesh& mesh, const Surface& surface, std::span<const Bare> bare) {
    Point3 low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    const auto add = [&](const Point3& at) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], at[i]);
            high[i] = std::max(high[i], at[i]);
        }
    };
    for (const Point3& at : surface.positions) add(at);
    for (const Bare& element : bare) {
        for (const NodeIndex node : element.nodes) add(mesh.coordinates[raw(node)]);
    }
    const double side = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    return side > 0 ? side : 1;
}

std::uint32_t add_vertex(
    Surface& surface, const Bare& bare, NodeIndex node, const Point3& at, const Point3& outward
) {
    surface.positions.push_back(at);
    surface.normals.push_back(unit(outward));
    surface.vertex_node.push_back(node);
    if (surface.domain == Domain::ElementNode) surface.vertex_element.push_back(bare.element);
    return static_cast<std::uint32_t>(surface.positions.size() - 1);
}

void add_triangle(Surface& surface, const Bare& bare, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    surface.triangles.push_back({VertexIndex{a}, VertexIndex{b}, VertexIndex{c}});
    surface.triangle_element.push_back(bare.element);
}

Point3 moved(const Point3& at, const Point3& by, double length) {
    return {at[0] + length * by[0], at[1] + length * by[1], at[2] + length * by[2]};
}

void add_tube(const Mesh& mesh, const Bare& beam, double radius, Surface& surface) {
    const Point3& start = mesh.coordinates[raw(beam.nodes.front())];
    const Point3 along = minus(mesh.coordinates[raw(beam.nodes.back())], start);
    const double length = std::sqrt(dot(along, along));
    if (!(length > 0)) return;
    std::size_t thinnest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(along[i]) < std::abs(along[thinnest])) thinnest = i;
    }
    Point3 axis{};
    axis[thinnest] = 1;
    Point3 u = cross(along, axis);
    const double u_length = std::sqrt(dot(u, u));
    for (double& v : u) v /= u_length;
    Point3 w = cross(along, u);
    for (double& v : w) v /= length;
    std::array<Point3, kSides> outward{};
    for (std::size_t k = 0; k < kSides; ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kSides;
        outward[k] = moved(moved({}, u, std::cos(angle)), w, std::sin(angle));
    }
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < beam.nodes.size(); ++i) {
        const auto ring = static_cast<std::uint32_t>(surface.positions.size());
        for (const Point3& side : outward) {
            const Point3& centre = mesh.coordinates[raw(beam.nodes[i])];
            add_vertex(surface, beam, beam.nodes[i], moved(centre, side, radius), side);
        }
        for (std::uint32_t k = 0; i > 0 && k < kSides; ++k) {
            const auto next = static_cast<std::uint32_t>((k + 1) % kSides);
            add_triangle(surface, beam, before + k, before + next, ring + next);
            add_triangle(surface, beam, before + k, ring + next, ring + k);
        }
        before = ring;
    }
}

void add_octahedron(const Mesh& mesh, const Bare& point, double radius, Surface& surface) {
    static constexpr std::array<std::uint8_t, 3> kFacets[]{
        {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    const auto first = static_cast<std::uint32_t>(surface.positions.size());
    for (std::size_t i = 0; i < 6; ++i) {
        Point3 outward{};
        outward[i / 2] = i % 2 == 0 ? 1 : -1;
        const Point3& centre = mesh.coordinates[raw(point.nodes[0])];
        add_vertex(surface, point, point.nodes[0], moved(centre, outward, radius), outward);
    }
    for (const auto& [a, b, c] : kFacets) add_triangle(surface, point, first + a, first + b, first + c);
}

/// A part of the surface for each part of the mesh among `elements`.
template <class Add>
void add_parts(std::span<const Bare> elements, PartKind kind, Surface& surface, Add add) {
    for (std::size_t i = 0; i < elements.size();) {
        SurfacePart part;
        part.part = elements[i].part;
        part.kind = kind;
        part.first_vertex = static_cast<std::uint32_t>(surface.positions.size());
        part.first_triangle = static_cast<std::uint32_t>(surface.triangles.size());
        part.first_edge = static_cast<std::uint32_t>(surface.edges.size());
        for (; i < elements.size() && elements[i].part == part.part; ++i) add(elements[i]);
        part.vertex_count = static_cast<std::uint32_t>(surface.positions.size()) - part.first_vertex;
        part.triangle_count = static_cast<std::uint32_t>(surface.triangles.size()) - part.first_triangle;
        if (part.triangle_count > 0) surface.parts.push_back(part);
    }
}

}  // namespace

void add_glyphs(const Mesh& mesh, Surface& surface, Diagnostics& diagnostics) {
    const std::vector<Bare> beams = bare_elements(mesh, 1);
    const double tube = largest_side(mesh, surface, beams) * kTubeRadius;
    add_parts(beams, PartKind::Beam, surface, [&](const Bare& beam) { add_tube(mesh, beam, tube, surface); });
    const std::vector<Bare> points = bare_elements(mesh, 0);
    if (points.empty()) return;
    if (!surface.parts.empty()) {
        diagnostics.add(
            Code::SkippedElement,
            std::string(),
            "point elements are not drawn beside other elements",
            points.size()
        );
        return;
    }
    const double radius = largest_side(mesh, surface, points) * kPointRadius;
    add_parts(points, PartKind::Point, surface, [&](const Bare& point) {
        add_octahedron(mesh, point, radius, surface);
    });
}

}  // namespace feelem
