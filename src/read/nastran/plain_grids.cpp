// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/plain_grids.hpp"

#include "base/text_fields.hpp"
#include "read/nastran/plain_lines.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace feelem::nastran {
namespace {

/// GRID,id,,x,y,z as nearly all of them are: the ends of all fields are found first, so that no number waits
/// for the end of the one before.
std::optional<std::size_t> read_shortest_grid(std::string_view text, std::size_t at, BulkGrid& grid) {
    constexpr std::size_t kLookedAt = 64;
    if (!has_fast_columns() || at < 16 || text.size() - at <= kLookedAt) return {};
    const char* const card = text.data() + at;
    std::uint64_t ends = field_ends(card);
    std::uint64_t bad = 0;
    std::array<const char*, 5> end{};
    for (const char*& one : end) {
        bad |= static_cast<std::uint64_t>(ends == 0);
        one = card + std::countr_zero(ends);
        ends &= ends - 1;
    }
    if (bad != 0) return {};
    const char* const next = end[4] + 1;
    bad |= static_cast<std::uint64_t>(end[0] == card) | static_cast<std::uint64_t>(*card == ' ');
    bad |= static_cast<std::uint64_t>(end[1] != end[0] + 1) | static_cast<std::uint64_t>(next[-1] != '\n');
    grid.id = digits_between(card, end[0], bad);
    const char* const last = end[4][-1] == '\r' ? end[4] - 1 : end[4];
    const std::array<TextField, 3> fields{{{end[1] + 1, end[2]}, {end[2] + 1, end[3]}, {end[3] + 1, last}}};
    if (bad != 0 || grid.id == 0 || !starts_card(*next)) return {};
    if (!three_reals_between(fields, grid.place.data())) return {};
    grid.place_system = grid.value_system = kBlankField;
    return static_cast<std::size_t>(next - text.data());
}

/// A small card without systems, with three plain coordinates, which the line ends with.
std::optional<std::size_t> read_shortest_small_grid(std::string_view text, std::size_t at, BulkGrid& grid) {
    constexpr std::size_t kEnd = 6 * kSmallColumn;
    const char* const card = text.data() + at;
    const char* const end = card + kEnd + (card[kEnd] == '\r' ? 1 : 0);
    std::uint64_t bad =
        static_cast<std::uint64_t>(*end ^ '\n') | (load8(card + 2 * kSmallColumn) ^ 0x2020202020202020);
    grid.id = eight_columns(load8(card + kSmallColumn), bad);
    if (bad != 0 || grid.id == 0 || !starts_card(end[1])) return {};
    const std::array<TextField, 3> fields{
        {{card + 24, card + 32}, {card + 32, card + 40}, {card + 40, card + 48}}};
    if (!three_reals_between(fields, grid.place.data())) return {};
    grid.place_system = grid.value_system = kBlankField;
    return static_cast<std::size_t>(end + 1 - text.data());
}

std::optional<std::size_t> read_free_grid(std::string_view text, std::size_t at, BulkGrid& grid) {
    if (const auto next = read_shortest_grid(text, at, grid)) return next;
    const char* const end = text.data() + text.size();
    const char* p = text.data() + at;
    if (static_cast<std::size_t>(end - p) < 6 * kNumberRoom) return {};
    const auto take_comma = [&] {
        p = skip_blanks(p);
        return *p++ == ',';
    };
    p = skip_blanks(p);
    if (!take_digits(p, grid.id) || !take_comma()) return {};
    p = skip_blanks(p);
    grid.place_system = kBlankField;
    if (*p != ',' && !take_digits(p, grid.place_system)) return {};
    for (double& x : grid.place) {
        if (!take_comma() || end - p < kNumberRoom) return {};
        p = skip_blanks(p);
        if (!take_real(p, x)) return {};
    }
    p = skip_blanks(p);
    grid.value_system = kBlankField;
    if (*p == ',') {
        p = skip_blanks(p + 1);
        if (*p != '\n' && *p != '\r' && *p != ',' && !take_digits(p, grid.value_system)) return {};
        p = skip_blanks(p);
    }
    p += *p == '\r' ? 1 : 0;
    if (grid.id <= 0 || *p++ != '\n' || !starts_card(*p)) return {};
    return static_cast<std::size_t>(p - text.data());
}

/// Three coordinates and the system of values: on one line, or the third coordinate on another.
template <class Word>
std::optional<std::size_t> read_fixed_grid(std::string_view text, CardLine line, BulkGrid& grid) {
    constexpr std::size_t kWidth = sizeof(Word);
    const char* const end = text.data() + text.size();
    std::size_t column = kSmallColumn;
    const auto number = [&](std::int64_t& out) {
        const bool is_plain =
            fixed_integer<Word>(line.first + column, width_at(line, column, kWidth), kBlankField, out);
        column += kWidth;
        return is_plain;
    };
    if (!number(grid.id) || grid.id <= 0 || !number(grid.place_system)) return {};
    for (std::size_t i = 0; i < 3; ++i) {
        if (column >= kMarkColumn) {
            const auto further = card_line_from(line.next, end);
            if (!is_harmless(line, kMarkColumn) || !further || !goes_on_fixed<Word>(line, *further))
                return {};
            line = *further;
            column = kSmallColumn;
        }
        if (!fixed_real<Word>(line.first + column, width_at(line, column, kWidth), grid.place[i])) return {};
        column += kWidth;
    }
    if (!number(grid.value_system) || !is_blank_from(line, column) || !starts_card(*line.next)) return {};
    return static_cast<std::size_t>(line.next - text.data());
}

}  // namespace

std::optional<std::size_t> read_plain_grid(std::string_view text, std::size_t at, BulkGrid& grid) {
    constexpr std::size_t kName = 4;
    const char* const first = text.data() + at;
    if (text.size() - at < kLongestLine + kRoomBehind || std::memcmp(first, "GRID", kName) != 0) return {};
    if (first[kName] == ',') return read_free_grid(text, at + kName + 1, grid);
    const bool is_large = std::memcmp(first + kName, "*   ", 4) == 0;
    if (!is_large && std::memcmp(first + kName, "    ", 4) != 0) return {};
    if (!is_large) {
        if (const auto next = read_shortest_small_grid(text, at, grid)) return next;
    }
    const auto line = card_line_from(first, text.data() + text.size());
    if (!line) return {};
    return is_large ? read_fixed_grid<SixteenBytes>(text, *line, grid)
                    : read_fixed_grid<std::uint64_t>(text, *line, grid);
}

}  // namespace feelem::nastran
