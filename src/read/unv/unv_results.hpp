// SPDX-License-Identifier: Apache-2.0
// Datasets with results (2414, 55, 56, 57): what they hold, and their values.
#pragma once

#include "base/input.hpp"
#include "read/listed_source.hpp"
#include "read/unv/unv_datasets.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace feelem::unv {

/// A result and where its numbers are: one dataset can hold several (translations and rotations, the real and
/// the imaginary part).
struct Listed {
    ResultInfo info;
    std::size_t first = 0, last = 0;    ///< The records.
    std::uint32_t numbers_a_row = 0;    ///< In the file; complex ones are two.
    std::vector<std::uint32_t> places;  ///< For each component its place among them.
};

struct Contents {
    std::vector<Step> steps;
    std::vector<Listed> results;
};

/// From the heads alone.
Contents list_contents(const Input& input, std::span<const Dataset> datasets, Diagnostics& diagnostics);

/// Throws Error on a damaged record.
LoadedResult read_values(const Input& input, const Listed& listed, const Mesh& mesh);

}  // namespace feelem::unv
