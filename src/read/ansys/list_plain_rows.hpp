// SPDX-License-Identifier: Apache-2.0
// Rows of lists that look as solvers print them, read where they stand; every other row is left to the
// general way.
#pragma once

#include "base/plain_real.hpp"
#include "read/ansys/list_scan.hpp"
#include "read/ansys/list_text.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
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

}  // namespace feelem::ansys
