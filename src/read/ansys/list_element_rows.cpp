// SPDX-License-Identifier: Apache-2.0
// Element rows: six numbers and the node ids, which go on in the next lines.
#include "read/ansys/list_element_lines.hpp"
#include "read/ansys/list_rows.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

namespace feelem::ansys {
namespace {

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
        const bool plain = read_numbers(line, 0, numbers_) && numbers_.count >= kAttributes;
        const bool in_columns = (!plain || has_touching_attributes(line)) && attributes_by_columns(line);
        if (!plain && !in_columns) return false;
        if (!in_columns) {
            std::copy_n(numbers_.values.begin(), kAttributes, attributes.begin());
            return add(line, numbers_, kAttributes);
        }
        return read_numbers(line, kFirstId - 1, numbers_) ? add(line, numbers_, 0) : add_by_width(line);
    }

    /// A further line of it.
    bool go_on(std::string_view line) {
        return read_numbers(line, 0, numbers_) ? add(line, numbers_, 0) : add_by_width(line);
    }

private:
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

    Numbers numbers_;
};

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

/// The lines of the last element that was taken, for those behind it to be compared with.
void note_lines(const ListFile& file, const RowRun& run, std::span<std::string_view> lines) {
    const std::size_t length = (run.end - run.begin) / run.taken;
    Lines all(file.input.text(), run.end - length, run.end, file.line_end);
    for (std::size_t i = 0; i < lines.size() && all.next(); ++i) lines[i] = all.line();
}

}  // namespace

void for_each_taken(const TakenElements& taken, const std::function<void(const ElementRowIds&)>& use) {
    std::array<std::int64_t, kMostIds> nodes{};
    ElementRowIds row;
    row.material = taken.run->material;
    row.type = taken.run->type;
    const std::size_t width = taken.run->nodes_each;
    row.nodes = std::span(nodes).first(width);
    for (std::size_t i = 0; i < taken.ids.size(); ++i) {
        row.id = raw(taken.ids[i]);
        row.offset = taken.offset(i);
        std::ranges::transform(taken.nodes.subspan(i * width, width), nodes.begin(), raw<NodeIndex>);
        use(row);
    }
}

void for_each_element(
    const ListFile& file,
    const List& list,
    Diagnostics* diagnostics,
    const std::function<void(const ElementRowIds&)>& use,
    const std::function<void(const TakenElements&)>& use_taken
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
    std::size_t taken = 0, taken_nodes = 0;
    ReleaseBehind release(file.input);
    // What stands before is compared with what follows.
    for (std::size_t r = std::max<std::size_t>(list.in_mesh, 1) - 1; r < list.runs.size(); ++r) {
        const RowRun& run = list.runs[r];
        if (run.taken > 0) {
            close(false);
            usual_count[run.type] = run.nodes_each;
            note_lines(file, run, usual_lines);
            if (r < list.in_mesh) continue;
            const std::size_t nodes = run.taken * run.nodes_each;
            const TakenElements some{
                &run,
                std::span(list.taken.element_ids).subspan(taken, run.taken),
                std::span(list.taken.element_nodes).subspan(taken_nodes, nodes)};
            taken += run.taken;
            taken_nodes += nodes;
            if (use_taken)
                use_taken(some);
            else
                for_each_taken(some, use);
            continue;
        }
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
            if (further ? !parser.go_on(line) : !parser.begin(line))
                throw_bad_element(file, lines.begin(), line);
            if (!further) row.offset = lines.begin();
            ++line_of_element;
        }
        at_end_of_file = run.end == file.input.size();
    }
    close(at_end_of_file);
}

}  // namespace feelem::ansys
