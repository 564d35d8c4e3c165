// SPDX-License-Identifier: Apache-2.0
// Must: take the rows of *NODE and *ELEMENT that programs write off the front of text, fast, or refuse them.
// Assumes: nothing; what is refused the caller reads field by field.
// Algorithm: numbers are taken as they come (base/take_numbers.hpp) between blanks and commas. Comments,
// signs of labels, fields left out, numbers that need more care than one rounding are refused. Data: none.
#pragma once

#include "base/take_numbers.hpp"
#include "read/abaqus/deck_model.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace feelem::abaqus {

/// So many bytes must follow where a row is taken by the columns of another.
inline constexpr std::ptrdiff_t kRoomForRow = 1024;

/// A run of blanks off the front, up to 32.
inline const char* skip_run_of_blanks(const char* at) {
    for (int i = 0; i < 4; ++i) {
        const char* const behind = skip_blanks(at);
        if (behind - at < 8) return behind;
        at = behind;
    }
    return at;
}

/// Behind a line's end, which stands at `at`; null when it does not.
inline const char* behind_line_end(const char* at) {
    if (*at == '\r') ++at;
    return *at == '\n' ? at + 1 : nullptr;
}

inline bool take_plain_label(const char*& at, Label& out) {
    std::int64_t value = 0;
    if (!take_digits(at, value) || value > std::numeric_limits<Label>::max()) return false;
    out = static_cast<Label>(value);
    return true;
}

/// Where fields stand in a row: rows follow each other with the same columns, or with as many digits, so that
/// no field waits for the end of the one before.
struct RowColumns {
    static constexpr std::size_t kMost = 1 + kMaxElementNodes;
    static constexpr std::size_t kShortest = 8;  ///< So that eight bytes are there before the next row.
    static constexpr std::size_t kLongest = 500;
    struct Field {
        std::uint16_t first = 0, last = 0;  ///< Blanks before the number belong to it.
        bool ends_line = false;             ///< A line ends behind the comma.
    };
    std::array<Field, kMost> fields{};
    std::size_t count = 0;
    std::size_t length = 0;  ///< With the line end; 0: no row has been seen.

    void begin() { count = length = 0; }
    void add(std::ptrdiff_t first, std::ptrdiff_t last, bool ends_line) {
        fields[count++] = {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(last), ends_line};
    }
};

/// "id, x, y, z" and a line's end; what is left out at the end of the line is 0. Moves `at` to the next line.
inline bool take_node_row(const char*& at, const char* end, Label& id, Point3& place, RowColumns& columns) {
    constexpr std::ptrdiff_t kRoom = 512;
    columns.begin();
    if (end - at < kRoom) return false;
    const char* p = skip_run_of_blanks(at);
    if (!take_plain_label(p, id) || id == 0) return false;
    place = {};
    p = skip_run_of_blanks(p);
    columns.add(0, p - at, false);
    for (double& x : place) {
        if (*p != ',') break;
        const char* const first = ++p;
        p = skip_run_of_blanks(p);
        if (!take_real(p, x)) return false;
        p = skip_run_of_blanks(p);
        columns.add(first - at, p - at, false);
    }
    p = behind_line_end(p);
    if (p == nullptr) return false;
    if (columns.count == 4) columns.length = static_cast<std::size_t>(p - at);
    at = p;
    return true;
}

/// A label that ends where the field does; bits are set in `bad` when it is anything else.
inline Label label_in(const char* row, RowColumns::Field field, std::uint64_t& bad) {
    return static_cast<Label>(digits_between(row + field.first, row + field.last, bad));
}

/// A node's row with the columns of one before. `at` must have a row's length, and room, behind it, and eight
/// bytes before it.
inline bool take_like_node_row(const char*& at, Label& id, Point3& place, const RowColumns& columns) {
    const char* const row = at;
    std::uint64_t bad = static_cast<std::uint64_t>(row[columns.length - 1] ^ '\n');
    id = label_in(row, columns.fields[0], bad);
    for (std::size_t i = 0; i < 3; ++i) {
        const RowColumns::Field field = columns.fields[i + 1];
        const char* p = skip_run_of_blanks(row + field.first);
        bad |= static_cast<std::uint64_t>(row[field.first - 1] ^ ',');
        if (!take_real(p, place[i]) || p != row + field.last) return false;
    }
    const char* const next = behind_line_end(row + columns.fields[3].last);
    if (bad != 0 || id == 0 || next != row + columns.length) return false;
    at = next;
    return true;
}

/// "id, node, node ..." with as many nodes as there is room for, over line ends behind commas, and a line's
/// end. Moves `at` to the next line.
inline bool take_element_row(
    const char*& at, const char* end, Label& id, std::span<Label> nodes, RowColumns& columns
) {
    constexpr std::ptrdiff_t kRoom = 128;
    columns.begin();
    if (end - at < kRoom) return false;
    const char* p = skip_run_of_blanks(at);
    if (!take_plain_label(p, id) || id == 0) return false;
    const char* first = at;
    bool is_tight = true;  // Commas and line ends stand right behind numbers.
    for (Label& node : nodes) {
        if (end - p < kRoom) return false;
        const char* const last = p;
        p = skip_run_of_blanks(p);
        is_tight = is_tight && p == last;
        if (*p++ != ',') return false;
        const char* const next = behind_line_end(skip_run_of_blanks(p));
        columns.add(first - at, last - at, next != nullptr);
        if (next != nullptr) is_tight = is_tight && behind_line_end(p) == next;
        first = next != nullptr ? next : p;
        p = skip_run_of_blanks(first);
        if (end - p < kRoom || !take_plain_label(p, node)) return false;
    }
    columns.add(first - at, p - at, true);
    is_tight = is_tight && behind_line_end(p) != nullptr;
    p = behind_line_end(skip_run_of_blanks(p));
    if (p == nullptr) return false;
    const auto length = static_cast<std::size_t>(p - at);
    const bool is_usual = is_tight && length >= RowColumns::kShortest && length < RowColumns::kLongest;
    if (is_usual) columns.length = length;
    at = p;
    return true;
}

/// An element's row with the columns of one before, as take_like_node_row().
inline bool take_like_element_row(
    const char*& at, Label& id, std::span<Label> nodes, const RowColumns& columns
) {
    const char* const row = at;
    std::uint64_t bad = 0;
    id = label_in(row, columns.fields[0], bad);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const RowColumns::Field before = columns.fields[i];
        bad |= static_cast<std::uint64_t>(row[before.last] ^ ',');
        if (before.ends_line && behind_line_end(row + before.last + 1) != row + columns.fields[i + 1].first)
            return false;
        nodes[i] = label_in(row, columns.fields[i + 1], bad);
    }
    const char* const next = behind_line_end(row + columns.fields[nodes.size()].last);
    if (bad != 0 || id == 0 || next != row + columns.length) return false;
    at = next;
    return true;
}

}  // namespace feelem::abaqus
