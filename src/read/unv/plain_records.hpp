// SPDX-License-Identifier: Apache-2.0
// Must: take the records of nodes and elements that programs write off a text, fast, or refuse them.
// Assumes: nothing; what is refused the caller reads word by word.
// Algorithm: numbers are taken as they come (base/take_numbers.hpp) between blanks; signs of whole numbers,
// tabs, empty lines and lines with more or fewer numbers are refused. Data: none.
#pragma once

#include "base/plain_real.hpp"
#include "base/take_numbers.hpp"

#include "feelem/mesh.hpp"

#include <cstdint>
#include <span>

namespace feelem::unv {

/// A position in a text and its end.
class PlainText {
public:
    PlainText(const char* at, const char* end) : at_(at), end_(end) {}

    const char* at() const noexcept { return at_; }
    bool take(std::int64_t& out) { return has_room() && take_digits(at_, out) && is_parted(); }
    bool take(double& out) { return has_room() && take_real(at_, out) && is_parted(); }
    /// Nothing but blanks up to the end of the line; then the next.
    bool next_line() {
        at_ = behind_blanks(at_, end_);
        if (at_ != end_ && *at_ == '\r') ++at_;
        return at_ != end_ && *at_++ == '\n';
    }

private:
    bool has_room() {
        at_ = behind_blanks(at_, end_);
        return end_ - at_ >= kNumberRoom;
    }
    bool is_parted() const { return *at_ == ' ' || *at_ == '\n' || *at_ == '\r'; }

    const char* at_;
    const char* end_;
};

/// Label, two coordinate systems, colour; on the next line, or the same, three coordinates.
inline bool take_plain_node(PlainText& text, bool one_line, std::span<std::int64_t> head, Point3& place) {
    PlainText p = text;
    for (std::int64_t& number : head) {
        if (!p.take(number)) return false;
    }
    if (head[0] == 0 || (!one_line && !p.next_line())) return false;
    for (double& x : place) {
        if (!p.take(x)) return false;
    }
    if (!p.next_line()) return false;
    text = p;
    return true;
}

/// Whole numbers, eight a line, and the end of the last line.
inline bool take_plain_numbers(PlainText& text, std::span<std::int64_t> numbers) {
    constexpr std::size_t kMostALine = 8;
    PlainText p = text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0 && i % kMostALine == 0 && !p.next_line()) return false;
        if (!p.take(numbers[i])) return false;
    }
    if (!p.next_line()) return false;
    text = p;
    return true;
}

}  // namespace feelem::unv
