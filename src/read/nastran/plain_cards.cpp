// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/plain_cards.hpp"

#include "base/columns.hpp"
#include "base/number.hpp"
#include "base/take_numbers.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace feelem::nastran {
namespace {

constexpr std::size_t kSmallColumn = 8;
constexpr std::size_t kMarkColumn = 72;
constexpr std::size_t kLongestLine = 80;
/// Bytes that may be looked at behind a line's end.
constexpr std::size_t kRoomBehind = 64;

bool starts_card(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// A line of a card without its end.
struct CardLine {
    const char* first = nullptr;
    std::size_t length = 0;
    const char* next = nullptr;  ///< The line behind it.
};

/// Lengths that lines of meshes nearly always have: two fields or a large one, a GRID with three coordinates,
/// eight fields and a mark. In ascending order, so that a longer line is not found across a shorter one.
constexpr std::array<std::size_t, 3> kUsualLengths{24, 48, 73};

/// Empty near the end of the text, where columns cannot be looked at eight at a time. A line that ends at a
/// usual length is not searched: callers look at every column, and refuse a line end among them.
std::optional<CardLine> card_line_from(const char* first, const char* end) {
    if (static_cast<std::size_t>(end - first) < kLongestLine + kRoomBehind) return {};
    for (const std::size_t length : kUsualLengths) {
        if (first[length] == '\n' && first[length - 1] != '\r')
            return CardLine{first, length, first + length + 1};
    }
    const void* found = std::memchr(first, '\n', kLongestLine + 2);
    if (found == nullptr) return {};
    const char* last = static_cast<const char*>(found);
    CardLine line{first, static_cast<std::size_t>(last - first), last + 1};
    if (line.length > 0 && last[-1] == '\r') --line.length;
    return line;
}

/// Whether columns from `first` on are blank.
bool is_blank_from(const CardLine& line, std::size_t first) {
    for (std::size_t i = first; i < line.length; ++i) {
        if (line.first[i] != ' ') return false;
    }
    return true;
}

/// Whether columns could be fields or marks that are not wanted: nothing that makes the line another.
bool is_harmless(const CardLine& line, std::size_t first, std::size_t last = kLongestLine + 2) {
    unsigned odd = 0;  // Without branches, so that many columns are tested at once.
    for (std::size_t i = first; i < std::min(line.length, last); ++i) {
        const char c = line.first[i];
        odd |= static_cast<unsigned>(c == ',') | static_cast<unsigned>(c == '$') |
               static_cast<unsigned>(c < ' ');
    }
    return odd == 0;
}

/// How many of a field's columns the line has.
std::size_t width_at(const CardLine& line, std::size_t first, std::size_t width) {
    return line.length <= first ? 0 : std::min(width, line.length - first);
}

/// What tells one continuation from another: a mark without its first character.
std::string_view tag_of_mark(std::string_view mark) {
    mark = trim(mark);
    return mark.empty() ? mark : mark.substr(1);
}

bool tags_agree(std::string_view mark, std::string_view first_field) {
    if (mark.size() <= 1 || first_field.size() <= 1) return true;
    const std::string_view before = tag_of_mark(mark), after = tag_of_mark(first_field);
    return before.empty() || after.empty() || before == after;
}

std::string_view mark_of(const CardLine& line) {
    const std::size_t width = width_at(line, kMarkColumn, kSmallColumn);
    return width == 0 ? std::string_view{} : std::string_view(line.first + kMarkColumn, width);
}

/// Whether a fixed line goes on with the card: by a mark, or by eight blanks where fields are small.
template <class Word>
bool goes_on_fixed(const CardLine& before, const CardLine& line) {
    if (line.length <= kSmallColumn) return false;
    const char first = line.first[0];
    if (first == (sizeof(Word) == kSmallColumn ? '+' : '*'))
        return is_harmless(line, 0, kSmallColumn) && tags_agree(mark_of(before), {line.first, kSmallColumn});
    return first == ' ' && load8(line.first) == 0x2020202020202020 && !is_blank_from(line, kSmallColumn);
}

template <class Word>
std::optional<std::size_t> end_of_fixed_card(std::string_view text, CardLine line) {
    const char* const end = text.data() + text.size();
    while (!starts_card(*line.next)) {
        const auto further = card_line_from(line.next, end);
        if (!further || !goes_on_fixed<Word>(line, *further) || !is_harmless(*further, kSmallColumn))
            return {};
        line = *further;
    }
    return static_cast<std::size_t>(line.next - text.data());
}

template <class Word>
bool read_fixed_fields(std::string_view text, CardLine line, std::size_t wanted, PlainFields& fields) {
    constexpr std::size_t kWidth = sizeof(Word);
    constexpr std::size_t kPerLine = (kMarkColumn - kSmallColumn) / kWidth;
    const char* const end = text.data() + text.size();
    for (std::size_t base = 0;; base += kPerLine) {
        std::size_t column = kSmallColumn;
        for (std::size_t i = base; i < std::min(wanted, base + kPerLine); ++i, column += kWidth) {
            const std::size_t width = width_at(line, column, kWidth);
            if (width == 0) break;
            if (!fixed_integer<Word>(line.first + column, width, kBlankField, fields.values[i])) return false;
        }
        if (!is_harmless(line, column)) return false;
        if (starts_card(*line.next) || base + kPerLine >= wanted) return true;
        const auto further = card_line_from(line.next, end);
        if (!further || !goes_on_fixed<Word>(line, *further)) return false;
        line = *further;
    }
}

/// Behind the line's end; null where it is too far. Commas of a free card and what it does not want do not
/// matter.
const char* behind_line(const char* at, const char* end) {
    constexpr std::ptrdiff_t kMostColumns = 256;
    const auto room = static_cast<std::size_t>(std::min(end - at, kMostColumns));
    const void* found = std::memchr(at, '\n', room);
    if (found == nullptr || end - static_cast<const char*>(found) < kNumberRoom) return nullptr;
    return static_cast<const char*>(found) + 1;
}

/// How many characters the first field of a free line has that goes on with a card; 0: none, or a mark that
/// must be compared with another.
std::size_t free_continuation(const char* at) {
    if (*at == ',') return 1;
    return at[0] == '+' && at[1] == ',' ? 2 : 0;
}

std::optional<PlainHead> look_over_free_card(std::string_view text, std::size_t at) {
    const char* const end = text.data() + text.size();
    const char* p = skip_blanks(text.data() + at);
    PlainHead head;
    if (!take_digits(p, head.id)) return {};
    p = skip_blanks(p);
    if (*p != ',') return {};
    while ((p = behind_line(p, end)) != nullptr && !starts_card(*p)) {
        if (free_continuation(p) == 0) return {};
    }
    if (p == nullptr) return {};
    head.next = static_cast<std::size_t>(p - text.data());
    return head;
}

bool ends_line(const char* at) {
    return *at == '\n' || (at[0] == '\r' && at[1] == '\n');
}

/// Free fields of one line from `at` on, behind the comma of its first field; moves `at` behind the eighth or
/// to the line's end. False: not plain.
bool take_free_fields(
    const char*& at, const char* end, std::size_t base, std::size_t wanted, PlainFields& fields
) {
    const char* p = at;
    for (std::size_t i = base; i < std::min(base + 8, wanted); ++i) {
        if (end - p < kNumberRoom) return false;
        p = skip_blanks(p);
        if (*p != ',' && !ends_line(p) && !take_digits(p, fields.values[i])) return false;
        p = skip_blanks(p);
        if (ends_line(p)) break;
        if (*p++ != ',') return false;
    }
    at = p;
    return true;
}

bool read_free_fields(std::string_view text, std::size_t at, std::size_t wanted, PlainFields& fields) {
    const char* const end = text.data() + text.size();
    const char* p = text.data() + at;
    for (std::size_t base = 0;; base += 8) {
        if (!take_free_fields(p, end, base, wanted, fields)) return false;
        const char* const next = behind_line(p, end);
        if (next == nullptr) return false;
        // Behind the eighth field stands a mark at most: more fields, and comments, have other rules.
        const std::string_view rest(p, static_cast<std::size_t>(next - p));
        const bool all_taken = base + 8 >= wanted;
        if (rest.find_first_of(all_taken ? "$\t" : "$\t,") != std::string_view::npos) return false;
        if (all_taken || starts_card(*next)) return true;
        const std::size_t mark = free_continuation(next);
        if (mark == 0) return false;
        p = next + mark;
    }
}

#if defined(__SSE2__)

/// Which of 64 characters end a free field.
std::uint64_t ends_of_fields(const char* at) {
    std::uint64_t ends = 0;
    for (unsigned i = 0; i < 4; ++i) {
        const __m128i some = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at + 16 * i));
        const __m128i is_end =
            _mm_or_si128(_mm_cmpeq_epi8(some, _mm_set1_epi8(',')), _mm_cmpeq_epi8(some, _mm_set1_epi8('\n')));
        ends |= static_cast<std::uint64_t>(_mm_movemask_epi8(is_end)) << (16 * i);
    }
    return ends;
}

