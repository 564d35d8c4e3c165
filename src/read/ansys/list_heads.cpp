// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/list_heads.hpp"

#include "base/letter_case.hpp"
#include "read/ansys/list_text.hpp"

#include <algorithm>
#include <limits>

namespace feelem::ansys {
namespace {

constexpr std::size_t kLongestHeadLine = 240;

}  // namespace

std::string capitals_of(std::string_view line) {
    return upper_case(trim(line.substr(0, kLongestHeadLine)));
}

std::optional<double> number_after(std::string_view text, std::string_view key) {
    const std::size_t at = text.find(key);
    if (at == std::string_view::npos) return std::nullopt;
    Cursor cursor(text.substr(at + key.size()));
    double value = 0;
    return scan_real(cursor, value) ? std::optional(value) : std::nullopt;
}

int whole_after(std::string_view text, std::string_view key, int otherwise) {
    const std::size_t at = text.find(key);
    if (at == std::string_view::npos) return otherwise;
    Cursor cursor(text.substr(at + key.size()));
    std::int64_t value = 0;
    const bool found = scan_unsigned(cursor, value) && value <= std::numeric_limits<std::int32_t>::max();
    return found ? static_cast<int>(value) : otherwise;
}

RowGuess guess_row(std::string_view line) {
    Cursor cursor(line);
    std::int64_t id = 0;
    if (!scan_unsigned(cursor, id) || id == 0 || (cursor.at != cursor.end && *cursor.at == '.')) return {};
    RowGuess guess;
    std::size_t two_decimals = 0;
    while (!cursor.at_end()) {
        const char* from = cursor.at;
        double value = 0;
        if (!scan_real(cursor, value)) return {};
        const std::string_view text(from, static_cast<std::size_t>(cursor.at - from));
        const std::size_t point = text.find('.');
        if (point != std::string_view::npos) guess.whole = false;
        two_decimals = text.size() - std::min(point, text.size()) == 3 ? two_decimals + 1 : 0;
        ++guess.numbers;
    }
    guess.angles = two_decimals == 3;
    return guess;
}

bool has_list_title(std::string_view head) {
    Lines lines(head, 0, head.size(), line_end_of(head));
    while (lines.next()) {
        const std::string line = capitals_of(lines.line());
        Cursor cursor{std::string_view(line)};
        const std::string_view first = next_word(cursor);
        const std::string_view second = next_word(cursor);
        if (first == "LIST" &&
            (contains(line, " ELEMENT") || contains(line, " NODES") || contains(line, " MATERIALS")))
            return true;
        if (first == "PRINT" && (contains(line, "PER NODE") || contains(line, "PER ELEMENT"))) return true;
        if (first.starts_with("**") && contains(line, "POST1 ") && contains(line, " LISTING")) return true;
        if (first == "NODE" && (second == "X" || second == "UX" || second == "TEMP" || second == "SX"))
            return true;
        if ((first == "ELEM" || first == "EL") && second == "MAT") return true;
        if (first == "ELEMENT" && second == "TYPE" && contains(line, " IS ")) return true;
    }
    return false;
}

bool has_list_rows(std::string_view head) {
    constexpr int kEnough = 3;
    Lines lines(head, 0, head.size(), line_end_of(head));
    RowGuess first;
    int rows = 0;
    while (rows < kEnough && lines.next()) {
        if (trim(lines.line()).empty()) continue;
        const RowGuess guess = guess_row(lines.line());
        const bool usable = guess.whole ? guess.numbers >= 7 : guess.numbers >= 1 && guess.numbers <= 8;
        // A line that the head cuts says nothing.
        if (!usable) return rows > 0 && !lines.ended();
        if (rows > 0 && (guess.whole != first.whole || (!guess.whole && guess.numbers != first.numbers))) {
            return false;
        }
        first = guess;
        ++rows;
    }
    return rows > 0;
}

}  // namespace feelem::ansys
