// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/cdb_format.hpp"

#include "base/number.hpp"

#include <algorithm>

namespace feelem::ansys::cdb {
namespace {

constexpr std::size_t kMostColumns = 100;
constexpr std::size_t kWidest = 40;

/// Digits at the front of the text, taken off it; `none` when there are none, 0 when there are too many.
std::size_t take_number(std::string_view& text, std::size_t none) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    const auto value = parse_integer(text.substr(0, digits));
    text.remove_prefix(digits);
    if (digits == 0) return none;
    return value && *value <= 1000 ? static_cast<std::size_t>(*value) : 0;
}

/// One group: 6e21.13e3.
struct Group {
    std::size_t count = 0;
    char kind = 0;
    std::size_t width = 0;
    std::size_t decimals = 0;
};

std::optional<Group> parse_group(std::string_view text) {
    Group group;
    text = trim(text);
    group.count = take_number(text, 1);
    if (text.empty()) return std::nullopt;
    group.kind = static_cast<char>(text.front() | 0x20);
    text.remove_prefix(1);
    group.width = take_number(text, 0);
    if (text.starts_with('.')) {
        text.remove_prefix(1);
        group.decimals = take_number(text, 0);
    }
    const bool has_kind = group.kind == 'i' || group.kind == 'e' || group.kind == 'g' || group.kind == 'f' ||
                          group.kind == 'd' || group.kind == 'a';
    const bool bounded =
        group.count >= 1 && group.count <= kMostColumns && group.width >= 1 && group.width <= kWidest;
    return has_kind && bounded ? std::optional(group) : std::nullopt;
}

}  // namespace

std::optional<RowFormat> parse_format(std::string_view line) {
    line = trim(line);
    const std::size_t close = line.find(')');
    if (!line.starts_with('(') || close == std::string_view::npos) return std::nullopt;
    line = line.substr(1, close - 1);
    RowFormat format;
    while (!line.empty()) {
        const std::size_t comma = std::min(line.find(','), line.size());
        const auto group = parse_group(line.substr(0, comma));
        line.remove_prefix(std::min(comma + 1, line.size()));
        if (!group) return std::nullopt;
        if (group->kind == 'i') {
            if (format.others != 0) return std::nullopt;
            if (format.integers == 0) format.id_width = group->width;
            const bool widens = format.integers > 1 && format.integer_width != group->width;
            if (widens) return std::nullopt;
            format.integer_width = group->width;
            format.integers += group->count;
            format.integers_end += group->count * group->width;
        } else {
            if (format.others != 0) return std::nullopt;
            format.others = group->count;
            format.other_width = group->width;
            format.decimals = group->decimals;
        }
    }
    return format.integers > 0 && format.integers <= kMostColumns ? std::optional(format) : std::nullopt;
}

}  // namespace feelem::ansys::cdb
