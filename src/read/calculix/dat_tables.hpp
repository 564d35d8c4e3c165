// SPDX-License-Identifier: Apache-2.0
// The tables of a CalculiX .dat file: where they are and what their heads say. Rows are read on demand.
#pragma once

#include "base/input.hpp"

#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace feelem::dat {

/// " stresses (elem, integ.pnt.,sxx,...) for set EALL and time  0.1000000E+01" and the rows below it.
struct Table {
    std::string label;                    ///< "stresses"
    std::vector<std::string> components;  ///< "sxx" ...; empty: not said.
    bool of_elements = false;
    bool has_points = false;  ///< Rows are of integration points.
    bool is_local = false;    ///< Rows end with the name of a local system.
    std::int32_t step = 1, increment = 1;
    double time = 0;
    std::size_t begin = 0, end = 0;  ///< Of the rows.
    std::size_t rows = 0;
    std::size_t columns = 0;  ///< Values of the first row.
};

/// All tables with rows, in file order. Sums over sets and tables of modes are none.
std::vector<Table> find_tables(const Input& input);

/// Whether the text begins like such a file.
bool starts_like_tables(std::string_view head);

/// A result and the tables that it is made of (one a set).
struct Listed {
    ResultInfo info;
    std::vector<std::size_t> tables;
    std::vector<std::uint32_t> columns;  ///< Component i is column columns[i] of a row.
};
struct Contents {
    std::vector<Step> steps;
    std::vector<Listed> results;
};
Contents list_tables(const std::vector<Table>& tables);

}  // namespace feelem::dat
