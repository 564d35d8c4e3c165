// SPDX-License-Identifier: Apache-2.0
// Must: read the GRID cards that pre-processors write, fast, or refuse them.
// Assumes: nothing; what is refused the caller reads with BulkCard, which knows every form.
// Algorithm: the ends of free fields are found 64 characters at a time, fields of 8 or 16 columns lie in a
// register each; three coordinates are read at once where the processor can. Data: none.
#pragma once

#include "read/nastran/bulk_rows.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace feelem::nastran {

/// The GRID card at `at`. Gives where the next card starts.
std::optional<std::size_t> read_plain_grid(std::string_view text, std::size_t at, BulkGrid& grid);

}  // namespace feelem::nastran
