// SPDX-License-Identifier: Apache-2.0
// The lines of element lists: ELEM MAT TYP REL ESY SEC and node ids, which go on in further lines.
#pragma once

#include "read/ansys/list_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace feelem::ansys {

inline constexpr std::size_t kAttributes = 6;  // ELEM MAT TYP REL ESY SEC
inline constexpr std::size_t kMostIds = 32;    // More than any element has.
inline constexpr std::size_t kContinuationIndent = 20;
inline constexpr std::array<std::size_t, kAttributes> kAttributeEnds{8, 12, 16, 20, 24, 28};
inline constexpr std::size_t kFirstId = 29;
inline constexpr std::size_t kIdWidth = 6;

struct Numbers {
    std::array<std::int64_t, kAttributes + kMostIds> values{};
    std::array<std::size_t, kAttributes + kMostIds> ends{};  ///< Column behind each.
    std::size_t count = 0;
};

/// The whole numbers of a line from a column on. False when something else stands between them.
inline bool read_numbers(std::string_view line, std::size_t first, Numbers& numbers) {
    numbers.count = 0;
    Cursor cursor(line);
    cursor.at += std::min(first, line.size());
    while (!cursor.at_end()) {
        if (*cursor.at == '-') ++cursor.at;  // ESY and REL may be negative; they are not used.
        std::int64_t value = 0;
        if (numbers.count == numbers.values.size() || !scan_unsigned(cursor, value)) return false;
        if (cursor.at != cursor.end && !is_gap(*cursor.at)) return false;
        numbers.values[numbers.count] = value;
        numbers.ends[numbers.count++] = static_cast<std::size_t>(cursor.at - line.data());
    }
    return true;
}

/// Whether numbers run across a boundary of I8, 5 x I4.
inline bool has_touching_attributes(std::string_view line) {
    return std::ranges::any_of(kAttributeEnds, [&](std::size_t end) {
        return end < line.size() && is_digit(line[end - 1]) && is_digit(line[end]);
    });
}

inline std::size_t indent_of(std::string_view line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

}  // namespace feelem::ansys
