// SPDX-License-Identifier: Apache-2.0
#include "vtk/ensight_check.hpp"

#include "base/input.hpp"
#include "read/exchange/ensight_case.hpp"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
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
    for (const EnsightCase::Variable& variable : all.variables) {
        if (variable.measured || variable.name.empty()) continue;
        const std::string name = file_at(all, variable.file, time);
        const Input file = Input::from_file((folder / name).string());
        if (is_ensight_text(file.text())) check_values(name, file.text(), all, variable, leaves);
    }
}

}  // namespace feelem::exchange
