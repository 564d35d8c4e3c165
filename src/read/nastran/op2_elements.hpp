// SPDX-License-Identifier: Apache-2.0
// Stresses and strains of solids, shells and rods.
#pragma once

#include "read/element_lookup.hpp"
#include "read/nastran/op2_ident.hpp"
#include "read/nastran/op2_records.hpp"

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace feelem::op2 {

/// How a block's rows look.
enum class RowShape : std::uint8_t {
    Solid,         ///< Centre and corners, a tensor each.
    SolidComplex,  ///< Two tensors each.
    ShellCorner,   ///< Centre and corners, two fibres each.
    ShellCentre,   ///< Centre only, two fibres.
    Bar,           ///< One axial number at a place.
    BarEnds,       ///< Largest and smallest at both ends.
};

/// What is listed of a kind of element.
struct ElementLayout {
    int type = 0;  ///< Word 3 of the ident.
    RowShape shape = RowShape::Solid;
    std::size_t corners = 0;  ///< Bars: the word of the axial number.
    std::size_t row_words = 0;
    std::size_t point_words = 0;  ///< Of a centre or corner.
};
/// Nothing when the block holds no stresses or strains that Feelem knows.
const ElementLayout* element_layout(const Ident& ident);

/// The ends of bars whose axial number is what `layout` lists; null for all others.
const ElementLayout* ends_layout(const ElementLayout& layout);

/// What becomes one result: elements of several types together.
enum class Quantity : std::uint8_t {
    SolidCorner,
    SolidComplex,
    ShellCorner,
    ShellCentre,
    Axial,
    BarEnds
};

/// What the last columns and the fibres hold, from word 11 of the ident.
struct StressKind {
    bool strain = false;
    bool von_mises = false;  ///< Else the largest shear.
    bool curvature = false;  ///< Fibres are the middle and the curvature.
};
std::optional<StressKind> stress_kind(const Ident& ident);

struct ElementBlockRef {
    const ElementLayout* layout = nullptr;
    std::size_t record = 0;
};

struct ElementResult {
    StepKey step;
    Quantity quantity = Quantity::SolidCorner;
    StressKind kind;
    bool polar = false;  ///< Complex: amplitude and phase.
    /// Complex: 0 the real part or amplitude, 1 the other.
    int fibre = 0;  ///< Shells: 0 the lower one (middle), 1 the upper one (curvature).
    std::string table;
    std::vector<ElementBlockRef> blocks;
};

struct ElementValues {
    std::vector<float> values;
    std::vector<std::uint32_t> row_owner;  ///< Empty: a row an element of the mesh.
    std::vector<NodeIndex> row_node;
    std::uint64_t without_element = 0;  ///< Elements or corners that the mesh does not have.
    std::uint64_t without_number = 0;
    std::uint64_t other_system = 0;  ///< Solids whose tensor is not in the basic system: invariants only.
};
/// Throws Error(BadStructure).
ElementValues read_elements(
    const Input& input,
    const Layout& layout,
    const ElementResult& result,
    const Mesh& mesh,
    const ElementLookup& lookup
);

/// Names, shape and place of the values; name and step are the caller's.
ResultInfo element_info(const ElementResult& result);

}  // namespace feelem::op2
