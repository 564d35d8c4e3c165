// SPDX-License-Identifier: Apache-2.0
// Text as readers walk it: line by line, word by word, without copies.
#pragma once

#include "base/input.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace feelem {

/// The lines of [first, last) of an input.
class TextLines {
public:
    TextLines(const Input& input, std::size_t first, std::size_t last)
        : input_(&input), at_(first), start_(first), last_(std::min(last, input.size())) {}

    /// The next line without its end; empty optional at the end.
    std::optional<std::string_view> next() {
        if (at_ >= last_) return {};
        const std::string_view text = input_->text();
        start_ = at_;
        const std::size_t end = std::min(text.find('\n', at_), last_);
        at_ = std::min(end + 1, last_);
        std::string_view line = text.substr(start_, end - start_);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }
    std::size_t offset() const noexcept { return at_; }         ///< Where the next line starts.
    std::size_t line_start() const noexcept { return start_; }  ///< Of the line that next() gave.
    std::string where() const { return input_->where_line(start_); }

private:
    const Input* input_;
    std::size_t at_;
    std::size_t start_;
    std::size_t last_;
};

/// The next word of a line (words are parted by blanks, tabs, NULs), taken off its front; empty at its end.
inline std::string_view take_word(std::string_view& rest) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\0'; };
    std::size_t first = 0;
    while (first < rest.size() && is_blank(rest[first])) ++first;
    std::size_t last = first;
    while (last < rest.size() && !is_blank(rest[last])) ++last;
    const std::string_view word = rest.substr(first, last - first);
    rest.remove_prefix(last);
    return word;
}

/// The next word as an integer; empty when it is none or there is none.
inline std::optional<std::int64_t> take_integer(std::string_view& rest) {
    return parse_integer(take_word(rest));
}

}  // namespace feelem
