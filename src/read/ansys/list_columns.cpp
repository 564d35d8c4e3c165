// SPDX-License-Identifier: Apache-2.0
// The table of column names.
#include "read/ansys/list_columns.hpp"

#include "base/letter_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace feelem::ansys {
namespace {

enum class Parts {
    Scalar,    ///< The stem itself.
    Vector,    ///< Stem + X Y Z SUM.
    Rotation,  ///< ROTX ROTY ROTZ RSUM.
    Stress,    ///< Stem + X Y Z XY YZ XZ 1 2 3 INT EQV.
    Strain,    ///< Likewise, with engineering shear.
};

struct Quantity {
    std::string_view stem;   ///< What the column's name begins with.
    std::string_view label;  ///< Of the command that lists it; our solver_name.
    std::string_view name;
    Parts parts;
    bool is_dof = false;  ///< A solved unknown: listed at every node, never averaged.
    Layer layer = Layer::No;
};

constexpr std::array kQuantities{
    Quantity{"U", "U", "displacement", Parts::Vector, true},
    Quantity{"ROT", "ROT", "rotation", Parts::Rotation, true},
    Quantity{"TEMP", "TEMP", "temperature", Parts::Scalar, true},
    Quantity{"TTOP", "TEMP", "temperature", Parts::Scalar, true, Layer::Top},
    Quantity{"TBOT", "TEMP", "temperature", Parts::Scalar, true, Layer::Bottom},
    Quantity{"VOLT", "VOLT", "electric_potential", Parts::Scalar, true},
    Quantity{"PRES", "PRES", "pressure", Parts::Scalar, true},
    Quantity{"MAG", "MAG", "magnetic_scalar_potential", Parts::Scalar, true},
    Quantity{"V", "V", "velocity", Parts::Vector, true},
    Quantity{"VEL", "VEL", "velocity", Parts::Vector, true},
    Quantity{"ACC", "ACC", "acceleration", Parts::Vector, true},
    Quantity{"A", "A", "magnetic_vector_potential", Parts::Vector, true},
    Quantity{"S", "S", "stress", Parts::Stress},
    Quantity{"EPEL", "EPEL", "elastic_strain", Parts::Strain},
    Quantity{"EPPL", "EPPL", "plastic_strain", Parts::Strain},
    Quantity{"EPCR", "EPCR", "creep_strain", Parts::Strain},
    Quantity{"EPTH", "EPTH", "thermal_strain", Parts::Strain},
    Quantity{"EPTO", "EPTO", "strain", Parts::Strain},
    Quantity{"EPTT", "EPTT", "total_strain", Parts::Strain},
    Quantity{"TF", "TF", "heat_flux", Parts::Vector},
    Quantity{"TG", "TG", "temperature_gradient", Parts::Vector},
    Quantity{"EF", "EF", "electric_field", Parts::Vector},
    Quantity{"D", "D", "electric_flux_density", Parts::Vector},
    Quantity{"H", "H", "magnetic_field", Parts::Vector},
    Quantity{"B", "B", "magnetic_flux_density", Parts::Vector},
    Quantity{"JC", "JC", "current_density", Parts::Vector},
};

/// Of reaction listings (PRRSOL).
constexpr std::array kReactions{
    Quantity{"F", "F", "reaction_force", Parts::Vector, true},
    Quantity{"M", "M", "reaction_moment", Parts::Vector, true},
    Quantity{"HEAT", "HEAT", "reaction_heat_flow", Parts::Scalar, true},
    Quantity{"AMPS", "AMPS", "reaction_current", Parts::Scalar, true},
};

struct Ending {
    std::string_view text;
    std::string_view component;
};
constexpr std::array kVectorEndings{
    Ending{"X", "x"}, Ending{"Y", "y"}, Ending{"Z", "z"}, Ending{"SUM", "magnitude"}};
constexpr std::array kTensorEndings{
    Ending{"X", "xx"},
    Ending{"Y", "yy"},
    Ending{"Z", "zz"},
    Ending{"XY", "xy"},
    Ending{"YZ", "yz"},
    Ending{"XZ", "zx"},
    Ending{"1", "principal_1"},
    Ending{"2", "principal_2"},
    Ending{"3", "principal_3"},
    Ending{"INT", "tresca"},
    Ending{"EQV", "von_mises"},
};

/// The component that a column is of a quantity; empty when it is none.
std::string_view component_of_column(const Quantity& quantity, std::string_view column) {
    if (quantity.parts == Parts::Scalar) return column == quantity.stem ? "value" : "";
    if (quantity.parts == Parts::Rotation && column == "RSUM") return "magnitude";
    if (!column.starts_with(quantity.stem)) return {};
    const std::string_view rest = column.substr(quantity.stem.size());
    if (quantity.parts == Parts::Vector || quantity.parts == Parts::Rotation) {
        const auto* found = std::ranges::find(kVectorEndings, rest, &Ending::text);
        return found == kVectorEndings.end() ? "" : found->component;
    }
    const auto* found = std::ranges::find(kTensorEndings, rest, &Ending::text);
    if (found == kTensorEndings.end()) return {};
    // Strain has no Tresca or von Mises value: these are the solver's own equivalents.
    if (quantity.parts == Parts::Strain && rest == "INT") return "intensity";
    if (quantity.parts == Parts::Strain && rest == "EQV") return "equivalent";
    return found->component;
}

struct Found {
    const Quantity* quantity = nullptr;
    std::string_view component;
};

template <std::size_t N>
Found find_quantity(const std::array<Quantity, N>& table, std::string_view column) {
    for (const Quantity& quantity : table) {
        const std::string_view component = component_of_column(quantity, column);
        if (!component.empty()) return {&quantity, component};
    }
    return {};
}

bool is_axis(std::string_view component) {
    constexpr std::array kAxes{"x", "y", "z", "xx", "yy", "zz", "xy", "yz", "zx"};
    return std::ranges::find(kAxes, component) != kAxes.end();
}

/// The components in our order: whatever follows the ones along axes is derived.
int rank_of(std::string_view component) {
    constexpr std::array kOrder{
        "x",
        "y",
        "z",
        "xx",
        "yy",
        "zz",
        "xy",
        "yz",
        "zx",
        "value",
        "magnitude",
        "principal_1",
        "principal_2",
        "principal_3",
        "tresca",
        "von_mises"};
    return static_cast<int>(std::ranges::find(kOrder, component) - kOrder.begin());
}

void sort_components(ColumnGroup& group) {
    std::vector<std::pair<std::string, std::size_t>> pairs;
    for (std::size_t i = 0; i < group.columns.size(); ++i) {
        pairs.emplace_back(group.info.components[i], group.columns[i]);
    }
    std::ranges::stable_sort(pairs, {}, [](const auto& pair) { return rank_of(pair.first); });
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        group.info.components[i] = pairs[i].first;
        group.columns[i] = pairs[i].second;
    }
}

