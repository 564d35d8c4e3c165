// SPDX-License-Identifier: Apache-2.0
// Rows of Abaqus' printed tables -> the values of one result, checked against the tables' own extremes.
#pragma once

#include "read/abaqus/print_results.hpp"
#include "read/element_lookup.hpp"

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace feelem::printed {

struct PrintedValues {
    Result result;
    std::uint64_t without_place = 0;         ///< Rows of nodes or elements that the mesh does not have.
    std::uint64_t without_number = 0;        ///< Values that are no finite numbers.
    std::uint64_t nodes = 0;                 ///< Rows of the result with any value.
    std::vector<std::string> disagreements;  ///< Where a table's extremes are not those of its rows.
};

/// Throws Error(BadNumber) on a value that is no number.
PrintedValues load_printed(
    const Input& input,
    const PrintedResult& listed,
    std::span<const PrintedTable> tables,
    const Mesh& mesh,
    const ElementLookup& elements
);

}  // namespace feelem::printed
