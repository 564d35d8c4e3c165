// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/element_results.hpp"

#include "base/letter_case.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace feelem::op2 {
namespace {

Quantity quantity_of(RowShape shape) {
    switch (shape) {
    case RowShape::Solid: return Quantity::SolidCorner;
    case RowShape::SolidComplex: return Quantity::SolidComplex;
    case RowShape::ShellCorner: return Quantity::ShellCorner;
    case RowShape::ShellCentre: return Quantity::ShellCentre;
    case RowShape::ShellComplex: return Quantity::ShellComplex;
    case RowShape::BarComplex: return Quantity::AxialComplex;
    case RowShape::BarEnds: return Quantity::BarEnds;
    case RowShape::BarPoints: return Quantity::BarPoints;
    case RowShape::BeamPoints: return Quantity::BeamPoints;
    case RowShape::Ply: return Quantity::Ply;
    case RowShape::NonlinearSolid: return Quantity::NonlinearSolid;
    case RowShape::NonlinearShell: return Quantity::NonlinearShell;
    case RowShape::Bar: break;
    }
    return Quantity::Axial;
}

bool is_shell(Quantity quantity) {
    return quantity == Quantity::ShellCorner || quantity == Quantity::ShellCentre ||
           quantity == Quantity::ShellComplex || quantity == Quantity::NonlinearShell;
}

bool is_complex(Quantity quantity) {
    return quantity == Quantity::SolidComplex || quantity == Quantity::ShellComplex ||
           quantity == Quantity::AxialComplex || quantity == Quantity::BarPoints ||
           quantity == Quantity::BeamPoints;
}

const char* equivalent_name(const StressKind& kind, const char* shear) {
    if (kind.unnamed) return "equivalent";
    return kind.von_mises ? "von_mises" : shear;
}

/// Shape and components.
void describe_columns(const ElementResult& result, ResultInfo& info) {
    const StressKind& kind = result.kind;
    info.shape = Shape::Other;
    switch (result.quantity) {
    case Quantity::SolidCorner:
    case Quantity::SolidComplex:
        info.shape = Shape::SymmetricTensor;
        info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
        if (result.quantity == Quantity::SolidCorner)
            info.components.emplace_back(equivalent_name(kind, "octahedral_shear"));
        break;
    case Quantity::Axial:
    case Quantity::AxialComplex:
        info.shape = Shape::Scalar;
        info.components = {"value"};
        break;
    case Quantity::BarEnds: info.components = {"max", "min"}; break;
    case Quantity::BarPoints:
    case Quantity::BeamPoints: info.components = {"c", "d", "e", "f"}; break;
    case Quantity::ShellComplex: info.components = {"normal_x", "normal_y", "shear_xy"}; break;
    case Quantity::Ply:
        info.components = {"normal_1", "normal_2", "shear_12", "shear_1z", "shear_2z"};
        info.components.emplace_back(equivalent_name(kind, "max_shear"));
        info.components.insert(info.components.end(), {"major", "minor"});
        break;
    case Quantity::NonlinearSolid:
    case Quantity::NonlinearShell:
        info.components = {"equivalent_stress", "plastic_strain", "creep_strain"};
        break;
    case Quantity::ShellCorner:
    case Quantity::ShellCentre:
        info.components = {equivalent_name(kind, "max_shear"), "major", "minor"};
        break;
    }
}

}  // namespace

bool is_by_element(Quantity quantity) {
    return quantity == Quantity::Axial || quantity == Quantity::AxialComplex ||
           quantity == Quantity::ShellCentre || quantity == Quantity::ShellComplex ||
           quantity == Quantity::Ply || quantity == Quantity::NonlinearShell;
}

