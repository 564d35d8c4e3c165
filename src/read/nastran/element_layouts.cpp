// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/element_layouts.hpp"

#include <algorithm>

namespace feelem::op2 {
namespace {

constexpr ElementLayout solid(int type, std::size_t corners) {
    return {type, RowShape::Solid, corners, kSolidHead + kSolidPoint * (corners + 1), kSolidPoint};
}
/// 13 words a point, or 14 with a von Mises amplitude.
constexpr ElementLayout complex_solid(int type, std::size_t corners, std::size_t point) {
    return {type, RowShape::SolidComplex, corners, kSolidHead + point * (corners + 1), point};
}
constexpr ElementLayout shell(int type, std::size_t corners) {
    return {type, RowShape::ShellCorner, corners, kShellHead + kShellPoint * (corners + 1), kShellPoint};
}
constexpr ElementLayout centre(int type) {
    return {type, RowShape::ShellCentre, 0, kShellPoint, kShellPoint};
}

/// 7 words a fibre, or 8 with a von Mises amplitude.
constexpr ElementLayout complex_shell(int type, std::size_t corners, std::size_t fibre) {
    return {type, RowShape::ShellComplex, corners, kShellHead + (1 + 2 * fibre) * (corners + 1), fibre};
}
constexpr ElementLayout complex_centre(int type, std::size_t fibre) {
    return {type, RowShape::ShellComplex, 0, 1 + 2 * fibre, fibre};
}

constexpr ElementLayout ply(int type) {
    return {type, RowShape::Ply, 0, 11, 0};
}
constexpr ElementLayout nonlinear_solid(int type, std::size_t corners) {
    constexpr std::size_t kPoint = 16;
    return {type, RowShape::NonlinearSolid, corners, kNonlinearHead + kPoint * (corners + 1), kPoint};
}
constexpr ElementLayout nonlinear_shell(int type) {
    constexpr std::size_t kFibre = 12;
    return {type, RowShape::NonlinearShell, 0, 1 + 2 * kFibre, kFibre};
}

constexpr std::array kLayouts{
    ElementLayout{1, RowShape::Bar, 1, 5, 0},   // CROD
    ElementLayout{3, RowShape::Bar, 1, 5, 0},   // CTUBE
    ElementLayout{10, RowShape::Bar, 1, 5, 0},  // CONROD
    ElementLayout{34, RowShape::Bar, 5, 16, 0},
    ElementLayout{34, RowShape::BarEnds, 2, 16, 0},              // CBAR
    ElementLayout{2, RowShape::BarEnds, 11, 111, kBeamStation},  // CBEAM
    solid(39, 4),                                                // CTETRA
    solid(67, 8),                                                // CHEXA
    solid(68, 6),                                                // CPENTA
    solid(255, 5),                                               // CPYRAM
    complex_solid(39, 4, 13),
    complex_solid(39, 4, 14),
    complex_solid(67, 8, 13),
    complex_solid(67, 8, 14),
    complex_solid(68, 6, 13),
    complex_solid(68, 6, 14),
    complex_solid(255, 5, 13),
    complex_solid(255, 5, 14),
    ElementLayout{1, RowShape::BarComplex, 1, 5, 2},
    ElementLayout{3, RowShape::BarComplex, 1, 5, 2},
    ElementLayout{10, RowShape::BarComplex, 1, 5, 2},
    ElementLayout{34, RowShape::BarComplex, 5, 19, 10},
    ElementLayout{34, RowShape::BarPoints, 2, 19, 0},
    ElementLayout{2, RowShape::BeamPoints, 11, 111, kBeamStation},
    complex_centre(33, 7),
    complex_centre(33, 8),
    complex_centre(74, 7),
    complex_centre(74, 8),
    complex_centre(227, 7),
    complex_centre(227, 8),
    complex_centre(228, 7),
    complex_centre(228, 8),
    complex_shell(64, 4, 7),
    complex_shell(64, 4, 8),
    complex_shell(70, 3, 7),
    complex_shell(70, 3, 8),
    complex_shell(75, 3, 7),
    complex_shell(75, 3, 8),
    complex_shell(82, 4, 7),
    complex_shell(82, 4, 8),
    complex_shell(144, 4, 7),
    complex_shell(144, 4, 8),
    centre(33),              // CQUAD4
    centre(74),              // CTRIA3
    centre(227),             // CTRIAR
    centre(228),             // CQUADR
    shell(64, 4),            // CQUAD8
    shell(70, 3),            // CTRIAR
    shell(75, 3),            // CTRIA6
    shell(82, 4),            // CQUADR
    shell(144, 4),           // CQUAD4
    ply(95),                 // CQUAD4
    ply(96),                 // CQUAD8
    ply(97),                 // CTRIA3
    ply(98),                 // CTRIA6
    ply(232),                // CQUADR
    ply(233),                // CTRIAR
    nonlinear_solid(85, 4),  // CTETRA
    nonlinear_solid(91, 6),  // CPENTA
    nonlinear_solid(93, 8),  // CHEXA
    nonlinear_shell(88),     // CTRIA3
    nonlinear_shell(90),     // CQUAD4
};

}  // namespace

bool is_complex_shape(RowShape shape) {
    return shape == RowShape::SolidComplex || shape == RowShape::ShellComplex ||
           shape == RowShape::BarComplex || shape == RowShape::BarPoints || shape == RowShape::BeamPoints;
}

const ElementLayout* find_layout(std::int64_t type, std::size_t row_words, bool is_complex) {
    const auto found = std::ranges::find_if(kLayouts, [&](const ElementLayout& layout) {
        return layout.type == type && layout.row_words == row_words &&
               is_complex_shape(layout.shape) == is_complex;
    });
    return found == kLayouts.end() ? nullptr : &*found;
}

const ElementLayout* layout_of_type(std::int64_t type) {
    const auto found = std::ranges::find_if(kLayouts, [&](const ElementLayout& layout) {
        return layout.type == type && !is_complex_shape(layout.shape);
    });
    return found == kLayouts.end() ? nullptr : &*found;
}

const ElementLayout* second_layout(const ElementLayout& layout) {
    if (layout.shape != RowShape::Bar && layout.shape != RowShape::BarComplex) return nullptr;
    const RowShape second = layout.shape == RowShape::Bar ? RowShape::BarEnds : RowShape::BarPoints;
    const auto found = std::ranges::find_if(kLayouts, [&](const ElementLayout& other) {
        return other.type == layout.type && other.shape == second;
    });
    return found == kLayouts.end() ? nullptr : &*found;
}

}  // namespace feelem::op2
