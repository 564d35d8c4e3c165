// SPDX-License-Identifier: Apache-2.0
// The data lines of a keyword and the fields in them.
#pragma once

#include "read/abaqus/deck_keywords.hpp"
#include "read/text_lines.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace feelem::abaqus {

/// The data lines of a keyword, one after the other, without comments and empty lines.
class DataLines {
public:
    DataLines(const Deck& deck, const Keyword& keyword) : deck_(&deck), keyword_(&keyword) {}

    std::optional<std::string_view> next();
    /// The next line even if it is empty, where an empty line stands for values that are left out.
    std::optional<std::string_view> next_or_empty();
    /// The lines that are left of one run of them, [first, end) of a file's text, for whoever takes rows off
    /// their front by himself and then says where he came to. Empty at the end.
    struct Ahead {
        std::string_view text;
        std::size_t first = 0, end = 0;
    };
    Ahead ahead();
    void go_on_at(std::size_t offset);
    /// Of the line that next() gave.
    std::string where() const;
    /// Tells the system that the lines so far are not needed for now.
    void release() const;

private:
    /// False when there are no more lines.
    bool open_range();

    const Deck* deck_;
    const Keyword* keyword_;
    std::size_t range_ = 0;
    std::optional<TextLines> lines_;
};

/// The next field of a line (fields are parted by commas), without blanks and quotes, taken off its front.
std::string_view take_field(std::string_view& rest);

/// The next field as a number; `fallback` where it is empty. Throws Error(BadNumber).
double take_number(std::string_view& rest, double fallback, const Deck& deck, const DataLines& lines);
/// The next field as a node's or element's number, 0 where it is empty. Throws Error(BadNumber).
std::int32_t take_label(std::string_view& rest, const Deck& deck, const DataLines& lines);
/// The same, but empty when it is no number.
std::optional<std::int32_t> label_of(std::string_view field);

[[noreturn]] void throw_bad_number(
    std::string_view field, const char* expected, const Deck& deck, const DataLines& lines
);

}  // namespace feelem::abaqus
