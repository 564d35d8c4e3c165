// SPDX-License-Identifier: Apache-2.0
#include "vtk/ensight_check.hpp"

#include "base/input.hpp"
#include "read/exchange/ensight_case.hpp"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace feelem::exchange {
namespace {

/// Characters of a value in a text file of EnSight 6, where six stand in a line.
constexpr std::ptrdiff_t kWidth = 12;

std::ptrdiff_t values_in(const Leaf& leaf, const EnsightCase::Variable& variable) {
    vtkDataSetAttributes* const data = variable.nodal
                                           ? static_cast<vtkDataSetAttributes*>(leaf.data->GetPointData())
                                           : leaf.data->GetCellData();
    vtkDataArray* const array = data->GetArray(variable.name.c_str());
    return array == nullptr ? 0 : array->GetNumberOfTuples() * array->GetNumberOfComponents();
}

/// In binary files each run of elements of one type stands behind its name.
struct Runs {
    std::ptrdiff_t runs = 0, nodes = 0;  ///< `nodes`: of all elements, each counted as often as it is named.
    bool fixed = true;                   ///< No polygons and polyhedra, no structured parts.
};

Runs runs_of(vtkDataSet* data) {
    Runs out;
    int before = -1;
    vtkNew<vtkIdList> points;
    for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c) {
        const int type = data->GetCellType(c);
        if (type != before) ++out.runs;
        before = type;
        data->GetCellPoints(c, points);
        out.nodes += points->GetNumberOfIds();
        out.fixed =
            out.fixed && type != VTK_POLYGON && type != VTK_POLYHEDRON && type != VTK_CONVEX_POINT_SET;
    }
    out.fixed = out.fixed && data->GetDataObjectType() == VTK_UNSTRUCTURED_GRID;
    return out;
}

constexpr std::ptrdiff_t kText = 80, kNumber = 4;

/// The least bytes of a binary file of these values.
std::ptrdiff_t least_binary_size(const EnsightCase::Variable& variable, const std::vector<Leaf>& leaves) {
    std::ptrdiff_t bytes = kText;
    for (const Leaf& leaf : leaves) {
        const std::ptrdiff_t values = values_in(leaf, variable);
        if (values == 0) continue;
        const std::ptrdiff_t sections = variable.nodal ? 1 : runs_of(leaf.data).runs;
        bytes += kText + kNumber + sections * kText + values * kNumber;
    }
    return bytes;
}

/// Whether a geometry file in C's binary form is as long as what VTK made of it needs.
bool has_binary_size(std::string_view file, const std::vector<Leaf>& leaves) {
    constexpr std::ptrdiff_t kExtents = kText + 6 * kNumber, kSection = kText + kNumber;
    const auto lists_ids = [&](std::size_t line) {
        const std::string_view text = file.substr(std::min(line * kText, file.size()), kText);
        return text.find("given") != std::string_view::npos || text.find("ignore") != std::string_view::npos;
    };
    const bool node_ids = lists_ids(3), element_ids = lists_ids(4);
    std::ptrdiff_t bytes = 5 * kText;
    for (const Leaf& leaf : leaves) {
        const Runs runs = runs_of(leaf.data);
        if (!runs.fixed) return true;
        bytes += 3 * kText + 2 * kNumber + (node_ids ? 4 : 3) * kNumber * leaf.data->GetNumberOfPoints();
        bytes += runs.runs * kSection + kNumber * runs.nodes;
        if (element_ids) bytes += kNumber * leaf.data->GetNumberOfCells();
    }
    // Two sections of one type may follow each other.
    const std::ptrdiff_t more = static_cast<std::ptrdiff_t>(file.size()) - bytes;
    return more >= 0 && (more % kSection == 0 || (more >= kExtents && (more - kExtents) % kSection == 0));
}

[[noreturn]] void refuse(const std::string& file, const std::string& trouble) {
    throw std::runtime_error(file + ": " + trouble);
}

void check_values(
    const std::string& file,
    std::string_view text,
    const EnsightCase& all,
    const EnsightCase::Variable& variable,
    const std::vector<Leaf>& leaves
) {
    if (const std::string trouble = trouble_of_ensight_end(text); !trouble.empty()) refuse(file, trouble);
    std::ptrdiff_t sum = 0, most = 0;
    for (const Leaf& leaf : leaves) {
        sum += values_in(leaf, variable);
        most = std::max(most, values_in(leaf, variable));
    }
    if (!all.is_gold) {
        // In EnSight 6 all parts share their nodes.
        const std::ptrdiff_t least = kWidth * (variable.nodal ? most : sum);
        if (static_cast<std::ptrdiff_t>(text.size()) < least)
            refuse(
                file, fmt::format("holds fewer than the {} values of its model: it was cut", least / kWidth)
            );
        return;
    }
    const std::ptrdiff_t count = count_ensight_values(text);
    if (count >= 0 && count != sum)
        refuse(
            file, fmt::format("holds {} values where its parts have {}: it was cut or is damaged", count, sum)
        );
}

}  // namespace

void expect_ensight_files(const std::string& case_path) {
    const std::filesystem::path folder = std::filesystem::path(case_path).parent_path();
    const EnsightCase all = read_ensight_case(Input::from_file(case_path).text());
    if (all.geometry.pattern.empty()) throw std::runtime_error("the case names no geometry (model: FILE)");
    for (const std::string& file : files_of(all)) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(folder / file, error))
            refuse(file, "the case names this file, which is not beside it");
    }
}

void check_ensight_files(const std::string& case_path, double time, const std::vector<Leaf>& leaves) {
    const EnsightCase all = read_ensight_case(Input::from_file(case_path).text());
    const std::filesystem::path folder = std::filesystem::path(case_path).parent_path();
    const Input geometry = Input::from_file((folder / file_at(all, all.geometry, time)).string());
    if (all.is_gold && is_ensight_text(geometry.text())) {
        std::string trouble = trouble_of_ensight_end(geometry.text());
        if (trouble.empty()) trouble = trouble_of_ensight_geometry(geometry.text());
        if (!trouble.empty()) refuse(file_at(all, all.geometry, time), trouble);
    }
    const bool is_plain = geometry.text().starts_with("C Binary") &&
                          geometry.text().substr(0, 400).find("BEGIN TIME STEP") == std::string_view::npos;
    if (all.is_gold && is_plain && !has_binary_size(geometry.text(), leaves))
        refuse(
            file_at(all, all.geometry, time), "is not as long as its parts need: it was cut or is damaged"
        );
    for (const EnsightCase::Variable& variable : all.variables) {
        if (variable.measured || variable.name.empty()) continue;
        const std::string name = file_at(all, variable.file, time);
        const Input file = Input::from_file((folder / name).string());
        if (is_ensight_text(file.text()))
            check_values(name, file.text(), all, variable, leaves);
        else if (all.is_gold && static_cast<std::ptrdiff_t>(file.size()) < least_binary_size(variable, leaves))
            refuse(name, "is shorter than its parts need: it was cut");
    }
}

}  // namespace feelem::exchange
