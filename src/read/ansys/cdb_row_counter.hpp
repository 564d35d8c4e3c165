// SPDX-License-Identifier: Apache-2.0
// Where the rows of a block begin, before they are read.
#pragma once

#include "read/ansys/cdb_deck.hpp"
#include "read/ansys/list_text.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace feelem::ansys::cdb {

/// Tells lines that begin a row from those that go on with one: an element may need two.
class RowCounter {
public:
    RowCounter(const RowFormat& format, std::optional<ElementForm> form) : format_(format), form_(form) {}

    bool begins(std::string_view line) {
        if (!form_) return true;
        if (further_ > 0) {
            --further_;
            return false;
        }
        if (*form_ == ElementForm::Solid) further_ = further_lines(line);
        return true;
    }

private:
    /// By the number of nodes in the ninth column, of which eleven columns less than all stand on this line.
    std::size_t further_lines(std::string_view line) const {
        constexpr std::size_t kAttributes = 11;
        constexpr unsigned kMostNodes = 64;
        const std::size_t end = 9 * format_.id_width;
        if (format_.integers <= kAttributes || format_.id_width < 2 || line.size() < end) return 0;
        const auto digit = [&](std::size_t at) {
            return is_digit(line[at]) ? static_cast<unsigned>(line[at] - '0') : 0U;
        };
        const unsigned nodes = 10 * digit(end - 2) + digit(end - 1);
        const std::size_t on_first = format_.integers - kAttributes;
        if (nodes <= on_first || nodes > kMostNodes) return 0;
        return (nodes - on_first + format_.integers - 1) / format_.integers;
    }

    const RowFormat& format_;
    std::optional<ElementForm> form_;
    std::size_t further_ = 0;
};

/// Whether this line ends a block of such rows. `ranges`: negative numbers are no end.
inline bool ends_block(std::string_view line, const RowFormat& format, bool ranges) {
    if (starts_row(line, format.id_width)) return false;
    const char mark = first_mark(line);
    return !(is_digit(mark) || mark == '+' || mark == '\0' || (ranges && mark == '-'));
}

/// Bytes from the first row to the next one; 0 when there is none.
inline std::size_t first_row_size(
    std::string_view text, const BlockRows& rows, std::optional<ElementForm> form
) {
    RowCounter counter(rows.format, form);
    Lines lines(text, rows.begin, text.size(), rows.line_end);
    if (!lines.next()) return 0;
    counter.begins(lines.line());
    while (lines.next()) {
        if (counter.begins(lines.line())) return lines.begin() - rows.begin;
    }
    return 0;
}

}  // namespace feelem::ansys::cdb
