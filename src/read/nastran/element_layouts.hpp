// SPDX-License-Identifier: Apache-2.0
// How Nastran lists stresses and strains of elements: the words of a row, the same in .op2 and punch files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace feelem::op2 {

/// How a block's rows look.
enum class RowShape : std::uint8_t {
    Solid,         ///< Centre and corners, a tensor each.
    SolidComplex,  ///< Two tensors each.
    ShellCorner,   ///< Centre and corners, two fibres each.
    ShellCentre,   ///< Centre only, two fibres.
    ShellComplex,  ///< Centre and corners or centre alone, two fibres with three stresses of two parts each.
    Bar,           ///< One axial number at a place.
    BarComplex,    ///< Its two parts.
    BarEnds,       ///< Largest and smallest at both ends.
    BarPoints,     ///< Complex: four points of the section at both ends, without the axial part.
    BeamPoints,    ///< Complex: the same with it, at stations.
    Ply,           ///< A row a ply: stresses along its fibres and between plies.
    NonlinearSolid,  ///< Centre and corners: stress, equivalent stress, plastic and creep strain, strain.
    NonlinearShell,  ///< The same of two fibres, at the centre.
};

bool is_complex_shape(RowShape shape);

/// What is listed of a kind of element.
struct ElementLayout {
    int type = 0;  ///< Nastran's number of the element.
    RowShape shape = RowShape::Solid;
    std::size_t corners = 0;  ///< Bars: the word of the axial number. Beams: stations.
    std::size_t row_words = 0;
    std::size_t point_words =
        0;  ///< Of a centre or corner. Complex shells: of a fibre; bars: the other part.
};

inline constexpr std::size_t kSolidHead = 4;  ///< Number, system, "GRID", how many corners.
inline constexpr std::size_t kSolidPoint = 21;
inline constexpr std::size_t kShellHead = 2;  ///< Number, "CEN/".
inline constexpr std::size_t kShellPoint = 17;
inline constexpr std::size_t kFibreWords = 8;
inline constexpr std::size_t kNonlinearHead = 2;  ///< Number, "CEN/" or "GRID".
/// Grid (0: between the ends), place, four fibres, largest, smallest, margins.
inline constexpr std::size_t kBeamStation = 10;

/// Words of xx yy zz xy yz zx and the equivalent value after the point's grid.
inline constexpr std::array<std::size_t, 7> kSolidColumns{1, 9, 15, 2, 10, 16, 8};

/// Null when Feelem knows no such rows. Where a type has several layouts with as many words, the first one.
const ElementLayout* find_layout(std::int64_t type, std::size_t row_words, bool is_complex);

/// Of real numbers; null when Feelem knows no rows of that type.
const ElementLayout* layout_of_type(std::int64_t type);

/// What a row of a bar holds beside the axial number that `layout` lists; null for all others.
const ElementLayout* second_layout(const ElementLayout& layout);

/// What the last columns and the fibres hold.
struct StressKind {
    bool strain = false;
    bool von_mises = false;  ///< Else the largest shear.
    bool curvature = false;  ///< Fibres are the middle and the curvature.
    bool unnamed = false;    ///< The file does not say which of the two von_mises tells apart.

    friend auto operator<=>(const StressKind&, const StressKind&) = default;
};

}  // namespace feelem::op2
