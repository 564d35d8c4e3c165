// SPDX-License-Identifier: Apache-2.0
// Column names of Ansys' listings -> results and components of ours.
#pragma once

#include "read/ansys/list_scan.hpp"

#include "feelem/result.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::ansys {

/// Columns of a list that make one result: a list of UX UY UZ TEMP holds two.
struct ColumnGroup {
    ResultInfo info;                   ///< Name, solver's name, components, shape, layer, shear, averaging.
    std::vector<std::size_t> columns;  ///< One a component.
};

/// The results in a list, in the order of their first columns. Components that are not along global or nodal
/// axes keep the solver's names, so that nothing is made of them by mistake.
std::vector<ColumnGroup> group_columns(const List& list);

/// Whether a component is made of others (magnitude, von_mises ...), be it by the solver.
bool is_derived_component(std::string_view component);

/// Columns of a list that does not name them, by its label and their number: U with four is UX UY UZ USUM.
/// COLUMN_1, COLUMN_2 ... when the label does not tell.
std::vector<std::string> default_columns(std::string_view label, std::size_t count);

}  // namespace feelem::ansys
