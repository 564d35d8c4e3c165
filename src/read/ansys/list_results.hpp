// SPDX-License-Identifier: Apache-2.0
// Lists and exports of values -> results: which there are, and their values on demand.
#pragma once

#include "read/ansys/list_columns.hpp"
#include "read/ansys/mechanical_export.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace feelem::ansys {

/// Everything the inputs hold.
struct ListModel {
    std::vector<ListFile> files;
    std::vector<ExportFile> exports;
    std::vector<std::uint32_t> file_inputs;  ///< Index among the inputs, per file and export.
    std::vector<std::uint32_t> export_inputs;
};

/// Where values stand: a list of a file, or a body of an export.
struct Table {
    bool is_export = false;
    std::size_t file = 0;
    std::size_t list = 0;  ///< Or body.
    std::optional<PartIndex> part;
};

struct ListedResult {
    ResultInfo info;
    std::vector<Table> tables;
    std::vector<std::size_t> columns;  ///< One a component.
    ListKind kind = ListKind::NodalValues;
    std::string where;  ///< File, for messages.
    /// Lists of derived components of the same result (PRNSOL,S,PRIN beside PRNSOL,S): theirs follow.
    std::vector<ListedResult> further;
};

struct ListedResults {
    std::vector<Step> steps;
    std::vector<ListedResult> results;
};

/// `has_angles`: a node list gives the rotations of nodal systems, be they zero.
ListedResults list_results(
    const ListModel& model, const Mesh& mesh, bool has_angles, Diagnostics& diagnostics
);

/// The part that stands for a body of an export when no elements tell: "stress.txt body 2".
std::string body_name(const ExportFile& file, std::size_t body);

/// The solver's own invariants join the tensor they were made of, so that none are computed beside them.
/// Steps that no result is left in go.
void join_derived(ListedResults& out);

/// Element id -> index, for lists of elements, which mostly ascend.
class ElementFinder {
public:
    explicit ElementFinder(const Mesh& mesh);
    ElementIndex operator()(std::int64_t id);

private:
    std::vector<std::pair<std::int64_t, std::uint32_t>> indices_;
    std::size_t last_ = 0;  ///< Which was found.
};

/// How many rows each node of an element has in PRESOL: 1, 2 (top, bottom) or 3 (and middle), when the rows
/// repeat the same nodes in the same order.
std::size_t count_layers(std::span<const std::int64_t> nodes);

/// The values. Reports what could not be used when diagnostics are given.
Result load_values(
    const ListModel& model, const ListedResult& listed, const Mesh& mesh, Diagnostics* diagnostics
);

/// Calls use for every row of a table, or use_many, where there is one, for plain rows.
void for_each_table_row(
    const ListModel& model,
    const Table& table,
    Diagnostics* diagnostics,
    const std::function<void(const ValueRow&)>& use,
    const std::function<void(const ValueRows&)>& use_many = nullptr
);

}  // namespace feelem::ansys
