// SPDX-License-Identifier: Apache-2.0
#include "read/unv/unv_datasets.hpp"

#include "read/text_lines.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

namespace feelem::unv {
namespace {

/// "    -1" and nothing else: longer lines cannot be one, whatever they hold.
bool is_delimiter(std::string_view line) {
    if (line.size() < 2) return false;
    // By its first character: nearly every line is a number's.
    const std::size_t first = std::min(line.find_first_not_of(' '), line.size() - 1);
    if (line[first] > ' ' && line[first] != '-') return false;
    return trim(line) == "-1";
}

/// The number of a dataset; binary ones (58b) say how many bytes follow.
struct DatasetHead {
    int number = 0;
    std::uint64_t binary_bytes = 0;
};
std::optional<DatasetHead> read_dataset_head(std::string_view line) {
    DatasetHead head;
    std::string_view word = take_word(line);
    const bool binary = word.ends_with('b');
    if (binary) word.remove_suffix(1);
    const auto number = parse_integer(word);
    if (!number || *number <= 0 || *number > 99999) return {};
    head.number = static_cast<int>(*number);
    if (binary) {
        // 58b, byte order, float format, header lines, bytes ...
        for (int i = 0; i < 2; ++i) take_word(line);
        take_word(line);
        const auto bytes = take_integer(line);
        if (bytes && *bytes > 0) head.binary_bytes = static_cast<std::uint64_t>(*bytes);
    }
    return head;
}

}  // namespace

std::vector<Dataset> find_datasets(const Input& input, Diagnostics& diagnostics) {
    std::vector<Dataset> datasets;
    std::size_t at = 0;
    bool inside = false;
    while (at < input.size()) {
        TextLines lines(input, at, input.size());
        bool closed = false;
        while (const auto line = lines.next()) {
            if (!is_delimiter(*line)) continue;
            closed = true;
            break;
        }
        if (inside) datasets.back().last = closed ? lines.line_start() : input.size();
        at = lines.offset();
        if (!closed) break;
        inside = !inside;
        if (!inside) continue;
        const auto line = lines.next();
        const auto head = line ? read_dataset_head(*line) : std::nullopt;
        if (!head) {
            // Two delimiters in a row, or rubbish: the dataset starts with the next one.
            inside = line && is_delimiter(*line);
            at = inside ? lines.line_start() : lines.offset();
            inside = false;
            continue;
        }
        at = lines.offset();
        datasets.push_back({head->number, at, input.size()});
        if (head->binary_bytes > 0 && head->binary_bytes < input.size() - at) at += head->binary_bytes;
    }
    if (inside) {
        diagnostics.add(
            Code::TruncatedInput,
            [&] { return input.where_line(input.size()); },
            "the last dataset has no closing line (-1): the file was not written or copied whole"
        );
    }
    return datasets;
}

bool starts_like_unv(const Input& input) {
    TextLines lines(input, 0, std::min<std::size_t>(input.size(), 64u << 10));
    while (const auto line = lines.next()) {
        if (trim(*line).empty()) continue;
        if (!is_delimiter(*line)) return false;
        const auto second = lines.next();
        return second && read_dataset_head(*second).has_value();
    }
    return false;
}

}  // namespace feelem::unv
