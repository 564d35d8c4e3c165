// SPDX-License-Identifier: Apache-2.0
// The element types and their topology: one table, checked row by row by tests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace feelem {

/// Node order is the solvers' common one (decision 6): corners, then mid-side nodes as VTK orders its edges
/// (bottom, top, vertical). Triangle 0 1 2 of a wedge faces 3 4 5, so its normal points into the element.
enum class ElementType : std::uint8_t {
    Point1,
    Line2,
    Line3,
    Tri3,
    Tri6,
    Quad4,
    Quad8,
    Quad9,
    Tet4,
    Tet10,
    Pyramid5,
    Pyramid13,
    Wedge6,
    Wedge15,
    Wedge18,
    Hex8,
    Hex20,
    Hex27,
};
inline constexpr std::size_t kElementTypeCount = 18;
inline constexpr std::size_t kMaxElementNodes = 27;

/// One side of a solid (or a shell itself): its own type and the element's local nodes in that type's order,
/// outward by the right hand.
struct FacetRow {
    ElementType type = ElementType::Point1;
    std::array<std::uint8_t, 9> nodes{};
};

/// One edge: two corners and the mid-side node between them (kNoLocalNode on linear elements).
inline constexpr std::uint8_t kNoLocalNode = 255;
struct EdgeRow {
    std::uint8_t first = 0;
    std::uint8_t second = 0;
    std::uint8_t middle = kNoLocalNode;
};

struct ElementRow {
    ElementType type = ElementType::Point1;
    std::string_view name;       ///< "hex20": as `info` prints it.
    std::uint8_t dimension = 0;  ///< 0 point, 1 line, 2 shell, 3 solid.
    std::uint8_t order = 1;      ///< 1 linear, 2 quadratic.
    std::uint8_t node_count = 0;
    std::uint8_t corner_count = 0;
    std::uint8_t facet_count = 0;  ///< 0 for points and lines, 1 for shells (the element itself).
    std::uint8_t edge_count = 0;
    std::uint8_t vtk_type = 0;                 ///< VTK's cell type; wedges need a permutation at that border.
    ElementType linear = ElementType::Point1;  ///< The type of its corners alone.
    std::array<FacetRow, 6> facets{};
    std::array<EdgeRow, 12> edges{};
    std::array<std::array<float, 3>, kMaxElementNodes>
        reference{};  ///< Coordinates of the reference element.
};

const ElementRow& element_row(ElementType type) noexcept;
/// Views without the unused rest of the row.
std::span<const FacetRow> facets_of(ElementType type) noexcept;
std::span<const EdgeRow> edges_of(ElementType type) noexcept;
std::span<const std::uint8_t> facet_nodes(const FacetRow& facet) noexcept;  ///< corners, then mid-sides
std::span<const std::uint8_t> facet_corners(const FacetRow& facet) noexcept;

}  // namespace feelem
