// SPDX-License-Identifier: Apache-2.0
// Lines of cards as pre-processors write them: where they end, and whether the next one goes on with the
// card.
#pragma once

#include "base/number.hpp"
#include "base/take_numbers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string_view>

namespace feelem::nastran {

inline constexpr std::size_t kSmallColumn = 8;
inline constexpr std::size_t kMarkColumn = 72;
inline constexpr std::size_t kLongestLine = 80;
/// Bytes that may be looked at behind a line's end.
inline constexpr std::size_t kRoomBehind = 64;

inline bool starts_card(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// A line of a card without its end.
struct CardLine {
    const char* first = nullptr;
    std::size_t length = 0;
    const char* next = nullptr;  ///< The line behind it.
};

/// Lengths that lines of meshes nearly always have: two fields or a large one, a GRID with three coordinates,
/// eight fields and a mark. In ascending order, so that a longer line is not found across a shorter one.
inline constexpr std::array<std::size_t, 3> kUsualLengths{24, 48, 73};

/// Empty near the end of the text, where columns cannot be looked at eight at a time. A line that ends at a
/// usual length is not searched: callers look at every column, and refuse a line end among them.
inline std::optional<CardLine> card_line_from(const char* first, const char* end) {
    if (static_cast<std::size_t>(end - first) < kLongestLine + kRoomBehind) return {};
    for (const std::size_t length : kUsualLengths) {
        if (first[length] == '\n' && first[length - 1] != '\r')
            return CardLine{first, length, first + length + 1};
    }
    const void* found = std::memchr(first, '\n', kLongestLine + 2);
    if (found == nullptr) return {};
    const char* last = static_cast<const char*>(found);
    CardLine line{first, static_cast<std::size_t>(last - first), last + 1};
    if (line.length > 0 && last[-1] == '\r') --line.length;
    return line;
}

/// Whether columns from `first` on are blank.
inline bool is_blank_from(const CardLine& line, std::size_t first) {
    for (std::size_t i = first; i < line.length; ++i) {
        if (line.first[i] != ' ') return false;
    }
    return true;
}

/// Whether columns could be fields or marks that are not wanted: nothing that makes the line another.
inline bool is_harmless(const CardLine& line, std::size_t first, std::size_t last = kLongestLine + 2) {
    unsigned odd = 0;  // Without branches, so that many columns are tested at once.
    for (std::size_t i = first; i < std::min(line.length, last); ++i) {
        const char c = line.first[i];
        odd |= static_cast<unsigned>(c == ',') | static_cast<unsigned>(c == '$') |
               static_cast<unsigned>(c < ' ');
    }
    return odd == 0;
}

/// How many of a field's columns the line has.
inline std::size_t width_at(const CardLine& line, std::size_t first, std::size_t width) {
    return line.length <= first ? 0 : std::min(width, line.length - first);
}

/// What tells one continuation from another: a mark without its first character.
inline std::string_view tag_of_mark(std::string_view mark) {
    mark = trim(mark);
    return mark.empty() ? mark : mark.substr(1);
}

inline bool tags_agree(std::string_view mark, std::string_view first_field) {
    if (mark.size() <= 1 || first_field.size() <= 1) return true;
    const std::string_view before = tag_of_mark(mark), after = tag_of_mark(first_field);
    return before.empty() || after.empty() || before == after;
}

inline std::string_view mark_of(const CardLine& line) {
    const std::size_t width = width_at(line, kMarkColumn, kSmallColumn);
    return width == 0 ? std::string_view{} : std::string_view(line.first + kMarkColumn, width);
}

/// Whether a fixed line goes on with the card: by a mark, or by eight blanks where fields are small.
template <class Word>
bool goes_on_fixed(const CardLine& before, const CardLine& line) {
    if (line.length <= kSmallColumn) return false;
    const char first = line.first[0];
    if (first == (sizeof(Word) == kSmallColumn ? '+' : '*'))
        return is_harmless(line, 0, kSmallColumn) && tags_agree(mark_of(before), {line.first, kSmallColumn});
    return first == ' ' && load8(line.first) == 0x2020202020202020 && !is_blank_from(line, kSmallColumn);
}

/// Behind the line's end; null where it is too far. Commas of a free card and what it does not want do not
/// matter.
inline const char* behind_line(const char* at, const char* end) {
    constexpr std::ptrdiff_t kMostColumns = 256;
    const auto room = static_cast<std::size_t>(std::min(end - at, kMostColumns));
    const void* found = std::memchr(at, '\n', room);
    if (found == nullptr || end - static_cast<const char*>(found) < kNumberRoom) return nullptr;
    return static_cast<const char*>(found) + 1;
}

/// How many characters the first field of a free line has that goes on with a card; 0: none, or a mark that
/// must be compared with another.
inline std::size_t free_continuation(const char* at) {
    if (*at == ',') return 1;
    return at[0] == '+' && at[1] == ',' ? 2 : 0;
}

inline bool ends_line(const char* at) {
    return *at == '\n' || (at[0] == '\r' && at[1] == '\n');
}

}  // namespace feelem::nastran
