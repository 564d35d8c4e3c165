// SPDX-License-Identifier: Apache-2.0
// Results at the corners of elements: stresses, strains, fluxes; unaveraged, in the global system.
#pragma once

#include "read/ansys/rst_mesh.hpp"
#include "read/ansys/rst_steps.hpp"

#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace feelem::rst {

/// One of the records that an element may have, and what it becomes.
struct ElementQuantity;

struct ElementResult {
    ResultInfo info;
    std::size_t set = 0;
    const ElementQuantity* quantity = nullptr;
};

/// What the sets say that they hold, for the kinds of elements that the mesh has. With shells each result has
/// layers, and the values of solids stand in each of them.
std::vector<ElementResult> list_element_results(
    const ResultSets& sets, const ResultHeader& header, const FileMesh& mesh
);

/// A number of a record as Feelem keeps it: 2^100 and what is none is missing.
struct StoredValue {
    float value = 0;
    bool is_number = true;
};
StoredValue stored_value(double value);

struct ElementValues {
    std::vector<float> values;
    std::vector<std::uint32_t> row_owner;
    std::vector<NodeIndex> row_node;
    std::uint64_t without_number = 0;
    std::uint64_t not_understood = 0;  ///< Elements whose records have another length than is known.
};

/// Elements in the order of the mesh: positions in FileMesh::elements.
std::vector<std::uint32_t> elements_in_mesh_order(const FileMesh& mesh);

/// What a set's element records are read with.
struct ElementSource {
    const Records& records;
    const ResultHeader& header;
    const FileMesh& mesh;
    std::span<const std::uint32_t> order;  ///< elements_in_mesh_order
};
ElementValues read_element_values(
    const ElementSource& source, const ResultSet& set, const ElementResult& result
);

}  // namespace feelem::rst
