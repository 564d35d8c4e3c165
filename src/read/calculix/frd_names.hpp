// SPDX-License-Identifier: Apache-2.0
// CalculiX' names of results and components -> Feelem's.
#pragma once

#include "read/calculix/frd_blocks.hpp"
#include "read/calculix/frd_values.hpp"

#include "feelem/result.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace feelem::frd {

/// A result and where its values are.
struct Listed {
    ResultInfo info;
    std::size_t block = 0;  ///< Into Layout::results.
    Columns columns;
};

struct Contents {
    std::vector<Step> steps;
    std::vector<Listed> results;
};

/// Steps and results of the blocks, in file order. Amplitudes and phases of one block are two results. Within
/// a step no two results have the same name, layer and complex part: a second one keeps its solver name.
Contents list_contents(std::span<const ResultBlock> blocks);

}  // namespace feelem::frd
