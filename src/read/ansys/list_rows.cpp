// SPDX-License-Identifier: Apache-2.0
// Node and value rows. Numbers are read one after the other, so that touching columns come apart; only a row
// with holes or overflowed columns is cut by the column width.
#include "read/ansys/list_rows.hpp"

#include "base/plain_real.hpp"
#include "read/ansys/list_text.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::ansys {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

/// A line without the '\r' of a CRLF file.
std::string_view without_return(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

/// Reports a last line that may have been cut in the middle of a number. True: do not use it.
bool is_cut(const ListFile& file, const Lines& lines, std::size_t usual_length, Diagnostics* diagnostics) {
    if (lines.ended() || lines.line().size() >= usual_length) return false;
    if (diagnostics != nullptr) {
        diagnostics->add(
            Code::TruncatedInput,
            [&] { return file.input.where_line(lines.begin()); },
            "the last row has no line end and is shorter than the others: it may have been cut and is left "
            "out"
        );
    }
    return true;
}

void report_text(const ListFile& file, const Lines& lines, Diagnostics* diagnostics) {
    if (diagnostics == nullptr) return;
    diagnostics->add(
        Code::UnknownBlock,
        [&] { return file.input.where_line(lines.begin()); },
        "lines inside a list begin with a number but are no rows of it; they are left out"
    );
}

[[noreturn]] void throw_bad_row(const ListFile& file, const Lines& lines, std::string_view expected) {
    constexpr std::size_t kShown = 60;
    throw Error(
        Code::BadNumber,
        file.input.where_line(lines.begin()),
        fmt::format(
            "expected {}, found \"{}\". Was the list edited, or was the file damaged?",
            expected,
            trim(lines.line().substr(0, kShown))
        )
    );
}

/// The id at the start of a row. False: the line is no row.
bool scan_row_id(Cursor& cursor, std::int64_t& id) {
    if (!scan_unsigned(cursor, id) || id == 0) return false;
    return cursor.at == cursor.end || is_gap(*cursor.at) || *cursor.at == '-' || *cursor.at == '*';
}

/// Whether a word can begin a value: text behind an id (VERSION=LINUX) makes a line no row.
bool can_begin_value(std::string_view word) {
    const char c = word.front();
    return is_digit(c) || c == '-' || c == '+' || c == '.' || c == '*' ||
           std::isnan(parse_float(word).value_or(0));
}

/// Whether a column boundary falls between two numbers and not into one.
bool separates(std::string_view line, std::size_t boundary) {
    if (boundary == 0 || boundary >= line.size()) return true;
    const auto in_number = [](char c) { return is_digit(c) || c == '.' || c == 'E' || c == 'e'; };
    return !(in_number(line[boundary - 1]) && in_number(line[boundary]));
}

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
bool scan_plain_id(const char*& at, const char* end, std::int64_t& id) {
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

enum class RowKind {
    Row,
    Text,
    Bad
};

/// Rows of values: state that a row needs besides its line.
class ValueParser {
public:
    explicit ValueParser(const ValueHead& head)
        : width_(head.column_width), values_(head.columns.size()), columns_(head.columns.size()) {}

    std::span<const float> values() const { return values_; }
    bool has_bad_value() const { return has_bad_value_; }

    /// A row with all its values as solvers print them; false, without moving, when it is not.
    bool parse_plain(RowCursor& cursor, std::int64_t& id, std::size_t& length) {
        const char* at = cursor.plain_row(values_.size());
        has_bad_value_ = false;
        return at != nullptr && scan_plain_id(at, cursor.text_end(), id) &&
               columns_.scan(at, cursor.text_end(), values_) && cursor.finish_row(at, length);
    }

    RowKind parse(std::string_view line, std::int64_t& id) {
        has_bad_value_ = false;
        Cursor cursor(line);
        if (!scan_row_id(cursor, id)) return RowKind::Text;
        const auto id_end = static_cast<std::size_t>(cursor.at - line.data());
        for (float& value : values_) {
            if (!scan_real(cursor, value)) return by_width(line, id_end);
            check(value);
        }
        return cursor.at_end() ? RowKind::Row : by_width(line, id_end);
    }

private:
    void check(float& value) {
        if (std::isfinite(value)) return;
        value = kMissing;
        has_bad_value_ = true;
    }

    /// Cuts the row into columns behind the id and one blank.
    RowKind by_width(std::string_view line, std::size_t id_end) {
        has_bad_value_ = false;
        const std::string_view rest = trim(line.substr(id_end));
        if (rest.empty()) {
            std::ranges::fill(values_, kMissing);
            return RowKind::Row;
        }
        if (!can_begin_value(rest.substr(0, rest.find(' ')))) return RowKind::Text;
        if (values_.size() == 1) return field(rest, 0) ? RowKind::Row : RowKind::Bad;
        if (width_ == 0) return by_blanks(rest);
        const std::size_t first = id_end + 1;
        const auto content_end = static_cast<std::size_t>(rest.data() + rest.size() - line.data());
        if (content_end > first + values_.size() * width_) return by_blanks(rest);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const std::size_t begin = std::min(first + i * width_, line.size());
            const std::size_t end = std::min(begin + width_, line.size());
            if (!separates(line, end) || !field(line.substr(begin, end - begin), i)) return by_blanks(rest);
        }
        return RowKind::Row;
    }

    /// Without known columns every value must be there.
    RowKind by_blanks(std::string_view rest) {
        Cursor cursor(rest);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const std::string_view word = next_word(cursor);
            if (word.empty() || !field(word, i)) return RowKind::Bad;
        }
        return cursor.at_end() ? RowKind::Row : RowKind::Bad;
    }

    bool field(std::string_view text, std::size_t column) {
        text = trim(text);
        values_[column] = kMissing;
        if (text.empty()) return true;  // A column that the solver leaves blank at this node.
        const auto value = parse_float(text);
        if (!value) return false;
        values_[column] = *value;
        check(values_[column]);
        return true;
    }

    std::size_t width_;
    std::vector<float> values_;
    PlainColumns<float> columns_;
    bool has_bad_value_ = false;
};

