// SPDX-License-Identifier: Apache-2.0
// Tables that Workbench Mechanical exports: a number, perhaps a place, and results with their units.
#pragma once

#include "base/input.hpp"
#include "read/ansys/list_rows.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/result.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::ansys {

struct ExportFile {
    Input input;
    char line_end = '\n';
    char separator = '\t';
    bool decimal_comma = false;
    bool of_elements = false;
    bool has_places = false;          ///< X, Y, Z behind the number.
    std::string length_unit;          ///< Of the places: "mm".
    std::vector<ResultInfo> columns;  ///< One a result, without step and location.
    /// Rows whose numbers ascend: a body each, when a node is listed once a body.
    std::vector<TextRange> bodies;
    std::size_t rows = 0;
    bool repeats_numbers = false;  ///< A number stands in more than one row.
};

/// Whether the head of a file has the column line of such a table and a row below it.
bool is_export(std::string_view head);

/// Empty when no column holds node or element numbers.
std::optional<ExportFile> scan_export(const Input& input, Diagnostics& diagnostics);

struct ExportRow {
    ValueRow values;
    Point3 place{};  ///< When ExportFile::has_places.
};
/// Rows of [range). Throws Error(BadNumber).
void for_each_export_row(
    const ExportFile& file,
    TextRange range,
    Diagnostics* diagnostics,
    const std::function<void(const ExportRow&)>& use
);

}  // namespace feelem::ansys
