// SPDX-License-Identifier: Apache-2.0
// Tables with a row for each grid or scalar point: displacements, temperatures, forces.
#pragma once

#include "read/nastran/element_results.hpp"
#include "read/nastran/op2_ident.hpp"
#include "read/nastran/op2_records.hpp"

#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::op2 {

/// What a table code means, in docs/cli.md's names. Six numbers a row: translations, then rotations. Grid
/// point stresses have eight: the tensor, mean pressure and the equivalent stress.
struct NodalKind {
    std::string_view name;
    std::string_view rotation;
    bool is_stress = false;
};
/// Nothing when the table lists no grid points that Feelem knows.
std::optional<NodalKind> nodal_kind(const Ident& ident);

/// One step's rows: a whole record when the table is sorted by step, else one row of each of several records.
struct NodalBlock {
    Ident ident;
    StepKey step;
    std::string table;
    std::size_t record = 0;                              ///< Sorted by step: the data.
    std::shared_ptr<std::vector<SortedRecord>> by_node;  ///< Sorted by node, shared by all steps; else null.
    std::size_t row = 0;                                 ///< Sorted by node: where it stands, as a rule.

    /// Tables whose name starts with B are in the basic system, all others in the grids' own.
    bool is_basic() const { return table.starts_with('B'); }
    bool is_complex() const;
    std::size_t row_words() const { return ident.row_words; }
    /// Word of a row's first number.
    std::size_t first_number() const;
};

struct NodalValues {
    std::vector<float> values;  ///< Rows of the mesh x columns.
    std::uint64_t rows = 0;
    std::uint64_t without_node = 0;
    std::uint64_t without_number = 0;
};
/// `columns` numbers of each row from number `first` on (0 is T1). Throws Error(BadStructure).
NodalValues read_nodal(
    const Input& input,
    const Layout& layout,
    const NodalBlock& block,
    const Mesh& mesh,
    std::size_t first,
    std::size_t columns
);

/// Adds the ids that the block lists to `ids`.
void collect_ids(const Input& input, const Layout& layout, const NodalBlock& block, std::vector<NodeId>& ids);

/// How many rows the block has.
std::uint64_t row_count(const Layout& layout, const NodalBlock& block);

}  // namespace feelem::op2
