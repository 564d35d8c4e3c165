// SPDX-License-Identifier: Apache-2.0
// Tables of elements as results: blocks of several element types make one result of a step.
#pragma once

#include "read/nastran/element_layouts.hpp"
#include "read/nastran/op2_ident.hpp"

#include "feelem/result.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
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
    Axial,
    BarEnds
};

struct ElementBlockRef {
    const ElementLayout* layout = nullptr;
    std::size_t record = 0;  ///< Where the rows are: known to the one who reads them.
};

struct ElementResult {
    StepKey step;
    Quantity quantity = Quantity::SolidCorner;
    StressKind kind;
    bool polar = false;  ///< Complex: amplitude and phase.
    /// Complex: 0 the real part or amplitude, 1 the other.
    int fibre = 0;  ///< Shells: 0 the lower one (middle), 1 the upper one (curvature).
    std::string table;
    std::vector<ElementBlockRef> blocks;
};

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
    };
    /// Bars that have ends become two results.
    void add(const Block& block, const ElementLayout& layout, std::size_t record);

    /// In the order of tables, steps and kinds. Shells that give their centres alone join those that give
    /// corners, where a step has both.
    std::vector<ElementResult> finish();

private:
    struct Group {
        bool polar = false;
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