ResultInfo element_info(const ElementResult& result) {
    ResultInfo info;
    info.solver_name = result.table;
    const StressKind& kind = result.kind;
    const Quantity quantity = result.quantity;
    describe_columns(result, info);
    if (is_complex(quantity))
        info.complex = result.part == 0 ? (result.polar ? Complex::Amplitude : Complex::Real)
                                        : (result.polar ? Complex::Phase : Complex::Imaginary);
    const bool by_element = is_by_element(quantity);
    info.location = by_element ? Location::Elemental : Location::ElementNodal;
    info.averaging = by_element ? Averaging::NotApplicable : Averaging::None;
    if (kind.strain) info.shear = Shear::Engineering;
    if (is_shell(quantity) && !kind.curvature) info.layer = result.fibre == 0 ? Layer::Bottom : Layer::Top;
    if (is_shell(quantity) && kind.curvature && result.fibre == 0) info.layer = Layer::Middle;
    info.name = kind.strain ? "strain" : "stress";
    if (quantity == Quantity::Axial || quantity == Quantity::AxialComplex) info.name = "axial_" + info.name;
    if (quantity == Quantity::BarEnds || quantity == Quantity::BeamPoints) info.name = "bar_" + info.name;
    if (quantity == Quantity::BarPoints) info.name = "bar_bending_" + info.name;
    if (is_shell(quantity) && kind.curvature && result.fibre == 1) info.name = "curvature";
    if (quantity == Quantity::Ply) info.name = fmt::format("ply_{}_{}", info.name, result.ply);
    if (quantity == Quantity::NonlinearSolid || quantity == Quantity::NonlinearShell)
        info.name = "nonlinear_state";
    return info;
}

void ElementGroups::add(const Block& block, ElementBlockRef rows) {
    for (const ElementLayout* one : {rows.layout, second_layout(*rows.layout)}) {
        if (one == nullptr) continue;
        Group& group = groups_[{block.table, block.step, block.kind, one->shape}];
        group.polar = block.polar;
        group.plies.insert(block.plies.begin(), block.plies.end());
        rows.layout = one;
        group.blocks.push_back(rows);
    }
}

std::vector<ElementResult> ElementGroups::finish() {
    for (auto& [key, group] : groups_) {
        if (std::get<RowShape>(key) != RowShape::ShellCentre) continue;
        auto with_corners = key;
        std::get<RowShape>(with_corners) = RowShape::ShellCorner;
        const auto found = groups_.find(with_corners);
        if (found == groups_.end()) continue;
        std::vector<ElementBlockRef>& blocks = found->second.blocks;
        blocks.insert(blocks.end(), group.blocks.begin(), group.blocks.end());
        group.blocks.clear();
    }
    std::vector<ElementResult> results;
    for (const auto& [key, group] : groups_) {
        if (group.blocks.empty()) continue;
        ElementResult result{
            std::get<StepKey>(key),
            quantity_of(std::get<RowShape>(key)),
            std::get<StressKind>(key),
            group.polar,
            0,
            0,
            0,
            std::get<std::string>(key),
            group.blocks};
        for (const std::int64_t ply : group.plies) {
            result.ply = ply;
            results.push_back(result);
        }
        if (result.quantity == Quantity::Ply) continue;
        const int parts = is_complex(result.quantity) ? 2 : 1;
        const int fibres = is_shell(result.quantity) ? 2 : 1;
        for (result.fibre = 0; result.fibre < fibres; ++result.fibre) {
            for (result.part = 0; result.part < parts; ++result.part) results.push_back(result);
        }
    }
    return results;
}

std::string ResultNames::unique(const ResultInfo& info, std::string_view name) {
    const auto take = [&](const std::string& one) {
        return names_.emplace(info.step, info.complex, info.layer, one).second;
    };
    if (take(std::string(name))) return std::string(name);
    const std::string with_table = fmt::format("{}_{}", name, lower_case(info.solver_name));
    if (take(with_table)) return with_table;
    int& number = repeats_[{info.step, with_table}];
    for (number = std::max(number, 1);;) {
        std::string numbered = fmt::format("{}_{}", with_table, ++number);
        if (take(numbered)) return numbered;
    }
}

}  // namespace feelem::op2
