// SPDX-License-Identifier: Apache-2.0
// Lines of a print file: heads of pages, spaced titles, rows of tables.
#pragma once

#include "read/nastran/printed_tables.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace feelem::nastran {

/// Whether a line starts a page of Nastran's print file.
bool is_page_head(std::string_view line);

/// "D I S P L A C E M E N T   V E C T O R" as "DISPLACEMENT VECTOR"; empty when the line is not spaced so.
std::string spaced_title(std::string_view line);

/// Whether a line may be a spaced title: quick, for lines that are none as a rule.
bool is_spaced(std::string_view line);

/// A row's start: its carriage control off, then a number and the letter of its kind.
struct RowStart {
    std::string_view number, rest;
    char kind = 0;
};
std::optional<RowStart> row_start(std::string_view line);

/// Numbers and nothing else: the second line of a complex row.
bool is_number_line(std::string_view line);

/// One row of such a table.
bool read_f06_row(
    std::string_view text, std::size_t& at, std::size_t last, const PrintedRows& rows, PrintedRow& row
);

}  // namespace feelem::nastran
