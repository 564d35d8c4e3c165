// SPDX-License-Identifier: Apache-2.0
// The keywords of an Abaqus or CalculiX deck, its includes in place: where they are and what their lines say.
#pragma once

#include "base/input.hpp"
#include "read/include_files.hpp"

#include "feelem/diagnostics.hpp"

#include <cstddef>
#include <cstdint>
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

/// Whether a line is a comment: two stars first, or one alone.
bool is_comment(std::string_view line);
/// The next of the pieces of a line that commas part, taken off its front; commas in quotes do not part.
std::string_view take_piece(std::string_view& rest);

}  // namespace feelem::abaqus
