// SPDX-License-Identifier: Apache-2.0
// The keywords of an Abaqus or CalculiX deck, its includes in place: where they are and what their lines say.
#pragma once

#include "base/input.hpp"
#include "read/include_files.hpp"
#include "read/text_lines.hpp"

#include "feelem/diagnostics.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::abaqus {

/// Labels are compared without case; "Part 1" in quotes is Part 1.
std::string folded(std::string_view label);
/// Without quotes and blanks at the ends, as written.
std::string unquoted(std::string_view label);

/// A run of lines of one of the files.
struct LineRange {
    std::uint32_t file = 0;
    std::size_t begin = 0, end = 0;
};

struct Parameter {
    std::string key;    ///< Upper case, without blanks.
    std::string value;  ///< As written, without quotes.
};

struct Keyword {
    std::string name;  ///< Upper case, without star and blanks: "NODEPRINT", "ENDPART".
    std::vector<Parameter> parameters;
    std::uint32_t file = 0;
    std::size_t offset = 0;       ///< Of its line.
    std::vector<LineRange> data;  ///< Data lines; several where they come from included files.

    bool has(std::string_view key) const;
    /// Empty when it is not there.
    std::string value(std::string_view key) const;
};

struct Deck {
    std::vector<Input> files;
    std::vector<Keyword> keywords;  ///< In order, those that say something about the mesh.
    std::string title;
    bool has_parameters = false;  ///< *PARAMETER: numbers may stand as <name>.

    std::string where(const Keyword& keyword) const;
};

/// Of several roots one deck, in order. Includes that cannot be found are reported (UnknownBlock).
Deck scan_decks(std::span<const Input> roots, IncludeFiles* includes, Diagnostics& diagnostics);

/// The names of the files that the decks include, without opening them.
std::vector<std::string> included_names(const Input& input);

/// Whether the head looks like a deck: a known keyword comes first.
bool starts_like_deck(std::string_view head);

/// The data lines of a keyword, one after the other, without comments and empty lines.
class DataLines {
public:
    DataLines(const Deck& deck, const Keyword& keyword) : deck_(&deck), keyword_(&keyword) {}

    std::optional<std::string_view> next();
    /// The next line even if it is empty, where an empty line stands for values that are left out.
    std::optional<std::string_view> next_or_empty();
    /// The lines that are left of one run of them, the file's text behind them, for whoever takes rows off
    /// their front by himself and then says where he came to. Empty at the end.
    std::string_view ahead();
    void go_on_at(const char* at);
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
