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
    case RowShape::BarEnds: return Quantity::BarEnds;
    default: return Quantity::Axial;
    }
}

/// Parts of complex numbers, or fibres of shells.
bool has_two(RowShape shape) {
    return shape != RowShape::Solid && shape != RowShape::Bar && shape != RowShape::BarEnds;
}

const char* equivalent_name(const StressKind& kind, const char* shear) {
    if (kind.unnamed) return "equivalent";
    return kind.von_mises ? "von_mises" : shear;
}

}  // namespace

ResultInfo element_info(const ElementResult& result) {
    ResultInfo info;
    info.solver_name = result.table;
    const StressKind& kind = result.kind;
    const bool is_shell =
        result.quantity == Quantity::ShellCorner || result.quantity == Quantity::ShellCentre;
    switch (result.quantity) {
    case Quantity::SolidCorner:
        info.shape = Shape::SymmetricTensor;
        info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
        info.components.emplace_back(equivalent_name(kind, "octahedral_shear"));
        break;
    case Quantity::SolidComplex:
        info.shape = Shape::SymmetricTensor;
        info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
        info.complex = result.fibre == 0 ? (result.polar ? Complex::Amplitude : Complex::Real)
                                         : (result.polar ? Complex::Phase : Complex::Imaginary);
        break;
    case Quantity::Axial: info.components = {"value"}; break;
    case Quantity::BarEnds:
        info.shape = Shape::Other;
        info.components = {"max", "min"};
        break;
    default:
        info.shape = Shape::Other;
        info.components = {equivalent_name(kind, "max_shear"), "major", "minor"};
        break;
    }
    const bool by_element = result.quantity == Quantity::Axial || result.quantity == Quantity::ShellCentre;
    info.location = by_element ? Location::Elemental : Location::ElementNodal;
    info.averaging = by_element ? Averaging::NotApplicable : Averaging::None;
    if (kind.strain) info.shear = Shear::Engineering;
    if (is_shell && !kind.curvature) info.layer = result.fibre == 0 ? Layer::Bottom : Layer::Top;
    if (is_shell && kind.curvature && result.fibre == 0) info.layer = Layer::Middle;
    info.name = kind.strain ? "strain" : "stress";
    if (result.quantity == Quantity::Axial) info.name = "axial_" + info.name;
    if (result.quantity == Quantity::BarEnds) info.name = "bar_" + info.name;
    if (is_shell && kind.curvature && result.fibre == 1) info.name = "curvature";
    return info;
}

void ElementGroups::add(const Block& block, const ElementLayout& layout, std::size_t record) {
    for (const ElementLayout* one : {&layout, ends_layout(layout)}) {
        if (one == nullptr) continue;
        Group& group = groups_[{block.table, block.step, block.kind, one->shape}];
        group.polar = block.polar;
        group.blocks.push_back({one, record});
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
        const RowShape shape = std::get<RowShape>(key);
        ElementResult result{
            std::get<StepKey>(key),
            quantity_of(shape),
            std::get<StressKind>(key),
            group.polar,
            0,
            std::get<std::string>(key),
            group.blocks};
        for (result.fibre = 0; result.fibre < (has_two(shape) ? 2 : 1); ++result.fibre)
            results.push_back(result);
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