/// GRID,id,,x,y,z as nearly all of them are: the ends of all fields are found first, so that no number waits
/// for the end of the one before.
std::optional<std::size_t> read_shortest_grid(std::string_view text, std::size_t at, BulkGrid& grid) {
    constexpr std::size_t kLookedAt = 64;
    if (at < 16 || text.size() - at <= kLookedAt) return {};
    const char* const card = text.data() + at;
    std::uint64_t ends = ends_of_fields(card);
    if (std::popcount(ends) < 5) return {};
    std::array<const char*, 5> end{};
    for (const char*& one : end) {
        one = card + std::countr_zero(ends);
        ends &= ends - 1;
    }
    const char* const next = end[4] + 1;
    std::uint64_t bad = static_cast<std::uint64_t>(end[0] == card) | static_cast<std::uint64_t>(*card == ' ');
    bad |= static_cast<std::uint64_t>(end[1] != end[0] + 1) | static_cast<std::uint64_t>(next[-1] != '\n');
    grid.id = digits_between(card, end[0], bad);
    const std::array<TextField, 3> fields{{{end[1] + 1, end[2]}, {end[2] + 1, end[3]}, {end[3] + 1, end[4]}}};
    if (bad != 0 || grid.id == 0 || !starts_card(*next)) return {};
    if (!three_reals_between(fields, grid.place.data())) return {};
    grid.place_system = grid.value_system = kBlankField;
    return static_cast<std::size_t>(next - text.data());
}

