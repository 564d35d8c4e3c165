// SPDX-License-Identifier: Apache-2.0
// What a .op2 file holds: its steps and results by the heads of their tables.
#pragma once

#include "read/nastran/op2_elements.hpp"
#include "read/nastran/op2_nodal.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"

#include <string>
#include <vector>

namespace feelem::op2 {

/// A result and where its values stand.
struct Listed {
    ResultInfo info;
    bool of_elements = false;
    std::size_t block = 0;  ///< Into Contents::nodal or elements.
    std::size_t first = 0;  ///< Nodal: first number of a row.
};

struct Contents {
    std::vector<NodalBlock> nodal;
    std::vector<ElementResult> elements;
    std::vector<Step> steps;
    std::vector<Listed> results;
    std::string title;
};

/// Reads idents only (and of blocks sorted by node the steps of the first one). What is not used is
/// reported: UnknownBlock by table, EmptyResult.
Contents list_contents(const Input& input, const Layout& layout, Diagnostics& diagnostics);

}  // namespace feelem::op2
