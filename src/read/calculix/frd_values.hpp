// SPDX-License-Identifier: Apache-2.0
// The records of one result block -> values in node order.
#pragma once

#include "base/input.hpp"
#include "read/calculix/frd_blocks.hpp"

#include "feelem/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace feelem::frd {

/// Which of a block's stored components are wanted.
struct Columns {
    std::size_t first = 0;
    std::size_t count = 0;
};

struct Values {
    std::vector<float> values;         ///< nodes x columns; NaN: the file gives none.
    std::uint64_t without_node = 0;    ///< Records whose node the mesh does not have.
    std::uint64_t without_number = 0;  ///< NaN or infinity in the file; missing here.
};

/// Of records with equal node numbers the last counts. Throws Error on a damaged record.
Values read_values(
    const Input& input, const ResultBlock& block, Columns columns, const Mesh& mesh, bool swap
);

}  // namespace feelem::frd
