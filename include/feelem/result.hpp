// SPDX-License-Identifier: Apache-2.0
// Results: what they are (cheap to list) and their values (loaded one at a time).
#pragma once

#include "feelem/ids.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {

enum class StepKind : std::uint8_t {
    Static,
    Time,
    Mode,
    Frequency,
    Buckling,
    Other
};

/// One load step and substep (increment, mode, frequency) of one input. Key: (input, step, substep).
struct Step {
    std::uint32_t input = 0;  ///< Index of the input file.
    std::int32_t step = 1;
    std::int32_t substep = 1;
    StepKind kind = StepKind::Other;
    double value = 0;  ///< Time, Hz or load factor; equal values may occur twice.
    std::string label;
};

enum class Location : std::uint8_t {
    Nodal,         ///< One row a node of the mesh, in index order.
    PartNodal,     ///< One row a (part, node): values averaged within a part, or one table a material.
    Elemental,     ///< One row an element of the mesh, in index order.
    ElementNodal,  ///< One row an (element, node): unaveraged.
};
enum class Shape : std::uint8_t {
    Scalar,
    Vector,
    SymmetricTensor,
    Other
};
enum class Averaging : std::uint8_t {
    NotApplicable,
    Solver,
    Part,
    All,
    None
};
enum class Complex : std::uint8_t {
    No,
    Real,
    Imaginary,
    Amplitude,
    Phase
};
enum class Layer : std::uint8_t {
    No,
    Top,
    Middle,
    Bottom
};
enum class Shear : std::uint8_t {
    NotApplicable,
    Engineering,
    Tensor
};

/// What a result is. Component names: "value" (scalar), x y z, xx yy zz xy yz zx (that order, whatever the
/// file's); else the solver's own in lower case. A derived component that the file lists itself (USUM, SEQV,
/// S1) is a component of the same result, by our name: magnitude von_mises tresca principal_1 principal_2
/// principal_3.
struct ResultInfo {
    std::string name;  ///< docs/cli.md: displacement temperature stress ...; else the label in lower case.
    std::string solver_name;  ///< As written: DISP, U, NDTEMP.
    std::vector<std::string> components;
    std::string unit;        ///< Empty: unknown.
    std::uint32_t step = 0;  ///< Index into ModelSource::steps().
    Location location = Location::Nodal;
    Shape shape = Shape::Scalar;  ///< Of the leading components; derived ones may follow them.
    Averaging averaging = Averaging::NotApplicable;
    Complex complex = Complex::No;
    Layer layer = Layer::No;
    Shear shear = Shear::NotApplicable;
    std::string system;  ///< "cylindrical:OX,OY,OZ,AX,AY,AZ"; empty: that of the file or the global one.
    bool nodal_system = false;  ///< Components are in rotated nodal systems (Mesh::node_angles).
    bool corner_only = false;   ///< The solver lists corner nodes only (PRNSOL,S): decision 0010.
    bool on_request = false;    ///< Shown when it is named, or all are asked for (volumes of elements).
};

/// Values as the solver gave them, rounded once to float; NaN = missing.
struct Result {
    ResultInfo info;
    std::vector<float> values;             ///< rows x components, row by row.
    std::vector<std::uint32_t> row_owner;  ///< PartNodal: part index; ElementNodal: element index. Ascending.
    std::vector<NodeIndex> row_node;       ///< PartNodal, ElementNodal: the node; ascending within a part.

    std::size_t component_count() const noexcept { return info.components.size(); }
    std::size_t row_count() const noexcept {
        return info.components.empty() ? 0 : values.size() / info.components.size();
    }
};

std::string_view word(StepKind kind);
std::string_view word(Location location);
std::string_view word(Averaging averaging);
std::string_view word(Complex complex);
std::string_view word(Layer layer);
std::string_view word(Shear shear);

/// Index of a component by name, or -1.
int component_index(const ResultInfo& info, std::string_view name);

/// Smallest and largest valid value of a component and their rows: the smallest id on a tie.
struct Range {
    float min = 0;
    float max = 0;
    std::size_t min_row = 0;
    std::size_t max_row = 0;
    std::uint64_t valid = 0;  ///< Rows with a value; 0: the rest means nothing.
};
Range range_of(const Result& result, std::size_t component);

}  // namespace feelem