/// All axes of a vector or tensor there: then its invariants and its direction mean something.
Shape shape_of(const Quantity& quantity, const std::vector<std::string>& components) {
    if (quantity.parts == Parts::Scalar) return Shape::Scalar;
    const bool tensor = quantity.parts == Parts::Stress || quantity.parts == Parts::Strain;
    const auto axes = std::ranges::count_if(components, is_axis);
    if (tensor && axes == 6) return Shape::SymmetricTensor;
    if (!tensor && axes == 3) return Shape::Vector;
    return components.size() == 1 ? Shape::Scalar : Shape::Other;
}

ColumnGroup& group_of(std::vector<ColumnGroup>& groups, const ResultInfo& like) {
    const auto found = std::ranges::find_if(groups, [&](const ColumnGroup& group) {
        return group.info.name == like.name && group.info.layer == like.layer;
    });
    if (found != groups.end()) return *found;
    groups.push_back({like, {}});
    return groups.back();
}

Averaging averaging_of(const List& list) {
    switch (list.kind) {
    case ListKind::NodalValues: return Averaging::Solver;
    case ListKind::ElementNodalValues: return Averaging::None;
    default: return Averaging::NotApplicable;
    }
}

}  // namespace

std::vector<ColumnGroup> group_columns(const List& list) {
    const ValueHead& head = list.head;
    const bool reactions = head.title.find("REACTION") != std::string::npos;
    const bool foreign_axes = head.axes == AxesNote::Other;
    std::vector<ColumnGroup> groups;
    std::vector<const Quantity*> quantities;
    for (std::size_t column = 0; column < head.columns.size(); ++column) {
        const std::string_view text = head.columns[column];
        // CONT and NL listings have columns (PRES, SEPL) whose names mean other things elsewhere.
        const bool own = head.label == "CONT" || head.label == "NL" || list.kind == ListKind::ElementValues;
        const Found found = own         ? Found{}
                            : reactions ? find_quantity(kReactions, text)
                                        : find_quantity(kQuantities, text);
        ResultInfo info;
        info.averaging = averaging_of(list);
        std::string component;
        if (found.quantity != nullptr) {
            info.name = found.quantity->name;
            info.solver_name = found.quantity->label;
            info.layer = found.quantity->layer;
            if (found.quantity->parts == Parts::Strain) info.shear = Shear::Engineering;
            if (found.quantity->is_dof) info.averaging = Averaging::NotApplicable;
            info.nodal_system = head.axes == AxesNote::Nodal;
            component =
                foreign_axes && is_axis(found.component) ? lower_case(text) : std::string(found.component);
        } else if (list.kind == ListKind::ElementValues) {
            info.name = lower_case(text);
            info.solver_name = text;
            component = "value";
        } else {
            info.name = head.label.empty() ? "values" : lower_case(head.label);
            info.solver_name = head.label;
            component = lower_case(text);
        }
        ColumnGroup& group = group_of(groups, info);
        if (static_cast<std::size_t>(&group - groups.data()) == quantities.size())
            quantities.push_back(found.quantity);
        group.columns.push_back(column);
        group.info.components.push_back(std::move(component));
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        ColumnGroup& group = groups[i];
        if (quantities[i] == nullptr) {
            group.info.shape = group.columns.size() == 1 ? Shape::Scalar : Shape::Other;
            continue;
        }
        sort_components(group);
        group.info.shape = shape_of(*quantities[i], group.info.components);
        if (foreign_axes && group.info.shape != Shape::Scalar) group.info.shape = Shape::Other;
    }
    return groups;
}

