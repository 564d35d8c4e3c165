// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/f06_rows.hpp"

#include "base/number.hpp"
#include "read/text_lines.hpp"

#include <algorithm>
#include <limits>

namespace feelem::nastran {

std::optional<RowStart> row_start(std::string_view line) {
    if (line.empty()) return {};
    RowStart start;
    start.rest = line.substr(1);
    start.number = take_word(start.rest);
    if (start.number.empty() || (start.number[0] > '9' || start.number[0] < '-')) return {};
    const std::string_view kind = take_word(start.rest);
    if (kind.size() != 1 || kind[0] < 'A' || kind[0] > 'Z') return {};
    start.kind = kind[0];
    return start;
}

bool is_number_line(std::string_view line) {
    std::string_view rest = line;
    const std::string_view first = take_word(rest);
    return line.starts_with("          ") && !first.empty() && first.find('.') != std::string_view::npos &&
           parse_double(first).has_value();
}

bool is_page_head(std::string_view line) {
    return line.starts_with('1') && line.find("NASTRAN") != std::string_view::npos &&
           line.find("PAGE ") != std::string_view::npos;
}

bool is_spaced(std::string_view line) {
    const std::size_t at = line.find_first_not_of(' ', 1);
    if (at >= line.size() || line.size() - at < 3) return false;
    const auto is_letter = [](char c) { return c >= 'A' && c <= 'Z'; };
    return is_letter(line[at]) && line[at + 1] == ' ' && is_letter(line[at + 2]);
}

std::string spaced_title(std::string_view line) {
    std::string title;
    std::size_t letters = 0, last_size = 0, last_end = 0;
    for (std::size_t at = 0; at < line.size();) {
        at = std::min(line.find_first_not_of(" \t", at), line.size());
        const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
        if (end == at) break;
        const std::size_t size = end - at;
        const bool joins = size == 1 && last_size == 1 && at - last_end == 1;
        if (!title.empty() && !joins) title += ' ';
        title += line.substr(at, size);
        if (joins) ++letters;
        last_size = size == 1 || (size == 2 && line[end - 1] == '.') ? 1 : size;
        last_end = end;
        at = end;
    }
    constexpr std::size_t kFewLetters = 6;
    return letters >= kFewLetters ? title : std::string();
}

bool read_f06_row(
    std::string_view text, std::size_t& at, std::size_t last, const PrintedRows& rows, PrintedRow& row
) {
    const auto line_from = [&](std::size_t from, std::size_t& next) {
        const std::size_t end = std::min(text.find('\n', from), last);
        next = std::min(end + 1, last);
        return text.substr(from, end - from);
    };
    const auto add_numbers = [&](std::string_view rest) {
        for (auto word = take_word(rest); !word.empty(); word = take_word(rest)) {
            const auto value = parse_float(word);
            if (!value || row.count == row.numbers.size()) break;
            row.numbers[row.count++] = *value;
        }
    };
    while (at < last) {
        const auto start = row_start(line_from(at, at));
        if (!start) continue;
        const auto id = parse_integer(start->number);
        const auto value = parse_double(start->number);
        if (rows.node == 0 ? !id : !value) continue;
        row.id = id.value_or(0);
        row.step_value = value.value_or(0);
        row.kind = start->kind;
        row.count = 0;
        row.numbers.fill(std::numeric_limits<float>::quiet_NaN());
        add_numbers(start->rest);
        std::size_t next = at;
        if (at < last && !rows.packed && is_number_line(line_from(at, next))) {
            // The other part of a complex row: of as many numbers, at its own place.
            constexpr std::size_t kOtherPart = 6;
            row.count = kOtherPart;
            add_numbers(line_from(at, next));
            at = next;
        }
        return true;
    }
    return false;
}

}  // namespace feelem::nastran
