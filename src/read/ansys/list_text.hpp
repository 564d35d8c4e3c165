// SPDX-License-Identifier: Apache-2.0
// Lines and numbers of Ansys' text lists, read without copying and without trusting blanks between columns.
#pragma once

#include "base/input.hpp"
#include "base/number.hpp"

#include <fast_float/fast_float.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <system_error>

namespace feelem::ansys {

/// What ends a line: '\n' (a '\r' before it is a blank), or '\r' in files that have no '\n' at all.
inline char line_end_of(std::string_view text) {
    return text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos ? '\r'
                                                                                                  : '\n';
}

/// The lines of [begin, end) of a text.
class Lines {
public:
    Lines(std::string_view text, std::size_t begin, std::size_t end, char line_end)
        : text_(text), next_(begin), end_(end), line_end_(line_end) {}

    /// False after the last line.
    bool next() {
        if (next_ >= end_) return false;
        begin_ = next_;
        const char* from = text_.data() + begin_;
        const void* found = std::memchr(from, line_end_, end_ - begin_);
        const std::size_t length = found == nullptr
                                       ? end_ - begin_
                                       : static_cast<std::size_t>(static_cast<const char*>(found) - from);
        line_ = {from, length};
        next_ = begin_ + length + 1;
        return true;
    }
    /// What stands before that is not looked at: the next line begins there.
    void go_to(std::size_t offset) { next_ = offset; }
    std::string_view line() const { return line_; }                  ///< Without its end.
    std::size_t begin() const { return begin_; }                     ///< Offset in the text.
    std::size_t end() const { return next_ < end_ ? next_ : end_; }  ///< Offset behind its end.
    /// False for a last line that the file does not end: it may have been cut.
    bool ended() const { return begin_ + line_.size() < text_.size(); }

private:
    std::string_view text_;
    std::string_view line_;
    std::size_t begin_ = 0;
    std::size_t next_;
    std::size_t end_;
    char line_end_;
};

/// Lets the system take back the pages of a mapped file behind a reading position.
class ReleaseBehind {
public:
    explicit ReleaseBehind(const Input& input) : input_(input) {}
    void at(std::size_t offset) {
        constexpr std::size_t kStride = 4U << 20U;
        if (offset < released_ + kStride) return;
        input_.release(released_, offset);
        released_ = offset;
    }

private:
    const Input& input_;
    std::size_t released_ = 0;
};

inline bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
/// Commas too: /PAGE can make lists comma-separated.
inline bool is_gap(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == '\0';
}

/// A position in a line.
struct Cursor {
    const char* at;
    const char* end;

    explicit Cursor(std::string_view text) : at(text.data()), end(text.data() + text.size()) {}
    void skip_gaps() {
        while (at != end && is_gap(*at)) ++at;
    }
    bool at_end() {
        skip_gaps();
        return at == end;
    }
};

/// First character that is not a gap, or 0.
inline char first_mark(std::string_view line) {
    for (const char c : line) {
        if (!is_gap(c)) return c;
    }
    return '\0';
}

/// Skips gaps and reads digits (at most 18). Stops behind the last digit.
inline bool scan_unsigned(Cursor& cursor, std::int64_t& value) {
    cursor.skip_gaps();
    const char* at = cursor.at;
    std::uint64_t number = 0;  // Wraps on endless digits, which are refused below.
    while (at != cursor.end && is_digit(*at)) number = number * 10 + static_cast<std::uint64_t>(*at++ - '0');
    const auto digits = at - cursor.at;
    if (digits == 0 || digits > 18) return false;
    value = static_cast<std::int64_t>(number);
    cursor.at = at;
    return true;
}

/// Fortran's exponents: D letters, and none at all before three digits (0.1234-101). A second number that
/// touches the first has a point in its digits, an exponent has not.
inline const char* fortran_exponent_end(const char* at, const char* end) {
    const bool letter = *at == 'D' || *at == 'd';
    const char* digits = letter ? at + 1 : at;
    if (digits != end && (*digits == '+' || *digits == '-')) ++digits;
    const char* last = digits;
    while (last != end && is_digit(*last)) ++last;
    const bool touches = last != end && *last == '.';
    if (touches || last == digits || (!letter && last - digits != 3)) return at;
    return last;
}

/// Skips gaps and reads one number, each rounded once, stopping where it ends even when the next one touches
/// it (-0.24713E+007-0.73354E+006). False, without moving, when no number stands there.
template <class Real>
bool scan_real(Cursor& cursor, Real& value) {
    cursor.skip_gaps();
    const char* from = cursor.at;
    if (from != cursor.end && *from == '+') ++from;
    const char* digit = from;
    if (digit != cursor.end && *digit == '-') ++digit;
    // Words (NaN, Infinity) are not numbers here.
    if (digit == cursor.end || !(is_digit(*digit) || *digit == '.')) return false;
    const auto [stop, error] = fast_float::from_chars(from, cursor.end, value);
    if (error != std::errc{} && error != std::errc::result_out_of_range) return false;
    if (stop != cursor.end && (*stop == 'D' || *stop == 'd' || *stop == '-' || *stop == '+')) {
        const char* last = fortran_exponent_end(stop, cursor.end);
        const std::string_view plain(from, static_cast<std::size_t>(stop - from));
        if (last != stop && plain.find_first_of("eE") == std::string_view::npos) {
            const std::string_view whole(from, static_cast<std::size_t>(last - from));
            const auto parsed = [&] {
                if constexpr (sizeof(Real) == sizeof(float))
                    return parse_float(whole);
                else
                    return parse_double(whole);
            }();
            if (!parsed) return false;
            value = *parsed;
            cursor.at = last;
            return true;
        }
    }
    cursor.at = stop;
    return true;
}

/// The next word between gaps; empty at the end.
inline std::string_view next_word(Cursor& cursor) {
    cursor.skip_gaps();
    const char* from = cursor.at;
    while (cursor.at != cursor.end && !is_gap(*cursor.at)) ++cursor.at;
    return {from, static_cast<std::size_t>(cursor.at - from)};
}

}  // namespace feelem::ansys
