// SPDX-License-Identifier: Apache-2.0
// Tables of elements as results: blocks of several element types make one result of a step.
#pragma once

#include "read/nastran/element_layouts.hpp"
#include "read/nastran/op2_ident.hpp"

#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace feelem::op2 {

/// What becomes one result: elements of several types together.
enum class Quantity : std::uint8_t {
    SolidCorner,
    SolidComplex,
    ShellCorner,
    ShellCentre,
    ShellComplex,  ///< In each element's own system.
    Axial,
    AxialComplex,
    BarEnds,
    BarPoints,
    BeamPoints,
    Ply,
    NonlinearSolid,
    NonlinearShell
};

/// The rows of one node or element in a table that is sorted by them.
struct SortedRecord {
    std::int64_t id = 0;
    std::size_t record = 0;
};

struct ElementRecords {
    Ident ident;
    std::vector<SortedRecord> records;
};

struct ElementBlockRef {
    const ElementLayout* layout = nullptr;
    std::size_t record = 0;  ///< Where the rows are: known to the one who reads them.
    /// Sorted by element: one row of each of several records, shared by all steps; else null.
    std::shared_ptr<const ElementRecords> by_element;
    std::size_t row = 0;  ///< Sorted by element: where it stands, as a rule.
};

struct ElementResult {
    StepKey step;
    Quantity quantity = Quantity::SolidCorner;
    StressKind kind;
    bool polar = false;    ///< Complex: amplitude and phase.
    int part = 0;          ///< Complex: 0 the real part or amplitude, 1 the other.
    int fibre = 0;         ///< Shells: 0 the lower one (middle), 1 the upper one (curvature).
    std::int64_t ply = 0;  ///< From 1 on; 0: not of plies.
    std::string table;
    std::vector<ElementBlockRef> blocks;
};

/// Whether an element has one value, not one a corner.
bool is_by_element(Quantity quantity);

/// Names, shape and place of the values; name and step are the caller's.
ResultInfo element_info(const ElementResult& result);

/// Collects blocks, then says which results they make.
class ElementGroups {
public:
    struct Block {
        std::string table;
        StepKey step;
        StressKind kind;
        bool polar = false;
        std::vector<std::int64_t> plies = {};  ///< That the rows have: a result each.
    };
    /// Bars that have ends become two results. The layout of `rows` is that of the first one.
    void add(const Block& block, ElementBlockRef rows);

    /// In the order of tables, steps and kinds. Shells that give their centres alone join those that give
    /// corners, where a step has both.
    std::vector<ElementResult> finish();

private:
    struct Group {
        bool polar = false;
        std::set<std::int64_t> plies;
        std::vector<ElementBlockRef> blocks;
    };
    std::map<std::tuple<std::string, StepKey, StressKind, RowShape>, Group> groups_;
};

/// The same result again in one step (another frame, another order) is known by its table.
class ResultNames {
public:
    std::string unique(const ResultInfo& info, std::string_view name);

private:
    std::map<std::pair<std::uint32_t, std::string>, int> repeats_;
    std::set<std::tuple<std::uint32_t, Complex, Layer, std::string>> names_;
};

}  // namespace feelem::op2
