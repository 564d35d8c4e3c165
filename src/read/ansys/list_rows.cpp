// SPDX-License-Identifier: Apache-2.0
// Node and value rows. Numbers are read one after the other, so that touching columns come apart; only a row
// with holes or overflowed columns is cut by the column width.
#include "read/ansys/list_rows.hpp"

#include "read/ansys/list_node_rows.hpp"
#include "read/ansys/list_plain_rows.hpp"
#include "read/ansys/list_text.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// The last line of rows that were taken, without its end.
std::string_view last_line(const ListFile& file, const RowRun& run) {
    const std::string_view rows = file.input.text().substr(run.begin, run.end - run.begin - 1);
    return rows.substr(rows.rfind(file.line_end) + 1);  // npos + 1 is 0.
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

enum class RowKind {
    Row,
    Text,
    Bad
};

/// Rows of values: state that a row needs besides its line.
class ValueParser {
public:
    explicit ValueParser(const ValueHead& head)
        : width_(head.column_width), values_(head.columns.size()), columns_(head.columns.size()),
          alike_(head.columns.size()), many_(AlikeRows<float>::kAtOnce * head.columns.size()) {}

    std::span<const float> values() const { return values_; }
    bool has_bad_value() const { return has_bad_value_; }

    /// Rows with all their values as solvers print them; none, without moving, when the next one is not.
    ValueRows parse_plain(RowCursor& cursor, std::size_t& length) {
        std::size_t count = alike_.read(cursor, ids_, many_.data());
        if (count > 0) {
            length = alike_.length();
        } else {
            const std::string_view row = cursor.rest();
            const char* at = cursor.plain_row(values_.size());
            const auto values = std::span(many_).first(values_.size());
            if (at == nullptr || !scan_plain_id(at, cursor.text_end(), ids_[0]) ||
                !columns_.scan(at, cursor.text_end(), values) || !cursor.finish_row(at, length))
                return {};
            alike_.learn(row, cursor.line_end());
            count = 1;
        }
        return {std::span(ids_).first(count), std::span(many_).first(count * values_.size())};
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
    AlikeRows<float> alike_;
    std::array<std::int64_t, AlikeRows<float>::kAtOnce> ids_{};
    std::vector<float> many_;  ///< Of as many rows.
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

}  // namespace

void for_each_node(
    const ListFile& file,
    const List& list,
    Diagnostics* diagnostics,
    const std::function<void(const NodeRow&)>& use,
    const std::function<void(std::size_t first, std::size_t count)>& use_taken
) {
    std::size_t usual_length = 0;
    std::size_t taken = 0;
    NodeRow row;
    NodeRows rows;
    PlainNodeRows plain(list.has_angles);
    ReleaseBehind release(file.input);
    for (const RowRun& run : list.runs) {
        if (run.taken > 0) {
            use_taken(taken, run.taken);
            taken += run.taken;
            usual_length = without_return(last_line(file, run)).size();
            continue;
        }
        for (RowCursor cursor(file, {run.begin, run.end}); !cursor.at_end();) {
            release.at(cursor.at());
            if (const std::size_t count = plain.read(cursor, rows, usual_length)) {
                row.angles = rows.angles;
                for (std::size_t i = 0; i < count; ++i) {
                    row.id = rows.ids[i];
                    row.position = rows.places[i];
                    use(row);
                }
                continue;
            }
            const Lines lines = cursor.line();
            if (!read_node_row(file, list, lines, usual_length, diagnostics, row)) continue;
            usual_length = without_return(lines.line()).size();
            use(row);
        }
    }
}

void for_each_value_row(
    const ListFile& file,
    const List& list,
    Diagnostics* diagnostics,
    const std::function<void(const ValueRow&)>& use,
    const std::function<void(const ValueRows&)>& use_many
) {
    std::size_t usual_length = 0;
    ValueParser parser(list.head);
    ValueRow row;
    ReleaseBehind release(file.input);
    const auto use_each = [&](const ValueRows& rows, std::size_t offset, std::size_t length) {
        const std::size_t columns = list.head.columns.size();
        row.has_bad_value = false;
        for (std::size_t i = 0; i < rows.ids.size(); ++i) {
            row.id = rows.ids[i];
            row.values = rows.values.subspan(i * columns, columns);
            row.offset = offset + i * length;
            use(row);
        }
    };
    for (const RowRun& run : list.runs) {
        for (RowCursor cursor(file, {run.begin, run.end}); !cursor.at_end();) {
            row.offset = cursor.at();
            release.at(row.offset);
            const ValueRows rows = parser.parse_plain(cursor, usual_length);
            if (!rows.ids.empty()) {
                if (use_many)
                    use_many(rows);
                else
                    use_each(rows, row.offset, (cursor.at() - row.offset) / rows.ids.size());
                continue;
            }
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
            row.values = parser.values();
            row.has_bad_value = parser.has_bad_value();
            use(row);
        }
    }
}

int coordinate_digits(const ListFile& file, const List& list) {
    constexpr int kRows = 20;
    std::size_t most = 0;
    int rows = 0;
    for (const RowRun& run : list.runs) {
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
