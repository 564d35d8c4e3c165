// SPDX-License-Identifier: Apache-2.0
// THE table: one row for each element type. Facets are outward by the right hand, corners first, then
// mid-side nodes in the order of the facet's own type. Sources: VTK's cell classes for the order of mid-side
// nodes; the solvers' common corner order (triangle 0 1 2 of a wedge faces 3 4 5), as decision 0006 says.
#pragma once

#include "feelem/element_type.hpp"

#include <array>

namespace feelem::element_table {

using enum ElementType;

constexpr EdgeRow edge(int first, int second, int middle = kNoLocalNode) {
    return {
        static_cast<std::uint8_t>(first),
        static_cast<std::uint8_t>(second),
        static_cast<std::uint8_t>(middle)};
}

template <class... Local>
constexpr FacetRow facet(ElementType type, Local... local) {
    return {type, {static_cast<std::uint8_t>(local)...}};
}

/// A row without its facets, edges and coordinates.
constexpr ElementRow row(
    ElementType type,
    std::string_view name,
    int dimension,
    int order,
    int nodes,
    int corners,
    int vtk,
    ElementType linear
) {
    ElementRow r;
    r.type = type;
    r.name = name;
    r.dimension = static_cast<std::uint8_t>(dimension);
    r.order = static_cast<std::uint8_t>(order);
    r.node_count = static_cast<std::uint8_t>(nodes);
    r.corner_count = static_cast<std::uint8_t>(corners);
    r.vtk_type = static_cast<std::uint8_t>(vtk);
    r.linear = linear;
    return r;
}

template <std::size_t N>
constexpr ElementRow with_facets(ElementRow r, const FacetRow (&facets)[N]) {
    for (std::size_t i = 0; i < N; ++i) r.facets[i] = facets[i];
    r.facet_count = N;
    return r;
}

using Coordinates = std::array<float, 3>;

/// Adds the edges, and the reference coordinates: corners as given, mid-side nodes halfway, the rest as
/// given.
template <std::size_t Edges, std::size_t Corners, std::size_t Rest = 1>
constexpr ElementRow with_edges(
    ElementRow r,
    const EdgeRow (&edges)[Edges],
    const Coordinates (&corners)[Corners],
    const Coordinates (&rest)[Rest] = {{}}
) {
    for (std::size_t i = 0; i < Corners; ++i) r.reference[i] = corners[i];
    std::size_t next = Corners;
    for (std::size_t i = 0; i < Edges; ++i) {
        r.edges[i] = edges[i];
        if (edges[i].middle == kNoLocalNode) continue;
        ++next;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            r.reference[edges[i].middle][axis] =
                (corners[edges[i].first][axis] + corners[edges[i].second][axis]) / 2;
        }
    }
    for (std::size_t i = 0; next < r.node_count; ++i, ++next) r.reference[next] = rest[i];
    r.edge_count = Edges;
    return r;
}

