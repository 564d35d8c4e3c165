// SPDX-License-Identifier: Apache-2.0
// Rows of elements, in the words of an .op2, to values on the mesh.
#pragma once

#include "model/node_lookup.hpp"
#include "read/element_lookup.hpp"
#include "read/nastran/element_results.hpp"
#include "read/nastran/op2_records.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace feelem::op2 {

struct ElementValues {
    std::vector<float> values;
    std::vector<std::uint32_t> row_owner;  ///< Empty: a row an element of the mesh.
    std::vector<NodeIndex> row_node;
    std::uint64_t without_element = 0;  ///< Elements or corners that the mesh does not have.
    std::uint64_t without_number = 0;
    std::uint64_t other_system = 0;  ///< Solids whose tensor is not in the basic system: invariants only.
};

/// Says what of the values of `table` the mesh does not have, or is missing.
void report_values(
    const ElementValues& values, const std::string& table, const std::string& where, Diagnostics& diagnostics
);

/// Takes rows in any order; all of one result.
class ElementRowReader {
public:
    ElementRowReader(const ElementResult& result, const Mesh& mesh, const ElementLookup& lookup);

    /// `row` has as many words as the layout says; `element` is what its first word tells.
    void read(std::int64_t element, const Words& row, const ElementLayout& layout);

    /// Rows by element and node.
    ElementValues finish();

private:
    std::size_t width() const;
    template <std::size_t count>
    void put(const Words& words, const std::array<std::size_t, count>& columns, float* out);
    float* add_row(ElementIndex element, NodeIndex node);
    NodeIndex corner(std::int64_t grid, ElementIndex element);
    void read_solid(const Words& row, const ElementLayout& layout, ElementIndex element);
    Words fibre_of(const Words& fibres) const;
    void read_shell(const Words& row, const ElementLayout& layout, ElementIndex element);
    void read_centre(const Words& row, ElementIndex element);
    void read_ends(const Words& row, const ElementLayout& layout, ElementIndex element);
    void read_complex_shell(const Words& row, const ElementLayout& layout, ElementIndex element);
    void read_points(const Words& row, const ElementLayout& layout, ElementIndex element);
    void read_nonlinear_solid(const Words& row, const ElementLayout& layout, ElementIndex element);
    void sort_rows();

    const ElementResult& result_;
    const Mesh& mesh_;
    const ElementLookup& lookup_;
    NodeLookup nodes_;
    ElementValues values_;
};

}  // namespace feelem::op2
