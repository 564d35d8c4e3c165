// SPDX-License-Identifier: Apache-2.0
// Words and numbers in the lines between rows, and what rows without such lines look like.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace feelem::ansys {

/// The start of a line, trimmed, in capitals: listings have them, tables made by hand may not.
std::string capitals_of(std::string_view line);

inline bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// The number behind "KEY=" in a line.
std::optional<double> number_after(std::string_view text, std::string_view key);
int whole_after(std::string_view text, std::string_view key, int otherwise);

/// What a line that begins with a number would be in a list without column names.
struct RowGuess {
    std::size_t numbers = 0;  ///< Behind the id; 0: no row.
    bool whole = true;        ///< None of them has a point.
    bool angles = false;      ///< The last three have two decimals, as THXY THYZ THZX do.
};
RowGuess guess_row(std::string_view line);

/// Whether the head of a file has a title, a page head or column names of such a list.
bool has_list_title(std::string_view head);
/// Whether the head of a file is rows of numbers as a list without titles has them.
bool has_list_rows(std::string_view head);

}  // namespace feelem::ansys
