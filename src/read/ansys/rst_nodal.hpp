// SPDX-License-Identifier: Apache-2.0
// Results at every node: the solved unknowns and their derivatives in time.
#pragma once

#include "read/ansys/rst_steps.hpp"

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace feelem::rst {

enum class NodalRecord : std::uint8_t {
    Solution,
    Velocity,
    Acceleration,
    Reaction,
    Average
};

/// A result and the columns of its record that it is made of.
struct NodalResult {
    ResultInfo info;
    std::size_t set = 0;
    NodalRecord record = NodalRecord::Solution;
    Word at = 0;
    std::size_t width = 0;  ///< Values a node in the record.
    std::vector<std::size_t> columns;
};

/// What the sets' heads promise. `rotated`: some nodes have a coordinate system of their own.
std::vector<NodalResult> list_nodal_results(
    const ResultSets& sets, const ResultHeader& header, const Records& records, bool rotated
);

/// Stresses and strains that Ansys averaged itself (OUTRES,NAR), over all elements at a node. Where the file
/// also has those of elements, these are called "averaged_stress".
std::vector<NodalResult> list_nodal_averages(
    const ResultSets& sets, const ResultHeader& header, const Records& records
);

struct NodalValues {
    std::vector<float> values;  ///< nodes of the mesh x columns
    std::uint64_t without_node = 0;
    std::uint64_t without_number = 0;
};

/// `row_nodes`: the node behind each row of the file's solution, kNoNode where the mesh has none.
NodalValues read_nodal_values(
    const Records& records,
    const ResultSet& set,
    const NodalResult& result,
    const Mesh& mesh,
    std::span<const NodeIndex> row_nodes
);

}  // namespace feelem::rst
