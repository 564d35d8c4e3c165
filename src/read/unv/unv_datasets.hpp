// SPDX-License-Identifier: Apache-2.0
// Where the datasets of a universal file are: each stands between two lines "    -1".
#pragma once

#include "base/input.hpp"

#include "feelem/diagnostics.hpp"

#include <cstddef>
#include <vector>

namespace feelem::unv {

struct Dataset {
    int number = 0;         ///< 2411 nodes, 2412 elements ...
    std::size_t first = 0;  ///< The line after the number.
    std::size_t last = 0;   ///< The closing line.
};

/// All datasets, in file order. One that the file's end cuts off is listed and reported (TruncatedInput).
std::vector<Dataset> find_datasets(const Input& input, Diagnostics& diagnostics);

/// Whether the text starts as a universal file does.
bool starts_like_unv(const Input& input);

}  // namespace feelem::unv
