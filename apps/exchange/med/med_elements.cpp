// SPDX-License-Identifier: Apache-2.0
#include "med/med_elements.hpp"

#include <array>

namespace feelem::exchange {
namespace {

constexpr MedType kTypes[]{
    {"PO1", ElementType::Point1, 1},   {"SE2", ElementType::Line2, 2},    {"SE3", ElementType::Line3, 3},
    {"TR3", ElementType::Tri3, 3},     {"QU4", ElementType::Quad4, 4},    {"TR6", ElementType::Tri6, 6},
    {"TR7", ElementType::Tri6, 7},     {"QU8", ElementType::Quad8, 8},    {"QU9", ElementType::Quad9, 9},
    {"TE4", ElementType::Tet4, 4},     {"PY5", ElementType::Pyramid5, 5}, {"PE6", ElementType::Wedge6, 6},
    {"HE8", ElementType::Hex8, 8},     {"T10", ElementType::Tet10, 10},   {"P13", ElementType::Pyramid13, 13},
    {"P15", ElementType::Wedge15, 15}, {"P18", ElementType::Wedge15, 18}, {"H20", ElementType::Hex20, 20},
    {"H27", ElementType::Hex20, 27},
};

constexpr std::array<std::uint8_t, 4> kTet4{0, 2, 1, 3};
constexpr std::array<std::uint8_t, 10> kTet10{0, 2, 1, 3, 6, 5, 4, 7, 9, 8};
constexpr std::array<std::uint8_t, 5> kPyramid5{0, 3, 2, 1, 4};
constexpr std::array<std::uint8_t, 13> kPyramid13{0, 3, 2, 1, 4, 8, 7, 6, 5, 9, 12, 11, 10};
constexpr std::array<std::uint8_t, 6> kWedge6{0, 2, 1, 3, 5, 4};
constexpr std::array<std::uint8_t, 15> kWedge15{0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13};
constexpr std::array<std::uint8_t, 8> kHex8{0, 3, 2, 1, 4, 7, 6, 5};
constexpr std::array<std::uint8_t, 20> kHex20{0, 3, 2,  1,  4,  7,  6,  5,  11, 10,
                                              9, 8, 15, 14, 13, 12, 16, 19, 18, 17};

}  // namespace

std::span<const MedType> med_types() {
    return kTypes;
}

std::span<const std::uint8_t> mirrored_order(ElementType type) {
    switch (type) {
    case ElementType::Tet4: return kTet4;
    case ElementType::Tet10: return kTet10;
    case ElementType::Pyramid5: return kPyramid5;
    case ElementType::Pyramid13: return kPyramid13;
    case ElementType::Wedge6: return kWedge6;
    case ElementType::Wedge15: return kWedge15;
    case ElementType::Hex8: return kHex8;
    case ElementType::Hex20: return kHex20;
    default: return {};
    }
}

}  // namespace feelem::exchange
