// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/bulk_card.hpp"

#include "base/letter_case.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cstring>

namespace feelem::nastran {
namespace {

constexpr std::size_t kColumn = 8;     ///< Width of a small field.
constexpr std::size_t kLastData = 72;  ///< Columns behind are for the mark of the continuation.

/// Comments by which pre-processors keep names.
bool names_something(std::string_view comment) {
    if (comment.size() < 8) return false;
    switch (comment[1]) {
    case 'H': return comment.starts_with("$HMNAME") || comment.starts_with("$HMSET ");
    case 'A': return comment.starts_with("$ANSA_NAME_COMMENT");
    case ' ': return comment.starts_with("$ Pset:") || comment.starts_with("$ Femap");
    case '*': return comment.find("roperty:") != std::string_view::npos;
    default: return false;
    }
}

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\0';
}

bool is_mark(char c) {
    return c == '+' || c == '*';
}

/// What tells one continuation from another: the mark without its first character.
std::string_view tag_of(std::string_view mark) {
    mark = trim(mark);
    return mark.empty() ? mark : mark.substr(1);
}

}  // namespace

bool BulkLines::advance() {
    while (next_ < text_.size()) {
        start_ = next_;
        const char* first = text_.data() + start_;
        const std::size_t rest = text_.size() - start_;
        const void* found = std::memchr(first, '\n', rest);
        const std::size_t length =
            found != nullptr ? static_cast<std::size_t>(static_cast<const char*>(found) - first) : rest;
        next_ = start_ + length + (found != nullptr ? 1 : 0);
        line_ = {first, length};
        if (length > 0 && first[0] == '$') {
            if (names != nullptr && names_something(line_)) names->push_back(line_);
            continue;
        }
        if (const void* comment = std::memchr(first, '$', length))
            line_ = {first, static_cast<std::size_t>(static_cast<const char*>(comment) - first)};
        while (!line_.empty() && is_space(line_.back())) line_.remove_suffix(1);
        if (!line_.empty()) return true;
    }
    return false;
}

bool is_continuation(std::string_view line) {
    if (line.empty()) return false;
    if (is_mark(line[0]) || line[0] == ',' || line[0] == '\t') return true;
    if (line[0] != ' ') return false;
    const std::size_t first = line.find_first_not_of(' ');
    return first >= kColumn || line[first] == ',' || line[first] == '\t';
}

CardHead card_head(std::string_view line, std::size_t offset) {
    CardHead head;
    head.offset = offset;
    std::size_t i = std::min(line.find_first_not_of(' '), line.size());
    for (; i < line.size() && head.length < head.letters.size(); ++i) {
        const char c = line[i];
        if (is_space(c) || c == ',') break;
        if (c == '*') {
            head.large = true;
            break;
        }
        head.letters[head.length++] = to_capital(c);
    }
    return head;
}

void BulkCard::set(std::size_t i, std::string_view field) {
    field = trim(field);
    if (field.empty()) return;
    if (i >= fields_.size()) fields_.resize(i + 1);
    fields_[i] = field;
}

void BulkCard::add_fixed(std::string_view line) {
    if (std::memchr(line.data(), '\t', line.size()) != nullptr) {
        if (spaced_used_ == spaced_.size()) spaced_.emplace_back();
        std::array<char, 80>& out = spaced_[spaced_used_++];
        std::size_t n = 0;
        for (std::size_t i = 0; i < line.size() && n < out.size(); ++i) {
            if (line[i] != '\t') {
                out[n++] = line[i];
            } else {
                const std::size_t stop = std::min((n / kColumn + 1) * kColumn, out.size());
                while (n < stop) out[n++] = ' ';
            }
        }
        line = {out.data(), n};
    }
    mark_ = line.size() > kLastData ? tag_of(line.substr(kLastData, kColumn)) : std::string_view{};
    const std::size_t width = large_ ? 2 * kColumn : kColumn;
    const std::size_t end = std::min(line.size(), kLastData);
    std::size_t i = base_;
    for (std::size_t at = kColumn; at < end; at += width)
        set(i++, line.substr(at, std::min(width, end - at)));
}

void BulkCard::add_free(std::string_view line) {
    // The field behind the last data field is a mark, unless more fields follow it: then the line simply
    // holds more data than a fixed one could.
    const std::size_t mark = large_ ? 5 : 9;
    const auto is_beyond = [&](std::string_view rest) {
        const std::size_t comma = rest.find(',');
        return comma != std::string_view::npos &&
               rest.find_first_not_of(", \t", comma) != std::string_view::npos;
    };
    std::size_t i = 0;
    mark_ = {};
    while (true) {
        const std::size_t comma = std::min(line.find(','), line.size());
        if (i == mark && !is_beyond(line)) {
            mark_ = tag_of(line.substr(0, comma));
            break;
        }
        if (i > 0) set(base_ + i - 1, line.substr(0, comma));
        if (comma == line.size()) break;
        line.remove_prefix(comma + 1);
        ++i;
    }
    // What a longer line held beyond a whole one: the next line starts after it.
    const std::size_t width = large_ ? 4 : 8;
    const bool is_long = i > mark;
    while (is_long && i > width) {
        base_ += width;
        i -= width;
    }
}

void BulkCard::add_line(std::string_view line) {
    // Two large lines are one small one.
    if (!large_ && (base_ - 1) % 8 != 0) base_ += 4;
    if (std::memchr(line.data(), ',', line.size()) != nullptr) {
        add_free(line);
    } else {
        add_fixed(line);
    }
    base_ += large_ ? 4 : 8;
}

void BulkCard::read(std::string_view text, const CardHead& head) {
    fields_.clear();
    spaced_used_ = 0;
    base_ = 1;
    large_ = head.large;
    marks_differ_ = false;
    BulkLines lines(text, head.offset);
    if (!lines.advance()) return;
    add_line(lines.line());
    while (lines.advance() && is_continuation(lines.line())) {
        const std::string_view line = lines.line();
        if (is_mark(line[0])) {
            large_ = line[0] == '*';
            const std::string_view tag = tag_of(line.substr(0, std::min(line.find_first_of(",\t"), kColumn)));
            if (!tag.empty() && !mark_.empty() && tag != mark_) marks_differ_ = true;
        }
        add_line(line);
    }
}

std::optional<std::int64_t> BulkCard::integer(std::size_t i) const {
    return parse_integer(field(i));
}

std::optional<double> BulkCard::real(std::size_t i) const {
    return parse_double(field(i));
}

}  // namespace feelem::nastran