inline constexpr Coordinates kLine[]{{0, 0, 0}, {1, 0, 0}};
inline constexpr Coordinates kTriangle[]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
inline constexpr Coordinates kSquare[]{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
inline constexpr Coordinates kTetrahedron[]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline constexpr Coordinates kPyramid[]{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5F, 0.5F, 1}};
inline constexpr Coordinates kWedge[]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
inline constexpr Coordinates kCube[]{
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
inline constexpr Coordinates kSquareCentre[]{{0.5F, 0.5F, 0}};
inline constexpr Coordinates kWedgeQuads[]{{0.5F, 0, 0.5F}, {0.5F, 0.5F, 0.5F}, {0, 0.5F, 0.5F}};
inline constexpr Coordinates kCubeRest[]{
    {0, 0.5F, 0.5F},
    {1, 0.5F, 0.5F},
    {0.5F, 0, 0.5F},
    {0.5F, 1, 0.5F},
    {0.5F, 0.5F, 0},
    {0.5F, 0.5F, 1},
    {0.5F, 0.5F, 0.5F}};

// clang-format off
inline constexpr std::array<ElementRow, kElementTypeCount> kTable{
    row(Point1, "point", 0, 1, 1, 1, 1, Point1),
    with_edges(row(Line2, "line2", 1, 1, 2, 2, 3, Line2), {edge(0, 1)}, kLine),
    with_edges(row(Line3, "line3", 1, 2, 3, 2, 21, Line2), {edge(0, 1, 2)}, kLine),

    with_edges(
        with_facets(row(Tri3, "tri3", 2, 1, 3, 3, 5, Tri3), {facet(Tri3, 0, 1, 2)}),
        {edge(0, 1), edge(1, 2), edge(2, 0)},
        kTriangle
    ),
    with_edges(
        with_facets(row(Tri6, "tri6", 2, 2, 6, 3, 22, Tri3), {facet(Tri6, 0, 1, 2, 3, 4, 5)}),
        {edge(0, 1, 3), edge(1, 2, 4), edge(2, 0, 5)},
        kTriangle
    ),
    with_edges(
        with_facets(row(Quad4, "quad4", 2, 1, 4, 4, 9, Quad4), {facet(Quad4, 0, 1, 2, 3)}),
        {edge(0, 1), edge(1, 2), edge(2, 3), edge(3, 0)},
        kSquare
    ),
    with_edges(
        with_facets(row(Quad8, "quad8", 2, 2, 8, 4, 23, Quad4), {facet(Quad8, 0, 1, 2, 3, 4, 5, 6, 7)}),
        {edge(0, 1, 4), edge(1, 2, 5), edge(2, 3, 6), edge(3, 0, 7)},
        kSquare
    ),
    with_edges(
        with_facets(row(Quad9, "quad9", 2, 2, 9, 4, 28, Quad4), {facet(Quad9, 0, 1, 2, 3, 4, 5, 6, 7, 8)}),
        {edge(0, 1, 4), edge(1, 2, 5), edge(2, 3, 6), edge(3, 0, 7)},
        kSquare,
        kSquareCentre
    ),

    with_edges(
        with_facets(
            row(Tet4, "tet4", 3, 1, 4, 4, 10, Tet4),
            {facet(Tri3, 0, 1, 3), facet(Tri3, 1, 2, 3), facet(Tri3, 2, 0, 3), facet(Tri3, 0, 2, 1)}
        ),
        {edge(0, 1), edge(1, 2), edge(2, 0), edge(0, 3), edge(1, 3), edge(2, 3)},
        kTetrahedron
    ),
    with_edges(
        with_facets(
            row(Tet10, "tet10", 3, 2, 10, 4, 24, Tet4),
            {facet(Tri6, 0, 1, 3, 4, 8, 7),
             facet(Tri6, 1, 2, 3, 5, 9, 8),
             facet(Tri6, 2, 0, 3, 6, 7, 9),
             facet(Tri6, 0, 2, 1, 6, 5, 4)}
        ),
        {edge(0, 1, 4), edge(1, 2, 5), edge(2, 0, 6), edge(0, 3, 7), edge(1, 3, 8), edge(2, 3, 9)},
        kTetrahedron
    ),

    with_edges(
        with_facets(
            row(Pyramid5, "pyramid5", 3, 1, 5, 5, 14, Pyramid5),
            {facet(Quad4, 0, 3, 2, 1),
             facet(Tri3, 0, 1, 4),
             facet(Tri3, 1, 2, 4),
             facet(Tri3, 2, 3, 4),
             facet(Tri3, 3, 0, 4)}
        ),
        {edge(0, 1), edge(1, 2), edge(2, 3), edge(3, 0), edge(0, 4), edge(1, 4), edge(2, 4), edge(3, 4)},
        kPyramid
    ),
    with_edges(
        with_facets(
            row(Pyramid13, "pyramid13", 3, 2, 13, 5, 27, Pyramid5),
            {facet(Quad8, 0, 3, 2, 1, 8, 7, 6, 5),
             facet(Tri6, 0, 1, 4, 5, 10, 9),
             facet(Tri6, 1, 2, 4, 6, 11, 10),
             facet(Tri6, 2, 3, 4, 7, 12, 11),
             facet(Tri6, 3, 0, 4, 8, 9, 12)}
        ),
        {edge(0, 1, 5),
         edge(1, 2, 6),
         edge(2, 3, 7),
         edge(3, 0, 8),
         edge(0, 4, 9),
         edge(1, 4, 10),
         edge(2, 4, 11),
         edge(3, 4, 12)},
        kPyramid
    ),

    with_edges(
        with_facets(
            row(Wedge6, "wedge6", 3, 1, 6, 6, 13, Wedge6),
            {facet(Tri3, 0, 2, 1),
             facet(Tri3, 3, 4, 5),
             facet(Quad4, 0, 1, 4, 3),
             facet(Quad4, 1, 2, 5, 4),
             facet(Quad4, 2, 0, 3, 5)}
        ),
        {edge(0, 1),
         edge(1, 2),
         edge(2, 0),
         edge(3, 4),
         edge(4, 5),
         edge(5, 3),
         edge(0, 3),
         edge(1, 4),
         edge(2, 5)},
        kWedge
    ),
    with_edges(
        with_facets(
            row(Wedge15, "wedge15", 3, 2, 15, 6, 26, Wedge6),
            {facet(Tri6, 0, 2, 1, 8, 7, 6),
             facet(Tri6, 3, 4, 5, 9, 10, 11),
             facet(Quad8, 0, 1, 4, 3, 6, 13, 9, 12),
             facet(Quad8, 1, 2, 5, 4, 7, 14, 10, 13),
             facet(Quad8, 2, 0, 3, 5, 8, 12, 11, 14)}
        ),
        {edge(0, 1, 6),
         edge(1, 2, 7),
         edge(2, 0, 8),
         edge(3, 4, 9),
         edge(4, 5, 10),
         edge(5, 3, 11),
         edge(0, 3, 12),
         edge(1, 4, 13),
         edge(2, 5, 14)},
        kWedge
    ),
    with_edges(
        with_facets(
            row(Wedge18, "wedge18", 3, 2, 18, 6, 32, Wedge6),
            {facet(Tri6, 0, 2, 1, 8, 7, 6),
             facet(Tri6, 3, 4, 5, 9, 10, 11),
             facet(Quad9, 0, 1, 4, 3, 6, 13, 9, 12, 15),
             facet(Quad9, 1, 2, 5, 4, 7, 14, 10, 13, 16),
             facet(Quad9, 2, 0, 3, 5, 8, 12, 11, 14, 17)}
        ),
        {edge(0, 1, 6),
         edge(1, 2, 7),
         edge(2, 0, 8),
         edge(3, 4, 9),
         edge(4, 5, 10),
         edge(5, 3, 11),
         edge(0, 3, 12),
         edge(1, 4, 13),
         edge(2, 5, 14)},
        kWedge,
        kWedgeQuads
    ),

    with_edges(
        with_facets(
            row(Hex8, "hex8", 3, 1, 8, 8, 12, Hex8),
            {facet(Quad4, 0, 4, 7, 3),
             facet(Quad4, 1, 2, 6, 5),
             facet(Quad4, 0, 1, 5, 4),
             facet(Quad4, 3, 7, 6, 2),
             facet(Quad4, 0, 3, 2, 1),
             facet(Quad4, 4, 5, 6, 7)}
        ),
        {edge(0, 1),
         edge(1, 2),
         edge(2, 3),
         edge(3, 0),
         edge(4, 5),
         edge(5, 6),
         edge(6, 7),
         edge(7, 4),
         edge(0, 4),
         edge(1, 5),
         edge(2, 6),
         edge(3, 7)},
        kCube
    ),
    with_edges(
        with_facets(
            row(Hex20, "hex20", 3, 2, 20, 8, 25, Hex8),
            {facet(Quad8, 0, 4, 7, 3, 16, 15, 19, 11),
             facet(Quad8, 1, 2, 6, 5, 9, 18, 13, 17),
             facet(Quad8, 0, 1, 5, 4, 8, 17, 12, 16),
             facet(Quad8, 3, 7, 6, 2, 19, 14, 18, 10),
             facet(Quad8, 0, 3, 2, 1, 11, 10, 9, 8),
             facet(Quad8, 4, 5, 6, 7, 12, 13, 14, 15)}
        ),
        {edge(0, 1, 8),
         edge(1, 2, 9),
         edge(2, 3, 10),
         edge(3, 0, 11),
         edge(4, 5, 12),
         edge(5, 6, 13),
         edge(6, 7, 14),
         edge(7, 4, 15),
         edge(0, 4, 16),
         edge(1, 5, 17),
         edge(2, 6, 18),
         edge(3, 7, 19)},
        kCube
    ),
    with_edges(
        with_facets(
            row(Hex27, "hex27", 3, 2, 27, 8, 29, Hex8),
            {facet(Quad9, 0, 4, 7, 3, 16, 15, 19, 11, 20),
             facet(Quad9, 1, 2, 6, 5, 9, 18, 13, 17, 21),
             facet(Quad9, 0, 1, 5, 4, 8, 17, 12, 16, 22),
             facet(Quad9, 3, 7, 6, 2, 19, 14, 18, 10, 23),
             facet(Quad9, 0, 3, 2, 1, 11, 10, 9, 8, 24),
             facet(Quad9, 4, 5, 6, 7, 12, 13, 14, 15, 25)}
        ),
        {edge(0, 1, 8),
         edge(1, 2, 9),
         edge(2, 3, 10),
         edge(3, 0, 11),
         edge(4, 5, 12),
         edge(5, 6, 13),
         edge(6, 7, 14),
         edge(7, 4, 15),
         edge(0, 4, 16),
         edge(1, 5, 17),
         edge(2, 6, 18),
         edge(3, 7, 19)},
        kCube,
        kCubeRest
    ),
};

// clang-format on

constexpr bool table_is_in_order() {
    for (std::size_t i = 0; i < kTable.size(); ++i) {
        if (static_cast<std::size_t>(kTable[i].type) != i) return false;
    }
    return true;
}
static_assert(table_is_in_order(), "a row for each ElementType, in the order of the enum");

}  // namespace feelem::element_table
