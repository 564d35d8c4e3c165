// SPDX-License-Identifier: Apache-2.0
// Element rows: six numbers and the node ids, which go on in the next lines.
#include "base/columns.hpp"
#include "base/eight_digits.hpp"
#include "read/ansys/list_rows.hpp"
#include "read/ansys/list_text.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

namespace feelem::ansys {
namespace {

constexpr std::size_t kAttributes = 6;  // ELEM MAT TYP REL ESY SEC
constexpr std::size_t kMostIds = 32;    // More than any element has.
constexpr std::size_t kContinuationIndent = 20;
constexpr std::array<std::size_t, kAttributes> kAttributeEnds{8, 12, 16, 20, 24, 28};
constexpr std::size_t kFirstId = 29;
constexpr std::size_t kIdWidth = 6;

struct Numbers {
    std::array<std::int64_t, kAttributes + kMostIds> values{};
    std::array<std::size_t, kAttributes + kMostIds> ends{};  ///< Column behind each.
    std::size_t count = 0;
    std::size_t length = 0;  ///< Of the line.
    /// The last ones, when they stand in columns of one width that columns_of_integers can read.
    std::size_t first_even = 0, width = 0;

    void note_columns() {
        first_even = width = 0;
        if (count < 5 || length == 0) return;
        const std::size_t last = ends[count - 1] - ends[count - 2];
        if (last < 8 || last > 16) return;
        std::size_t first = count - 1;
        while (first > 1 && ends[first - 1] - ends[first - 2] == last) --first;
        if (count - first >= 4) first_even = first, width = last;
    }
};

/// The numbers of a line as long as the one before, when they end in the same columns, with a blank before
/// each. False, and nothing is changed that counts, when they do not.
bool read_alike(std::string_view line, Numbers& numbers) {
    if (line.size() != numbers.length || numbers.count == 0 || numbers.ends[0] < 8) return false;
    constexpr std::uint64_t kBlanks = 0x2020202020202020;
    std::array<std::int64_t, kAttributes + kMostIds> values;
    std::uint64_t bad = 0;
    const std::size_t one_by_one = numbers.width == 0 ? numbers.count : numbers.first_even;
    std::size_t from = 0;  // Behind the number before.
    for (std::size_t i = 0; i < one_by_one; ++i) {
        const std::size_t end = numbers.ends[i];
        std::uint64_t word = load8(line.data() + end - 8);
        if (end - from < 8) {
            const std::size_t foreign = 8 * (8 - (end - from));
            word = (word >> foreign << foreign) | (kBlanks >> (64 - foreign));
        }
        bad |= static_cast<std::uint64_t>(line[from] != ' ');
        for (; from + 8 < end; ++from) bad |= static_cast<std::uint64_t>(line[from] != ' ');
        values[i] = eight_columns(word, bad);
        from = end;
    }
    for (std::size_t i = one_by_one; i < numbers.count; ++i, from += numbers.width)
        bad |= static_cast<std::uint64_t>(line[from] != ' ');
    for (; from < line.size(); ++from)
        bad |= static_cast<std::uint64_t>(line[from] != ' ' && line[from] != '\r');
    if (bad != 0) return false;
    if (one_by_one < numbers.count) {
        const char* columns = line.data() + numbers.ends[one_by_one] - numbers.width;
        const std::size_t count = numbers.count - one_by_one;
        if (!columns_of_integers(columns, numbers.width, count, values.data() + one_by_one)) return false;
    }
    std::copy_n(values.begin(), numbers.count, numbers.values.begin());
    return true;
}

/// The whole numbers of a line from a column on. False when something else stands between them.
bool read_numbers(std::string_view line, std::size_t first, Numbers& numbers) {
    if (first == 0 && read_alike(line, numbers)) return true;
    std::size_t count = 0;
    numbers.length = 0;
    Cursor cursor(line);
    cursor.at += std::min(first, line.size());
    while (!cursor.at_end()) {
        if (*cursor.at == '-') ++cursor.at;  // ESY and REL may be negative; they are not used.
        std::int64_t value = 0;
        if (count == numbers.values.size() || !scan_unsigned(cursor, value)) return false;
        if (cursor.at != cursor.end && !is_gap(*cursor.at)) return false;
        numbers.values[count] = value;
        numbers.ends[count++] = static_cast<std::size_t>(cursor.at - line.data());
    }
    numbers.count = count;
    numbers.length = first == 0 ? line.size() : 0;
    numbers.note_columns();
    return true;
}

/// One field of fixed width, or nothing when it does not end in a digit.
std::optional<std::int64_t> field(std::string_view line, std::size_t begin, std::size_t end) {
    if (end > line.size() || !is_digit(line[end - 1])) return std::nullopt;
    return parse_integer(line.substr(begin, end - begin));
}

/// Six-digit ids fill their columns (I6 behind column 29) and touch: "123456123457". True when every number
/// ends at a column's end and one is wider than a column.
bool has_touching_ids(std::string_view line, const Numbers& numbers, std::size_t first) {
    if (line.size() < kFirstId || !is_gap(line[kFirstId - 1])) return false;
    bool wide = false;
    for (std::size_t i = first; i < numbers.count; ++i) {
        if (numbers.ends[i] <= kFirstId || (numbers.ends[i] - kFirstId) % kIdWidth != 0) return false;
        wide = wide || numbers.values[i] >= 1'000'000;
    }
    return wide;
}

class ElementParser {
public:
    std::array<std::int64_t, kAttributes> attributes{};
    std::array<std::int64_t, kMostIds> ids{};
    std::size_t count = 0;

