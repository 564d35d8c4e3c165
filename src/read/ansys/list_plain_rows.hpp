// SPDX-License-Identifier: Apache-2.0
// Rows of lists that look as solvers print them, read where they stand; every other row is left to the
// general way.
#pragma once

#include "base/columns.hpp"
#include "base/eight_digits.hpp"
#include "base/plain_real.hpp"
#include "read/ansys/list_scan.hpp"
#include "read/ansys/list_text.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem::ansys {

/// The rows of a run, one line after the other: those that look as solvers print them at once, others by the
/// line.
class RowCursor {
public:
    RowCursor(const ListFile& file, TextRange run)
        : text_(file.input.text()), at_(run.begin), end_(run.end), line_end_(file.line_end) {}

    bool at_end() const { return at_ >= end_; }
    std::size_t at() const { return at_; }
    /// Where a plain row may be looked for; null too near to the end of the text.
    const char* plain_row(std::size_t numbers) const {
        const std::size_t reach = (numbers + 1) * static_cast<std::size_t>(kPlainReach);
        return text_.size() - at_ > reach ? text_.data() + at_ : nullptr;
    }
    const char* text_end() const { return text_.data() + text_.size(); }
    /// Whether nothing but blanks and the line's end follows; then moves to the next line. `length`: of this
    /// one.
    bool finish_row(const char* at, std::size_t& length) {
        at = behind_blanks(at, text_end());
        const char* last = at;
        if (at != text_end() && *at == '\r' && line_end_ == '\n') ++at;
        if (at == text_end() || *at != line_end_) return false;
        length = static_cast<std::size_t>(last - text_.data()) - at_;
        at_ = static_cast<std::size_t>(at - text_.data()) + 1;
        return true;
    }
    /// What is left of the run.
    std::string_view rest() const { return text_.substr(at_, end_ - at_); }
    void skip(std::size_t length) { at_ += length; }
    char line_end() const { return line_end_; }
    /// The line here; moves to the next one.
    Lines line() {
        Lines lines(text_, at_, end_, line_end_);
        lines.next();
        at_ = lines.end();
        return lines;
    }

private:
    std::string_view text_;
    std::size_t at_;
    std::size_t end_;
    char line_end_;
};

/// Blanks, an id, and something that can follow it.
inline bool scan_plain_id(const char*& at, const char* end, std::int64_t& id) {
    at = behind_blanks(at, end);
    return end - at > kPlainReach && scan_plain_integer(at, id) && id != 0 && (*at == ' ' || *at == '-');
}

/// Numbers of a row, each looked for where that of the row before made room for it, so that none waits for
/// the end of the one before. The guess decides nothing: between two numbers that are taken stand only
/// blanks.
template <class Real>
class PlainColumns {
public:
    explicit PlainColumns(std::size_t count) : rooms_(count), ends_(count) {}

    /// Blanks and a number for each of `out`, and moves behind the last.
    bool scan(const char*& at, const char* end, std::span<Real> out) {
        if (end - at <= static_cast<std::ptrdiff_t>(rooms_.empty() ? 0 : rooms_.back()) + 2 * kPlainReach)
            return false;
        if (known_ && scan_in_rooms(at, out)) return true;
        return scan_in_turn(at, end, out);
    }

private:
    static constexpr std::ptrdiff_t kBlanksOfG = 4;  ///< Where no exponent stands (Fortran's G).

    bool scan_in_rooms(const char*& at, std::span<Real> out) {
        bool found = true;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const char* from = at + rooms_[i];
            from += blanks_at(from);
            found = found & scan_plain_real(from, out[i]);  // NOLINT: no branch between two numbers
            ends_[i] = static_cast<std::uint32_t>(from - at);
        }
        if (!found) return false;
        for (std::size_t i = 1; i < out.size(); ++i) {
            const char* gap = at + ends_[i - 1];
            const char* room = at + rooms_[i];
            if (gap == room || (room - gap == kBlanksOfG && blanks_at(gap) >= kBlanksOfG)) continue;
            if (gap > room || behind_blanks(gap, room) != room) return false;
        }
        at += ends_.back();
        return true;
    }

    bool scan_in_turn(const char*& at, const char* end, std::span<Real> out) {
        const char* row = at;
        known_ = false;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const char* room = at;
            at = behind_blanks(at, end);
            if (end - at <= kPlainReach) return false;
            rooms_[i] = static_cast<std::uint32_t>(room - row);
            const char* number = at;
            if (!scan_plain_real(at, out[i])) return false;
            const bool has_exponent = std::find(number, at, 'E') != at;
            if (i + 1 < out.size() && !has_exponent)
                at += std::min<std::ptrdiff_t>(blanks_at(at), kBlanksOfG);
        }
        known_ = !out.empty() && rooms_.back() < 4096;
        return true;
    }

    /// How many of eight characters are blanks before the first that is none.
    static std::ptrdiff_t blanks_at(const char* at) {
        const std::uint64_t others = load8(at) ^ 0x2020202020202020;
        return std::countr_zero(others) / 8;
    }

    bool known_ = false;
    std::vector<std::uint32_t> rooms_, ends_;  ///< From where the first is looked for.
};

/// Rows as long as one before, with an id and reals of Fortran's G in the same columns and behind them the
/// same characters: every character is looked at once, none to find where a line or a number ends.
template <class Real>
class AlikeRows {
public:
    static constexpr std::size_t kAtOnce = 16;  ///< Rows.

