// SPDX-License-Identifier: Apache-2.0
// Results at grid points from Nastran's text files (.pch, .f06): one model of what they list, whatever their
// form.
#pragma once

#include "base/input.hpp"
#include "read/nastran/op2_ident.hpp"
#include "read/read_format.hpp"

#include "feelem/model.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace feelem::nastran {

/// What a table is, in docs/cli.md's names. Rotations are a result of their own.
struct PrintedKind {
    std::string_view title;     ///< How the file says it.
    std::string_view name;      ///< "displacement"; empty: not used.
    std::string_view rotation;  ///< Empty for scalars.
    std::string_view thermal;   ///< Name in heat transfer, where it is one number.
};

enum class PrintedNumbers : std::uint8_t {
    Real,
    RealImaginary,
    MagnitudePhase
};

/// A run of rows of a table. Tables are cut into pages, or (sorted by grid) into single rows.
struct PrintedRows {
    std::size_t first = 0, last = 0;  ///< Bytes of the file.
    std::int64_t node = 0;  ///< Sorted by grid: whose row it is; else 0: rows begin with their grid.
    bool packed = false;    ///< One number each for consecutive scalar points.
};

/// A row as the file has it; numbers that it leaves out are NaN.
struct PrintedRow {
    std::int64_t id = 0;
    double step_value = 0;  ///< Sorted by grid: time or frequency.
    char kind = 'G';        ///< S: a scalar point, which has one number only.
    std::size_t count = 0;
    std::array<float, 12> numbers{};
};

struct PrintedTable {
    std::string name, rotation;
    std::string solver_name;
    op2::StepKey step;
    PrintedNumbers numbers = PrintedNumbers::Real;
    std::vector<PrintedRows> rows;
};

/// Tables by name and step, in order of appearance.
class PrintedTables {
public:
    struct Head {
        const PrintedKind* kind = nullptr;
        PrintedNumbers numbers = PrintedNumbers::Real;
        bool is_scalar = false;  ///< One number a row: heat transfer.
    };
    /// The table of that head and step, made on first use. `value`: Hz, time or load factor.
    PrintedTable& at(const Head& head, const op2::StepKey& step, double value, const op2::Texts& texts);

    std::vector<PrintedTable> tables;
    struct StepEntry {
        op2::StepKey key;
        double value = 0;
        op2::Texts texts;
    };
    std::vector<StepEntry> steps;  ///< As seen; repeated ones too.
    std::string title;
    SolverInfo solver{"Nastran", {}};

private:
    std::map<std::tuple<std::string, op2::StepKey, PrintedNumbers>, std::size_t> index_;
};

/// Reads the row at `at`, moves behind it; false when there is none before `last`.
using ReadPrintedRow = bool (*)(
    std::string_view text, std::size_t& at, std::size_t last, const PrintedRows& rows, PrintedRow& row
);

/// Matched to the mesh of the context; without one, to nodes without places.
std::unique_ptr<ModelSource> open_printed(
    Input input,
    PrintedTables tables,
    ReadPrintedRow read_row,
    const ReadContext& context,
    Diagnostics& diagnostics
);

}  // namespace feelem::nastran
