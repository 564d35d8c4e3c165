// SPDX-License-Identifier: Apache-2.0
// One card of bulk data: its name and its fields, whatever form its lines have (small, large, free, mixed).
#pragma once

#include "base/input.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>
#include <vector>

namespace feelem::nastran {

/// The lines of a file that say something: without comments ($), line ends and blank lines.
class BulkLines {
public:
    explicit BulkLines(std::string_view text, std::size_t first = 0) : text_(text), next_(first) {}

    /// False at the end of the file.
    bool advance();
    std::string_view line() const noexcept { return line_; }
    std::size_t offset() const noexcept { return start_; }  ///< Of the line.
    std::size_t next_offset() const noexcept { return next_; }
    void go_to(std::size_t offset) noexcept { next_ = offset; }

    /// Comments that name properties and sets are appended here, when set.
    std::vector<std::string_view>* names = nullptr;

private:
    std::string_view text_;
    std::string_view line_;
    std::size_t start_ = 0;
    std::size_t next_;
};

/// Whether a line belongs to the card before it: its first field is blank or starts with + or *.
bool is_continuation(std::string_view line);

/// The name of a card as its line has it.
struct CardHead {
    std::array<char, 8> letters{};  ///< Upper case.
    std::uint8_t length = 0;
    bool large = false;      ///< A star: fields of 16 columns.
    std::size_t offset = 0;  ///< Of the card's first line.

    std::string_view name() const noexcept { return {letters.data(), length}; }
};
CardHead card_head(std::string_view line, std::size_t offset);

/// Fields of a card; views into the file and into itself, until the next read().
class BulkCard {
public:
    /// Reads the card that starts at `head.offset`.
    void read(std::string_view text, const CardHead& head);

    /// Without blanks round it; empty when blank or absent. 0 is the name.
    std::string_view field(std::size_t i) const noexcept {
        return i < fields_.size() ? fields_[i] : std::string_view{};
    }
    /// One beyond the last field that is not blank.
    std::size_t size() const noexcept { return fields_.size(); }
    bool is_blank(std::size_t i) const noexcept { return field(i).empty(); }
    /// Whether a line ended with another mark than the next began with: the deck may be out of order.
    bool marks_differ() const noexcept { return marks_differ_; }
    std::optional<std::int64_t> integer(std::size_t i) const;
    std::optional<double> real(std::size_t i) const;

private:
    void add_line(std::string_view line);
    void add_fixed(std::string_view line);
    void add_free(std::string_view line);
    void set(std::size_t i, std::string_view field);

    std::vector<std::string_view> fields_;
    std::deque<std::array<char, 80>> spaced_;  ///< Lines whose tabs were turned into blanks.
    std::size_t spaced_used_ = 0;
    std::size_t base_ = 1;  ///< Field that the next line starts with.
    bool large_ = false;
    std::string_view mark_;  ///< With which the last line ended.
    bool marks_differ_ = false;
};

}  // namespace feelem::nastran
