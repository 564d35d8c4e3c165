// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/print_results.hpp"

#include "base/letter_case.hpp"
#include "read/abaqus/fil_names.hpp"
#include "read/result_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

namespace feelem::printed {
namespace {

/// What a column's name says: "S12" is component xy of S.
struct ColumnMeaning {
    std::string variable;  ///< Abaqus' name without the direction: "S", "U", "UR", "MISES".
    std::string name;      ///< Ours.
    Shape shape = Shape::Scalar;
    Shear shear = Shear::NotApplicable;
    std::size_t axis = 0;  ///< Of x y z, or of xx yy zz xy yz zx.
};

struct Rotation {
    std::string_view printed, ours;
};
constexpr auto kRotations = std::to_array<Rotation>({
    {"UR", "rotation"},
    {"VR", "rotational_velocity"},
    {"AR", "rotational_acceleration"},
    {"RM", "reaction_moment"},
    {"CM", "rotational_concentrated_force"},
});

/// Degrees of freedom 11 are the first (or only) one of nodes.
constexpr auto kFirstOfSeveral = std::to_array<Rotation>({
    {"NT11", "NT"},
    {"RFL11", "RFL"},
    {"CFL11", "CFL"},
});

constexpr std::array<std::string_view, 3> kAxisNames{"x", "y", "z"};
constexpr std::array<std::string_view, 6> kTensorNames{"xx", "yy", "zz", "xy", "yz", "zx"};
constexpr std::array<std::string_view, 6> kTensorDigits{"11", "22", "33", "12", "23", "13"};

std::optional<ColumnMeaning> tensor_column(std::string_view column) {
    if (column.size() < 3) return {};
    const auto* digits = std::ranges::find(kTensorDigits, column.substr(column.size() - 2));
    const std::string_view base = column.substr(0, column.size() - 2);
    const fil::Variable* variable = fil::find_variable(base);
    if (digits == kTensorDigits.end() || variable == nullptr || variable->form != fil::Form::Tensor)
        return {};
    return ColumnMeaning{
        std::string(base),
        std::string(variable->ours),
        Shape::SymmetricTensor,
        variable->shear,
        static_cast<std::size_t>(digits - kTensorDigits.begin())};
}

std::optional<ColumnMeaning> vector_column(std::string_view column) {
    if (column.size() < 2 || column.back() < '1' || column.back() > '3') return {};
    const std::string_view base = column.substr(0, column.size() - 1);
    ColumnMeaning out{std::string(base), "", Shape::Vector, Shear::NotApplicable, 0};
    out.axis = static_cast<std::size_t>(column.back() - '1');
    const fil::Variable* variable = fil::find_variable(base);
    const auto* rotation = std::ranges::find(kRotations, base, &Rotation::printed);
    if (variable != nullptr && (variable->form == fil::Form::Dofs || variable->form == fil::Form::Vector)) {
        out.name = std::string(variable->ours);
    } else if (rotation != kRotations.end()) {
        out.name = std::string(rotation->ours);
    } else if (base == "COOR") {
        out.name = "coordinates";
    } else {
        return {};
    }
    return out;
}

ColumnMeaning meaning_of(std::string_view column) {
    if (auto found = tensor_column(column)) return *found;
    if (auto found = vector_column(column)) return *found;
    const auto* first = std::ranges::find(kFirstOfSeveral, column, &Rotation::printed);
    const fil::Variable* variable = fil::find_variable(first != kFirstOfSeveral.end() ? first->ours : column);
    const bool known = variable != nullptr && variable->form == fil::Form::Plain;
    return {
        std::string(column),
        known ? std::string(variable->ours) : lower_case(column),
        Shape::Scalar,
        Shear::NotApplicable,
        0};
}

class PrintLister {
public:
    explicit PrintLister(std::span<const PrintedTable> tables) : tables_(tables) {}