#else

std::optional<std::size_t> read_shortest_grid(std::string_view, std::size_t, BulkGrid&) {
    return {};
}

#endif

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
    const auto line = card_line_from(first, text.data() + text.size());
    if (!line) return {};
    return is_large ? read_fixed_grid<SixteenBytes>(text, *line, grid)
                    : read_fixed_grid<std::uint64_t>(text, *line, grid);
}

namespace {

/// How the fields of a card are written; empty when that is not plain.
enum class CardForm : char {
    Free,
    Small,
    Large,
};
std::optional<CardForm> form_of(std::string_view text, std::size_t at, std::size_t name_length) {
    const char* const first = text.data() + at;
    if (text.size() - at < kLongestLine + kRoomBehind || name_length >= kSmallColumn) return {};
    if (first[name_length] == ',') return CardForm::Free;
    const bool is_large = first[name_length] == '*';
    for (std::size_t i = name_length + (is_large ? 1 : 0); i < kSmallColumn; ++i) {
        if (first[i] != ' ') return {};
    }
    return is_large ? CardForm::Large : CardForm::Small;
}

template <class Word>
std::optional<PlainHead> look_over_fixed_card(std::string_view text, const CardLine& line) {
    PlainHead head;
    const std::size_t width = width_at(line, kSmallColumn, sizeof(Word));
    if (!fixed_integer<Word>(line.first + kSmallColumn, width, kBlankField, head.id)) return {};
    if (!is_harmless(line, kSmallColumn + sizeof(Word))) return {};
    const auto next = end_of_fixed_card<Word>(text, line);
    if (!next) return {};
    head.next = *next;
    return head;
}

}  // namespace