    explicit AlikeRows(std::size_t reals) : reals_(reals), offsets_(kAtOnce * reals) {}

    /// Up to kAtOnce rows from the cursor on; moves behind them. 0, without moving, when the first is not
    /// like that.
    std::size_t read(RowCursor& cursor, std::span<std::int64_t, kAtOnce> ids, Real* out) {
        const std::string_view rest = cursor.rest();
        if (length_ == 0 || rest.size() < length_) return 0;
        const std::size_t most = ones_ > 0 ? 1 : std::min(kAtOnce, rest.size() / length_);
        std::size_t rows = 0;
        while (rows < most && has_same_form(rest.data() + rows * length_, ids[rows])) ++rows;
        if (rows == 0) return 0;
        if (!read_reals(rest.data(), rows, out)) {
            if (rows == 1 || !read_reals(rest.data(), 1, out)) return 0;
            ones_ = std::exchange(rows, 1);  // One of them is odd: until it is behind, each is read alone.
        }
        if (ones_ > 0) --ones_;
        cursor.skip(rows * length_);
        misses_ = 0;
        return rows;
    }

    /// A row with a number in each column, which has been read in another way: those behind it may be like
    /// it. `row`: from it on to the end of its run. False: those are still looked for that were before.
    bool learn(std::string_view row, char line_end) {
        ++misses_;
        if (misses_ > 8 && misses_ % 64 != 0) return false;
        length_ = 0;
        const std::size_t end = row.find(line_end);
        if (end == std::string_view::npos || end > kLongest || !find_columns(row.substr(0, end + 1)))
            return true;
        tail_ = row.substr(first_ + reals_ * width_, end + 1 - first_ - reals_ * width_);
        std::int64_t id = 0;
        std::vector<Real> values(reals_);
        if (tail_.front() != ' ' && tail_.front() != '\r' && tail_.front() != line_end) return true;
        for (std::size_t i = 0; i < offsets_.size(); ++i)
            offsets_[i] = static_cast<std::uint32_t>(i / reals_ * (end + 1) + i % reals_ * width_);
        if (has_same_form(row.data(), id) && read_reals(row.data(), 1, values.data())) length_ = end + 1;
        return true;
    }

    /// Of a row without its line end, as the general way counts it.
    std::size_t length() const {
        const bool has_return = tail_.size() > 1 && tail_[tail_.size() - 2] == '\r';
        return length_ - (has_return ? 2 : 1);
    }

private:
    static constexpr std::size_t kLongest = 1024;
    static constexpr std::size_t kLeast = 12, kMost = 20;  ///< Of columns_of_reals.
    static constexpr std::size_t kExponent = 4;            ///< Or four blanks.
    static constexpr std::size_t kAhead = 1024;            ///< What will be read soon, beyond the end too.

    /// But for its reals.
    bool has_same_form(const char* row, std::int64_t& id) const {
        __builtin_prefetch(row + kAhead);
        __builtin_prefetch(row + kAhead + 64);
        if (!fast_integer(row, id_end_, id) || id == 0) return false;
        std::uint64_t foreign = 0;
        for (std::size_t i = id_end_; i < first_; ++i) foreign |= static_cast<std::uint64_t>(row[i] != ' ');
        return foreign == 0 && same_characters(row + first_ + reals_ * width_, tail_.data(), tail_.size());
    }
    bool read_reals(const char* row, std::size_t rows, Real* out) const {
        return columns_of_reals(row + first_, std::span(offsets_).first(rows * reals_), width_, out);
    }

    /// Where the id ends, where columns begin and how wide they are. False: not known, or not of one width.
    bool find_columns(std::string_view line) {
        std::size_t at = behind_number(line, 0);
        id_end_ = at;
        std::size_t before = 0;  // Where the digits of the number before end.
        width_ = 0;
        for (std::size_t i = 0; i < reals_; ++i) {
            at = behind_number(line, at);
            if (i == 0 && reals_ == 1) width_ = std::min(at + kExponent - std::min(id_end_ + 1, at), kMost);
            if (i == 1) width_ = at - before;
            if (i > 1 && at - before != width_) return false;
            if (i == 0) first_ = at + kExponent;
            before = at;
            if (at < line.size() && line[at] == 'E') at = std::min(at + kExponent, line.size());
        }
        if (width_ < kLeast || width_ > kMost || first_ < width_ + id_end_ + 1) return false;
        first_ -= width_;
        return first_ >= kBeforeReals && first_ + reals_ * width_ < line.size();
    }

    static std::size_t behind_number(std::string_view line, std::size_t at) {
        at = std::min(line.find_first_not_of(' ', at), line.size());
        return std::min(line.find_first_not_of("-.0123456789", at), line.size());
    }

    std::size_t reals_;
    std::size_t length_ = 0;  ///< With the line's end; 0: no such row is known.
    std::size_t id_end_ = 0, first_ = 0, width_ = 0;
    std::string_view tail_;               ///< Of the row learned, to its end.
    unsigned misses_ = 0;                 ///< Since the last row that was alike.
    std::size_t ones_ = 0;                ///< So many rows are to be read one by one.
    std::vector<std::uint32_t> offsets_;  ///< Of the reals of kAtOnce rows behind the first.
};

}  // namespace feelem::ansys
