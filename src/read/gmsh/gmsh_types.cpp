// SPDX-License-Identifier: Apache-2.0
#include "read/gmsh/gmsh_types.hpp"

#include <array>

namespace feelem::gmsh {
namespace {

constexpr std::array<std::uint8_t, 10> kTet10{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
constexpr std::array<std::uint8_t, 20> kHex20{0,  1, 2,  3,  4,  5,  6,  7,  8,  11,
                                              13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
constexpr std::array<std::uint8_t, 27> kHex27{0,  1,  2,  3,  4,  5,  6,  7,  8,  11, 13, 9,  16, 18,
                                              19, 17, 10, 12, 14, 15, 22, 23, 21, 24, 20, 25, 26};
constexpr std::array<std::uint8_t, 15> kWedge15{0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11};
constexpr std::array<std::uint8_t, 18> kWedge18{0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11, 15, 17, 16};
constexpr std::array<std::uint8_t, 13> kPyramid13{0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12};

// Of the 14-node pyramid the centre of the base is not used: no solver's pyramid has it.
const TypeRow kTypes[]{
    {1, "line", 2, true, ElementType::Line2, {}},
    {2, "triangle", 3, true, ElementType::Tri3, {}},
    {3, "quadrangle", 4, true, ElementType::Quad4, {}},
    {4, "tetrahedron", 4, true, ElementType::Tet4, {}},
    {5, "hexahedron", 8, true, ElementType::Hex8, {}},
    {6, "prism", 6, true, ElementType::Wedge6, {}},
    {7, "pyramid", 5, true, ElementType::Pyramid5, {}},
    {8, "line3", 3, true, ElementType::Line3, {}},
    {9, "triangle6", 6, true, ElementType::Tri6, {}},
    {10, "quadrangle9", 9, true, ElementType::Quad9, {}},
    {11, "tetrahedron10", 10, true, ElementType::Tet10, kTet10},
    {12, "hexahedron27", 27, true, ElementType::Hex27, kHex27},
    {13, "prism18", 18, true, ElementType::Wedge18, kWedge18},
    {14, "pyramid14", 14, true, ElementType::Pyramid13, kPyramid13},
    {15, "point", 1, true, ElementType::Point1, {}},
    {16, "quadrangle8", 8, true, ElementType::Quad8, {}},
    {17, "hexahedron20", 20, true, ElementType::Hex20, kHex20},
    {18, "prism15", 15, true, ElementType::Wedge15, kWedge15},
    {19, "pyramid13", 13, true, ElementType::Pyramid13, kPyramid13},
    {20, "triangle9", 9, false, {}, {}},
    {21, "triangle10", 10, false, {}, {}},
    {22, "triangle12", 12, false, {}, {}},
    {23, "triangle15", 15, false, {}, {}},
    {24, "triangle15 incomplete", 15, false, {}, {}},
    {25, "triangle21", 21, false, {}, {}},
    {26, "line4", 4, false, {}, {}},
    {27, "line5", 5, false, {}, {}},
    {28, "line6", 6, false, {}, {}},
    {29, "tetrahedron20", 20, false, {}, {}},
    {30, "tetrahedron35", 35, false, {}, {}},
    {31, "tetrahedron56", 56, false, {}, {}},
    {36, "quadrangle16", 16, false, {}, {}},
    {37, "quadrangle25", 25, false, {}, {}},
    {38, "quadrangle36", 36, false, {}, {}},
    {39, "quadrangle12", 12, false, {}, {}},
    {90, "prism40", 40, false, {}, {}},
    {91, "prism75", 75, false, {}, {}},
    {92, "hexahedron64", 64, false, {}, {}},
    {93, "hexahedron125", 125, false, {}, {}},
};

}  // namespace

const TypeRow* find_type(std::int64_t number) {
    for (const TypeRow& row : kTypes) {
        if (row.number == number) return &row;
    }
    return nullptr;
}

std::span<const std::uint8_t> file_order(ElementType type) {
    for (const TypeRow& row : kTypes) {
        if (row.known && row.type == type && row.number != 14) return row.order;
    }
    return {};
}

}  // namespace feelem::gmsh
