// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/plain_cards.hpp"

#include "read/nastran/plain_lines.hpp"

#include <algorithm>
#include <cstring>

namespace feelem::nastran {
namespace {

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

}  // namespace feelem::nastran