    /// The first line of an element.
    bool begin(std::string_view line) {
        count = 0;
        Numbers& numbers = numbers_[0];
        const bool plain = read_numbers(line, 0, numbers) && numbers.count >= kAttributes;
        const bool in_columns = (!plain || has_touching_attributes(line)) && attributes_by_columns(line);
        if (!plain && !in_columns) return false;
        if (!in_columns) {
            std::copy_n(numbers.values.begin(), kAttributes, attributes.begin());
            return add(line, numbers, kAttributes);
        }
        return read_numbers(line, kFirstId - 1, numbers) ? add(line, numbers, 0) : add_by_width(line);
    }

    /// A further line of it, the `which`-th from 1.
    bool go_on(std::string_view line, std::size_t which) {
        Numbers& numbers = numbers_[std::min(which, numbers_.size() - 1)];
        return read_numbers(line, 0, numbers) ? add(line, numbers, 0) : add_by_width(line);
    }

private:
    /// Whether numbers run across a boundary of I8, 5 x I4.
    static bool has_touching_attributes(std::string_view line) {
        return std::ranges::any_of(kAttributeEnds, [&](std::size_t end) {
            return end < line.size() && is_digit(line[end - 1]) && is_digit(line[end]);
        });
    }

    bool attributes_by_columns(std::string_view line) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < kAttributes; ++i) {
            const auto value = field(line, begin, kAttributeEnds[i]);
            if (!value) return false;
            attributes[i] = *value;
            begin = kAttributeEnds[i];
        }
        return true;
    }

    bool add(std::string_view line, const Numbers& numbers, std::size_t first) {
        if (has_touching_ids(line, numbers, first)) return add_by_width(line);
        for (std::size_t i = first; i < numbers.count; ++i) {
            if (count == ids.size()) return false;
            ids[count++] = numbers.values[i];
        }
        return true;
    }

    bool add_by_width(std::string_view line) {
        for (std::size_t begin = kFirstId; begin < line.size() && !trim(line.substr(begin)).empty();
             begin += kIdWidth) {
            const auto id = field(line, begin, begin + kIdWidth);
            if (!id || *id < 0 || count == ids.size()) return false;
            ids[count++] = *id;
        }
        return true;
    }

    std::array<Numbers, 4>
        numbers_;  ///< Of the first line and of further ones, each like the same of the element before.
};

std::size_t indent_of(std::string_view line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

/// Without blanks at its end.
std::size_t length_of(std::string_view line) {
    return trim(line).size() + indent_of(line);
}

[[noreturn]] void throw_bad_element(const ListFile& file, std::size_t offset, std::string_view line) {
    constexpr std::size_t kShown = 60;
    throw Error(
        Code::BadNumber,
        file.input.where_line(offset),
        fmt::format(
            "expected an element's number, MAT TYP REL ESY SEC and its nodes, found \"{}\". Was the list "
            "edited, "
            "or was the file damaged?",
            trim(line.substr(0, kShown))
        )
    );
}

void report_cut(const ListFile& file, std::size_t offset, Diagnostics* diagnostics) {
    if (diagnostics == nullptr) return;
    diagnostics->add(
        Code::TruncatedInput,
        [&] { return file.input.where_line(offset); },
        "the last element's rows are shorter than those of others of its type: the file may have been cut "
        "there; "
        "the element is left out"
    );
}

}  // namespace

void for_each_element(
    const ListFile& file,
    const List& list,
    Diagnostics* diagnostics,
    const std::function<void(const ElementRowIds&)>& use
) {
    ElementParser parser;
    ElementRowIds row;
    std::size_t line_of_element = 0;                  // 0: none is open.
    std::map<std::int64_t, std::size_t> usual_count;  // By type.
    std::array<std::string_view, kMostIds> usual_lines{};
    const auto close = [&](bool last) {
        if (line_of_element == 0) return;
        line_of_element = 0;
        row.id = parser.attributes[0];
        row.material = parser.attributes[1];
        row.type = parser.attributes[2];
        row.nodes = std::span(parser.ids).first(parser.count);
        std::size_t& usual = usual_count[row.type];
        // Whole lines may be missing: then the last one there is full.
        if (last && parser.count % 8 == 0 && parser.count < usual) {
            report_cut(file, row.offset, diagnostics);
            return;
        }
        usual = parser.count;
        use(row);
    };
    bool at_end_of_file = false;
    ReleaseBehind release(file.input);
    for (const TextRange run : list.runs) {
        Lines lines(file.input.text(), run.begin, run.end, file.line_end);
        while (lines.next()) {
            release.at(lines.begin());
            const std::string_view line = lines.line();
            if (!is_digit(first_mark(line))) continue;
            const bool further = line_of_element > 0 && indent_of(line) >= kContinuationIndent;
            std::string_view& usual = usual_lines[further ? std::min(line_of_element, kMostIds - 1) : 0];
            if (!lines.ended() && length_of(line) < length_of(usual)) {
                if (further) line_of_element = 0;  // A cut further line spoils its element.
                report_cut(file, lines.begin(), diagnostics);
                continue;
            }
            usual = line;
            if (!further) close(false);
            if (further ? !parser.go_on(line, line_of_element) : !parser.begin(line))
                throw_bad_element(file, lines.begin(), line);
            if (!further) row.offset = lines.begin();
            ++line_of_element;
        }
        at_end_of_file = run.end == file.input.size();
    }
    close(at_end_of_file);
}

}  // namespace feelem::ansys
