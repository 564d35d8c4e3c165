// SPDX-License-Identifier: Apache-2.0
// Results at grid points and of elements from Nastran's text files (.pch, .f06): one model of what they list,
// whatever their form.
#pragma once

#include "base/input.hpp"
#include "read/nastran/element_results.hpp"
#include "read/nastran/op2_ident.hpp"
#include "read/nastran/op2_records.hpp"
#include "read/read_format.hpp"

#include "feelem/model.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
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

/// Stresses or strains of one type of element in one step.
struct PrintedElements {
    std::string table;  ///< "STRESSES"
    op2::StepKey step;
    op2::StressKind kind;
    const op2::ElementLayout* layout = nullptr;
    std::vector<PrintedRows> rows;
};

/// A row of an element, in words of eight bytes as an .op2 has them.
class WordRow {
public:
    explicit WordRow(const op2::ElementLayout& layout) : layout_(layout), bytes_(layout.row_words * kWord) {
        clear();
    }
    /// No points, and all reals missing.
    void clear() {
        for (std::size_t i = 0; i < layout_.row_words; ++i)
            set_real(i, std::numeric_limits<double>::quiet_NaN());
        if (layout_.point_words == 0) return;
        for (std::size_t i = layout_.row_words % layout_.point_words; i < layout_.row_words;
             i += layout_.point_words)
            set_integer(i, 0);
    }
    void set_integer(std::size_t i, std::int64_t value) { std::memcpy(&bytes_[i * kWord], &value, kWord); }
    void set_real(std::size_t i, double value) { std::memcpy(&bytes_[i * kWord], &value, kWord); }
    op2::Words words() const { return {bytes_, {kWord, false}}; }

private:
    static constexpr std::size_t kWord = 8;
    const op2::ElementLayout& layout_;
    std::vector<std::byte> bytes_;
};

using EachElementRow = std::function<void(std::int64_t element, const op2::Words& row)>;

/// Calls each row of a table of elements. Throws Error(BadStructure).
using ReadPrintedElements =
    void (*)(const Input& input, const PrintedElements& table, const EachElementRow& each);

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

    PrintedElements& elements_at(
        const PrintedElements& head, double value, const op2::Texts& texts
    );  ///< Its rows do not count.

    std::vector<PrintedTable> tables;
    std::vector<PrintedElements> elements;
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
    std::map<std::tuple<std::string, op2::StepKey, op2::StressKind, int>, std::size_t> element_index_;
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
    ReadPrintedElements read_elements,
    const ReadContext& context,
    Diagnostics& diagnostics
);

}  // namespace feelem::nastran
