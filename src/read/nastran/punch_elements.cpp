// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/punch_elements.hpp"

#include "base/number.hpp"
#include "read/text_lines.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace feelem::nastran {
namespace {

constexpr std::size_t kLineWords = 3;

/// The line at `at` without its number; moves behind it.
std::string_view punch_line(std::string_view text, std::size_t& at, std::size_t last) {
    const std::size_t end = std::min(text.find('\n', at), last);
    const std::string_view line = text.substr(at, std::min(end - at, kPunchData));
    at = std::min(end + 1, last);
    return line;
}

bool goes_on(std::string_view text, std::size_t at, std::size_t last) {
    return at < last && text.substr(at, 6) == "-CONT-";
}

/// Puts the words of a line into the row, from word `first` on.
void put_line(std::string_view line, std::size_t first, std::size_t words, WordRow& row) {
    for (std::size_t i = 0; i < kLineWords && first + i < words; ++i) {
        const std::size_t column = (i + 1) * kPunchField;
        const std::string_view field =
            column < line.size() ? trim(line.substr(column, kPunchField)) : std::string_view{};
        if (const auto integer = parse_integer(field)) {
            row.set_integer(first + i, *integer);
        } else if (const auto value = parse_float(field)) {
            row.set_real(first + i, *value);
        }
    }
}

std::size_t lines_of(const op2::ElementLayout& layout) {
    return (layout.row_words - 1 + kLineWords - 1) / kLineWords;
}

}  // namespace

void read_element_type(std::string_view line, PunchedElements& elements) {
    std::string_view rest = line.substr(std::min(line.find('='), line.size() - 1) + 1);
    elements.type = take_integer(rest).value_or(0);
    elements.words = trim(rest);
}

std::optional<op2::StressKind> punched_kind(
    const PunchedElements& elements, const op2::ElementLayout& layout
) {
    const auto says = [&](const char* word) { return elements.words.find(word) != std::string_view::npos; };
    op2::StressKind kind;
    kind.strain = elements.strain;
    kind.von_mises = says("VONM");
    // Without a word it may be either.
    kind.unnamed = !kind.von_mises && !says("MAX") && !says("SHEAR") && !says("OCT");
    const bool is_shell =
        layout.shape == op2::RowShape::ShellCentre || layout.shape == op2::RowShape::ShellCorner;
    if (is_shell && elements.strain) {
        kind.curvature = says("CUR");
        if (!kind.curvature && !says("FIBER")) return {};
    }
    return kind;
}

const op2::ElementLayout* punched_layout(
    std::string_view text, std::size_t at, std::size_t last, std::int64_t type
) {
    std::size_t lines = 1;
    for (punch_line(text, at, last); goes_on(text, at, last); punch_line(text, at, last)) ++lines;
    for (std::size_t words = kLineWords * (lines - 1) + 2; words <= kLineWords * lines + 1; ++words) {
        const op2::ElementLayout* layout = op2::find_layout(type, words, false);
        const bool is_used = layout != nullptr && layout->shape != op2::RowShape::Ply &&
                             layout->shape != op2::RowShape::NonlinearSolid &&
                             layout->shape != op2::RowShape::NonlinearShell;
        if (is_used) return layout;
    }
    return nullptr;
}

void read_punch_elements(const Input& input, const PrintedElements& table, const EachElementRow& each) {
    const std::string_view text = input.text();
    const std::size_t words = table.layout->row_words;
    WordRow row(*table.layout);
    for (const PrintedRows& rows : table.rows) {
        for (std::size_t at = rows.first; at < rows.last;) {
            const std::size_t start = at;
            std::string_view line = punch_line(text, at, rows.last);
            const auto element = parse_integer(trim(line.substr(0, std::min(kPunchField - 1, line.size()))));
            row.clear();
            put_line(line, 1, words, row);
            std::size_t lines = 1;
            for (; goes_on(text, at, rows.last); ++lines)
                put_line(punch_line(text, at, rows.last), 1 + lines * kLineWords, words, row);
            if (trim(line).empty()) continue;
            if (!element || lines != lines_of(*table.layout)) {
                throw Error(
                    Code::BadStructure,
                    input.where_line(start),
                    fmt::format(
                        "this row of {} has {} lines, where an element of type {} needs its number and {} "
                        "lines",
                        table.table,
                        lines,
                        table.layout->type,
                        lines_of(*table.layout)
                    )
                );
            }
            each(*element, row.words());
        }
    }
}

}  // namespace feelem::nastran