/// "ELEMENT=   32423        SOLID187": the element and its type; other lines change nothing.
void read_element_line(std::string_view line, ValueRow& row) {
    const std::string_view text = trim(line);
    constexpr std::string_view kKey = "ELEMENT=";
    if (!text.starts_with(kKey)) return;
    Cursor cursor(text.substr(kKey.size()));
    if (!scan_unsigned(cursor, row.element)) row.element = 0;
    row.element_type = next_word(cursor);
}

}  // namespace

namespace {

/// The row of a line, by the general way. False: the line is no row.
bool read_node_row(
    const ListFile& file,
    const List& list,
    const Lines& lines,
    std::size_t usual_length,
    Diagnostics* diagnostics,
    NodeRow& row
) {
    if (!is_digit(first_mark(lines.line()))) return false;
    Cursor cursor(lines.line());
    if (!scan_row_id(cursor, row.id)) {
        report_text(file, lines, diagnostics);
        return false;
    }
    if (is_cut(file, lines, usual_length, diagnostics)) return false;
    for (double& x : row.position) {
        if (!scan_real(cursor, x) || !std::isfinite(x))
            throw_bad_row(file, lines, "three coordinates of a node");
    }
    row.angles = {};
    for (std::size_t i = 0; i < 3 && list.has_angles; ++i) {
        if (!cursor.at_end() && !scan_real(cursor, row.angles[i])) throw_bad_row(file, lines, "three angles");
    }
    if (!cursor.at_end()) throw_bad_row(file, lines, list.has_angles ? "six numbers" : "three coordinates");
    return true;
}

/// Place and angles of plain rows.
class PlainNodeRows {
public:
    explicit PlainNodeRows(bool has_angles) : columns_(has_angles ? 6 : 3), reals_(has_angles ? 6 : 3) {}

    bool read(RowCursor& cursor, NodeRow& row, std::size_t& length) {
        const char* at = cursor.plain_row(reals_.size());
        if (at == nullptr || !scan_plain_id(at, cursor.text_end(), row.id) ||
            !columns_.scan(at, cursor.text_end(), reals_))
            return false;
        if (!cursor.finish_row(at, length)) return false;
        std::copy_n(reals_.begin(), 3, row.position.begin());
        if (reals_.size() == 6)
            std::copy_n(reals_.begin() + 3, 3, row.angles.begin());
        else
            row.angles = {};
        return true;
    }

private:
    PlainColumns<double> columns_;
    std::vector<double> reals_;
};

}  // namespace

void for_each_node(
    const ListFile& file,
    const List& list,
    Diagnostics* diagnostics,
    const std::function<void(const NodeRow&)>& use
) {
    std::size_t usual_length = 0;
    NodeRow row;
    PlainNodeRows plain(list.has_angles);
    ReleaseBehind release(file.input);
    for (const TextRange run : list.runs) {
        for (RowCursor cursor(file, run); !cursor.at_end();) {
            row.offset = cursor.at();
            if (!plain.read(cursor, row, usual_length)) {
                const Lines lines = cursor.line();
                if (!read_node_row(file, list, lines, usual_length, diagnostics, row)) continue;
                usual_length = without_return(lines.line()).size();
            }
            use(row);
            release.at(row.offset);
        }
    }
}

void for_each_value_row(
    const ListFile& file,
    const List& list,
    Diagnostics* diagnostics,
    const std::function<void(const ValueRow&)>& use
) {
    std::size_t usual_length = 0;
    ValueParser parser(list.head);
    ValueRow row;
    ReleaseBehind release(file.input);
    row.values = parser.values();
    for (const TextRange run : list.runs) {
        for (RowCursor cursor(file, run); !cursor.at_end();) {
            row.offset = cursor.at();
            if (!parser.parse_plain(cursor, row.id, usual_length)) {
                const Lines lines = cursor.line();
                if (!is_digit(first_mark(lines.line()))) {
                    read_element_line(lines.line(), row);
                    continue;
                }
                const RowKind kind = parser.parse(lines.line(), row.id);
                if (kind == RowKind::Text) {
                    report_text(file, lines, diagnostics);
                    continue;
                }
                if (is_cut(file, lines, usual_length, diagnostics)) continue;
                if (kind == RowKind::Bad)
                    throw_bad_row(file, lines, fmt::format("{} values", list.head.columns.size()));
                usual_length = without_return(lines.line()).size();
            }
            row.has_bad_value = parser.has_bad_value();
            use(row);
            release.at(row.offset);
        }
    }
}

int coordinate_digits(const ListFile& file, const List& list) {
    constexpr int kRows = 20;
    std::size_t most = 0;
    int rows = 0;
    for (const TextRange run : list.runs) {
        Lines lines(file.input.text(), run.begin, run.end, file.line_end);
        while (lines.next() && rows++ < kRows) {
            Cursor cursor(lines.line());
            next_word(cursor);
            for (int i = 0; i < 3; ++i) {
                const std::string_view word = next_word(cursor);
                const std::string_view mantissa = word.substr(0, word.find_first_of("Ee"));
                const auto digits = static_cast<std::size_t>(std::ranges::count_if(mantissa, is_digit));
                const std::size_t leading = mantissa.starts_with("0.") || mantissa.starts_with("-0.") ? 1 : 0;
                most = std::max(most, digits - leading);
            }
        }
    }
    return static_cast<int>(most);
}

}  // namespace feelem::ansys