bool is_derived_component(std::string_view component) {
    constexpr std::array kDerived{
        "magnitude",
        "principal_1",
        "principal_2",
        "principal_3",
        "tresca",
        "von_mises",
        "intensity",
        "equivalent"};
    return std::ranges::find(kDerived, component) != kDerived.end();
}

std::vector<std::string> default_columns(std::string_view label, std::size_t count) {
    constexpr std::array kVector{"X", "Y", "Z", "SUM"};
    constexpr std::array kTensor{"X", "Y", "Z", "XY", "YZ", "XZ"};
    constexpr std::array kPrincipal{"1", "2", "3", "INT", "EQV"};
    std::vector<std::string> columns;
    const auto* quantity = std::ranges::find(kQuantities, label, &Quantity::label);
    if (quantity != kQuantities.end()) {
        const bool vector = quantity->parts == Parts::Vector;
        const bool tensor = quantity->parts == Parts::Stress || quantity->parts == Parts::Strain;
        const auto name = [&](const auto& endings) {
            for (std::size_t i = 0; i < count; ++i) columns.push_back(std::string(label) + endings[i]);
        };
        if (quantity->parts == Parts::Scalar && count == 1) return {std::string(label)};
        if (quantity->parts == Parts::Rotation && count == 4) return {"ROTX", "ROTY", "ROTZ", "RSUM"};
        if ((vector && (count == 3 || count == 4)) || (quantity->parts == Parts::Rotation && count == 3))
            name(kVector);
        else if (tensor && count == 6)
            name(kTensor);
        else if (tensor && count == 5)
            name(kPrincipal);
    }
    while (columns.size() < count) columns.push_back(fmt::format("COLUMN_{}", columns.size() + 1));
    return columns;
}

}  // namespace feelem::ansys
