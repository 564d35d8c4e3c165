// SPDX-License-Identifier: Apache-2.0
// Rows of a list, one after the other: nodes, elements, values.
#pragma once

#include "read/ansys/list_scan.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace feelem::ansys {

struct NodeRow {
    std::int64_t id = 0;
    Point3 position{};
    NodalAngles angles{};
};

struct ElementRowIds {
    std::int64_t id = 0;
    std::int64_t material = 0;
    std::int64_t type = 0;
    std::span<const std::int64_t> nodes;  ///< As listed: 0 for a left-out mid-side node.
    std::size_t offset = 0;
};

/// Elements that were read while their list was looked for.
struct TakenElements {
    const RowRun* run = nullptr;
    std::span<const ElementId> ids;
    std::span<const NodeIndex> nodes;  ///< Their ids, as many of each element.

    std::size_t offset(std::size_t i) const {
        return run->begin + i * ((run->end - run->begin) / run->taken);
    }
};

struct ValueRow {
    std::int64_t id = 0;            ///< Node, or element in ListKind::ElementValues.
    std::int64_t element = 0;       ///< ListKind::ElementNodalValues,
    std::string_view element_type;  ///< with the name of its type: "SOLID187".
    std::span<const float> values;  ///< One a column; NaN = missing.
    bool has_bad_value = false;     ///< ***, NaN or too large.
    std::size_t offset = 0;
};

/// Rows one after the other, with a number in every column.
struct ValueRows {
    std::span<const std::int64_t> ids;
    std::span<const float> values;  ///< As many of each row.
};

// Each throws Error(BadNumber) for a row that cannot be understood. A last row that the file does not end and
// that is shorter than the others is left out (TruncatedInput); lines that are no rows are counted
// (UnknownBlock). Without diagnostics nothing is reported: for a second pass. Runs that were taken go to
// use_taken where there is one, plain rows of values to use_many.
void for_each_node(
    const ListFile& file,
    const List& list,
    Diagnostics* diagnostics,
    const std::function<void(const NodeRow&)>& use,
    const std::function<void(std::size_t first, std::size_t count)>& use_taken
);
void for_each_element(
    const ListFile& file,
    const List& list,
    Diagnostics* diagnostics,
    const std::function<void(const ElementRowIds&)>& use,
    const std::function<void(const TakenElements&)>& use_taken = nullptr
);
/// One after the other.
void for_each_taken(const TakenElements& taken, const std::function<void(const ElementRowIds&)>& use);
void for_each_value_row(
    const ListFile& file,
    const List& list,
    Diagnostics* diagnostics,
    const std::function<void(const ValueRow&)>& use,
    const std::function<void(const ValueRows&)>& use_many = nullptr
);

/// Significant digits of the longest number in the list's first rows.
int coordinate_digits(const ListFile& file, const List& list);

}  // namespace feelem::ansys
