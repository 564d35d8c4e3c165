// SPDX-License-Identifier: Apache-2.0
// The tables that *NODE PRINT and *EL PRINT leave in Abaqus' .dat: where they are and what their heads say.
#pragma once

#include "base/input.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::printed {

/// What the rows of a table are of.
enum class Place : std::uint8_t {
    Node,
    Averaged,      ///< Values of elements, averaged at nodes by Abaqus.
    ElementNodes,  ///< Of an element at its nodes.
    Element,       ///< Centroid, or the element as a whole.
    Point,         ///< Integration points.
};

/// "MAXIMUM  1.4706E-03  0.000" and "AT NODE  104  101" below it. Numbers stay as they are printed: their
/// digits say how far they can be trusted.
struct Summary {
    std::vector<std::string> values;
    std::vector<std::int64_t> ids;
};

/// A row is: id, point or node, section point (as the head says), perhaps marks of footnotes, values.
struct PrintedTable {
    std::string title;  ///< "FOR NODES BELONGING TO NODE SET TOP"
    Place place = Place::Node;
    std::size_t keys = 1;         ///< Whole numbers that a row begins with.
    std::size_t point_key = 0;    ///< Which of them is the point or node of an element; 0: none.
    std::size_t section_key = 0;  ///< Which is the section point; 0: none.
    std::vector<std::string> columns;
    std::set<std::int64_t> sections;  ///< Section points that occur.
    std::uint32_t step = 0;           ///< Into PrintedFile::steps.
    std::size_t begin = 0, end = 0;   ///< Of the rows.
    std::size_t rows = 0;
    Summary largest, smallest;
    bool has_marks = false;  ///< OR: an *ORIENTATION gives the directions.
};

struct PrintedFile {
    std::vector<Step> steps;
    std::vector<PrintedTable> tables;
    SolverInfo solver;
};

/// Goes once through the file. What is not read (contact, rebars, complex values) is reported by its title.
PrintedFile scan_printed(const Input& input, Diagnostics& diagnostics);

/// Whether the head is that of a .dat of Abaqus.
bool is_printed_by_abaqus(std::string_view head);

std::vector<std::string_view> words_of(std::string_view line);

/// The parts of a row; false when the line is none of this table.
struct PrintedRow {
    std::vector<std::int64_t> keys;
    std::vector<std::string_view> values;
    bool has_mark = false;
};
bool read_printed_row(const PrintedTable& table, std::string_view line, PrintedRow& row);

}  // namespace feelem::printed
