// SPDX-License-Identifier: Apache-2.0
// The pages of a print file: which table of which step each holds, and where its rows are.
#pragma once

#include "base/input.hpp"
#include "read/nastran/printed_tables.hpp"

#include "feelem/diagnostics.hpp"

#include <string>
#include <string_view>

namespace feelem::nastran {

/// Whether a line starts a page of Nastran's print file.
bool is_page_head(std::string_view line);

/// "D I S P L A C E M E N T   V E C T O R" as "DISPLACEMENT VECTOR"; empty when the line is not spaced so.
std::string spaced_title(std::string_view line);

/// All tables of results at grid points. Tables that are not used are reported (UnknownBlock), once a title.
PrintedTables find_pages(const Input& input, Diagnostics& diagnostics);

/// One row of such a table.
bool read_f06_row(
    std::string_view text, std::size_t& at, std::size_t last, const PrintedRows& rows, PrintedRow& row
);

}  // namespace feelem::nastran