    std::vector<PrintedResult> list() {
        for (std::size_t t = 0; t < tables_.size(); ++t) {
            const PrintedTable& table = tables_[t];
            for (std::size_t c = 0; c < table.columns.size(); ++c) {
                const ColumnMeaning meaning = meaning_of(table.columns[c]);
                if (table.section_key == 0) add(t, c, 0, meaning);
                for (const std::int64_t section : table.sections) add(t, c, section, meaning);
            }
        }
        for (PrintedResult& result : results_) finish(result);
        ResultNames names;
        for (PrintedResult& result : results_) names.make_unique(result.info);
        return std::move(results_);
    }

private:
    using Quantity = std::tuple<std::uint32_t, std::string, Place>;  ///< Step, Abaqus' name, place.

    void add(std::size_t t, std::size_t column, std::int64_t section, const ColumnMeaning& meaning) {
        const PrintedTable& table = tables_[t];
        const Quantity quantity{table.step, meaning.variable, table.place};
        const auto [found, is_new] = by_quantity_.try_emplace({quantity, section}, results_.size());
        if (is_new) results_.push_back(new_result(table, section, meaning));
        results_[found->second].sources.push_back({t, column, meaning.axis});
        if (section > 0) sections_[quantity].insert(section);
    }

    static PrintedResult new_result(
        const PrintedTable& table, std::int64_t section, const ColumnMeaning& meaning
    ) {
        PrintedResult result;
        result.place = table.place;
        result.section = section;
        ResultInfo& info = result.info;
        info.name = meaning.name;
        info.solver_name = meaning.variable;
        info.step = table.step;
        info.shape = meaning.shape;
        info.shear = meaning.shear;
        const bool nodal = table.place == Place::Node || table.place == Place::Averaged;
        info.location = nodal                                ? Location::Nodal
                        : table.place == Place::ElementNodes ? Location::ElementNodal
                                                             : Location::Elemental;
        if (table.place == Place::Averaged) info.averaging = Averaging::Solver;
        if (table.place == Place::ElementNodes) info.averaging = Averaging::None;
        return result;
    }

    void finish(PrintedResult& result) {
        ResultInfo& info = result.info;
        name_components(result);
        // As in results files: the lowest section point is the bottom, the highest the top.
        const auto& sections = sections_[{info.step, info.solver_name, result.place}];
        if (result.section > 0) {
            const bool several = sections.size() > 1;
            if (several && result.section == *sections.begin()) {
                info.layer = Layer::Bottom;
            } else if (several && result.section == *sections.rbegin()) {
                info.layer = Layer::Top;
            } else {
                info.name += fmt::format("_point_{}", result.section);
            }
        }
        if (result.place == Place::Point) info.solver_name += " (mean of integration points)";
    }

    /// Tensors have all six components, vectors those that are printed, in the order of axes.
    static void name_components(PrintedResult& result) {
        ResultInfo& info = result.info;
        if (info.shape == Shape::Scalar) {
            info.components = {"value"};
            return;
        }
        if (info.shape == Shape::SymmetricTensor) {
            info.components.assign(kTensorNames.begin(), kTensorNames.end());
            return;
        }
        std::array<bool, 3> there{};
        for (const Source& source : result.sources) there[source.component] = true;
        std::array<std::size_t, 3> place{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            place[axis] = info.components.size();
            if (there[axis]) info.components.emplace_back(kAxisNames[axis]);
        }
        for (Source& source : result.sources) source.component = place[source.component];
        if (info.components.size() == 1) info.shape = Shape::Scalar;
    }

    std::span<const PrintedTable> tables_;
    std::vector<PrintedResult> results_;
    std::map<std::pair<Quantity, std::int64_t>, std::size_t> by_quantity_;
    std::map<Quantity, std::set<std::int64_t>> sections_;
};

}  // namespace

std::vector<PrintedResult> list_printed(std::span<const PrintedTable> tables) {
    return PrintLister(tables).list();
}

}  // namespace feelem::printed
