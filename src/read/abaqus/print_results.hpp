// SPDX-License-Identifier: Apache-2.0
// Columns of Abaqus' printed tables -> results: which columns of which tables a result is made of.
#pragma once

#include "read/abaqus/print_tables.hpp"

#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace feelem::printed {

/// A column of a table that is a component of a result.
struct Source {
    std::size_t table = 0;   ///< Into PrintedFile::tables.
    std::size_t column = 0;  ///< Of the table.
    std::size_t component = 0;
};

/// One quantity of one step, at one kind of place and section point, out of as many tables as there are sets
/// and types of elements.
struct PrintedResult {
    ResultInfo info;
    Place place = Place::Node;
    std::int64_t section = 0;  ///< 0: tables without section points.
    std::vector<Source> sources;
};

std::vector<PrintedResult> list_printed(std::span<const PrintedTable> tables);

}  // namespace feelem::printed
