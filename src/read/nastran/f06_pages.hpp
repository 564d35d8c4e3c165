// SPDX-License-Identifier: Apache-2.0
// The pages of a print file: which table of which step each holds, and where its rows are.
#pragma once

#include "base/input.hpp"
#include "read/nastran/printed_tables.hpp"

#include "feelem/diagnostics.hpp"

namespace feelem::nastran {

/// All tables of results at grid points. Tables that are not used are reported (UnknownBlock), once a title.
PrintedTables find_pages(const Input& input, Diagnostics& diagnostics);

}  // namespace feelem::nastran