std::optional<PlainHead> look_over_plain_card(
    std::string_view text, std::size_t at, std::size_t name_length
) {
    const auto form = form_of(text, at, name_length);
    if (!form) return {};
    if (*form == CardForm::Free) return look_over_free_card(text, at + name_length + 1);
    const auto line = card_line_from(text.data() + at, text.data() + text.size());
    if (!line) return {};
    return *form == CardForm::Large ? look_over_fixed_card<SixteenBytes>(text, *line)
                                    : look_over_fixed_card<std::uint64_t>(text, *line);
}

bool read_plain_fields(
    std::string_view text, std::size_t at, std::size_t name_length, std::size_t wanted, PlainFields& fields
) {
    const auto form = form_of(text, at, name_length);
    if (!form || wanted > PlainFields::kMost) return false;
    std::fill_n(fields.values.begin(), wanted, kBlankField);
    if (*form == CardForm::Free) return read_free_fields(text, at + name_length + 1, wanted, fields);
    const auto line = card_line_from(text.data() + at, text.data() + text.size());
    if (!line) return false;
    return *form == CardForm::Large ? read_fixed_fields<SixteenBytes>(text, *line, wanted, fields)
                                    : read_fixed_fields<std::uint64_t>(text, *line, wanted, fields);
}

bool FreeCards::read(
    std::string_view text, std::size_t at, std::size_t name_length, std::size_t wanted, PlainFields& fields
) {
    if (wanted == wanted_ && !card_.empty() && read_like(text, at, wanted, fields)) return true;
    card_ = {};
    if (!read_plain_fields(text, at, name_length, wanted, fields)) return false;
    remember(text, at, name_length, wanted);
    return true;
}

/// Between numbers stands what stood between those of the card before, name and line ends with it.
bool FreeCards::read_like(std::string_view text, std::size_t at, std::size_t wanted, PlainFields& fields)
    const {
    if (at < kSmallColumn || text.size() - at < card_.size() + kRoomBehind) return false;
    const char* const card = text.data() + at;
    std::fill_n(fields.values.begin(), wanted, kBlankField);
    std::uint64_t bad = 0;
    std::size_t from = 0;
    for (std::size_t k = 0; k < count_; ++k) {
        const Field field = fields_[k];
        for (; from < field.first; ++from) bad |= static_cast<std::uint64_t>(card[from] ^ card_[from]);
        fields.values[index_[k]] = digits_between(card + field.first, card + field.last, bad);
        from = field.last;
    }
    for (; from < card_.size(); ++from) bad |= static_cast<std::uint64_t>(card[from] ^ card_[from]);
    return bad == 0 && starts_card(card[card_.size()]);
}

/// Only a card whose every field is wanted, so that nothing else can stand between numbers.
void FreeCards::remember(std::string_view text, std::size_t at, std::size_t name_length, std::size_t wanted) {
    constexpr std::size_t kLongest = 400;
    const char* const card = text.data() + at;
    if (card[name_length] != ',') return;
    const auto head = look_over_plain_card(text, at, name_length);
    if (!head || head->next - at > kLongest) return;
    const std::string_view all(card, head->next - at);
    count_ = 0;
    std::size_t field = 0;
    std::size_t in_line = 0;
    for (std::size_t i = name_length + 1; i < all.size(); ++i) {
        const bool is_digit = all[i] >= '0' && all[i] <= '9';
        if (is_digit) {
            const std::size_t first = i;
            while (all[i] >= '0' && all[i] <= '9') ++i;
            if (field >= wanted || in_line >= 8 || i - first > 8) return;
            fields_[count_] = {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(i)};
            index_[count_++] = static_cast<std::uint8_t>(field);
        }
        if (all[i] == ',') {
            if (in_line < 8) ++field, ++in_line;
        } else if (all[i] == '\n') {
            // To the first field of the next line, whose comma stands behind its mark.
            field += 8 - in_line;
            in_line = 0;
            if (all[i + 1 < all.size() ? i + 1 : i] == '+') ++i;
            ++i;
        } else if (all[i] != '+' && all[i] != '\r') {
            return;
        }
    }
    card_ = all;
    wanted_ = wanted;
}

}  // namespace feelem::nastran
