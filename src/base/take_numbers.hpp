// SPDX-License-Identifier: Apache-2.0
// Must: take numbers off the front of text whose fields end at a comma, a blank or a column, fast and never
// wrong.
// Assumes: little-endian (eight_digits.hpp).
// Algorithm: up to eight digits at a time in one register; how many there are is counted, not looked for one
// by one. Digits below 2^53 times or by a power of ten up to 10^22 is one exactly rounded operation
// (Clinger). Data: none. What does not look exactly like that is refused, and the caller takes the general
// way (number.hpp).
#pragma once

#include "base/eight_digits.hpp"
#include "base/nearest_double.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace feelem {

/// So many bytes must be readable from where a number is taken.
inline constexpr std::ptrdiff_t kNumberRoom = 48;

/// Blanks off the front, at most 8.
inline const char* skip_blanks(const char* at) {
    const std::uint64_t others = load8(at) ^ 0x2020202020202020;
    return at + static_cast<unsigned>(std::countr_zero(others)) / 8;
}

/// Up to fifteen digits off the front; moves `at` behind them. False, and nothing moved: there is none, or
/// more.
inline bool take_digits(const char*& at, std::int64_t& out) {
    std::uint64_t word = load8(at);
    unsigned count = count_digits(word);
    if (count == 0) return false;
    std::uint64_t value = value_of_digits(word, count);
    const char* p = at + count;
    if (count == 8) {
        word = load8(p);
        count = count_digits(word);
        if (count == 8) return false;
        value = value * kWholePowersOfTen[count] + value_of_digits(word, count);
        p += count;
    }
    at = p;
    out = static_cast<std::int64_t>(value);
    return true;
}

/// Blanks, then digits up to where a field of known columns ends, at most eight; bits are set in `bad` when
/// it is anything else. Eight bytes before `last` must be readable, though they be another field's.
inline std::uint32_t digits_between(const char* first, const char* last, std::uint64_t& bad) {
    const auto width = static_cast<std::size_t>(last - first);
    std::uint64_t word = load8(last - 8);
    if (width < 8) {
        const std::uint64_t before = ~std::uint64_t{0} >> (8 * width);
        word = (word & ~before) | (0x2020202020202020 & before);
    }
    for (const char* p = first; p < last - 8; ++p) bad |= static_cast<std::uint64_t>(*p ^ ' ');
    return eight_columns(word, bad);
}

/// E+05 e-5 D+02 +5 -101 (Fortran's without a letter): moves `at` behind it. Where there is none `out` stays.
inline bool take_exponent(const char*& at, int& out) {
    const char letter = *at;
    const bool has_letter = letter == 'E' || letter == 'e' || letter == 'D' || letter == 'd';
    if (!has_letter && letter != '+' && letter != '-') return true;
    const char* p = at + (has_letter ? 1 : 0);
    const bool shrinks = *p == '-';
    p += *p == '-' || *p == '+' ? 1 : 0;
    int value = 0;
    const char* const first = p;
    while (*p >= '0' && *p <= '9' && p - first < 4) value = 10 * value + (*p++ - '0');
    if (p == first || p - first > 3) return false;
    out = shrinks ? -value : value;
    at = p;
    return true;
}

/// -12.345, 12, .5, 1.E+3, 1.5-3 off the front; moves `at` behind it. What follows must end the field: the
/// caller looks. kNumberRoom bytes must be readable, and among them one that ends the number.
inline bool take_real(const char*& at, double& out) {
    const char* p = at;
    const bool negative = *p == '-';
    p += negative ? 1 : 0;
    std::uint64_t word = load8(p);
    unsigned count = count_digits(word);
    if (count == 8) return false;
    std::uint64_t digits = value_of_digits(word, count);
    p += count;
    unsigned all = count;
    int exponent = 0;
    if (*p == '.') {
        ++p;
        for (int piece = 0; piece < 3; ++piece) {
            word = load8(p);
            count = count_digits(word);
            digits = digits * kWholePowersOfTen[count] + value_of_digits(word, count);
            p += count;
            all += count;
            exponent -= static_cast<int>(count);
            if (count < 8) break;
            if (piece == 2) return false;
        }
    }
    if (all == 0 || all > 19) return false;
    int written = 0;
    if (!take_exponent(p, written)) return false;
    const int scale = exponent + written;
    if (!scale_exactly(digits, scale, negative, out) && !nearest_double(digits, scale, negative, out))
        return false;
    at = p;
    return true;
}

/// A field of fixed width as one number: its first character lies in the lowest byte.
template <class Word>
Word load_field(const char* at) {
    Word word = load8(at);
    if constexpr (sizeof(Word) == 16) word |= static_cast<Word>(load8(at + 8)) << 64;
    return word;
}

__extension__ using SixteenBytes = unsigned __int128;

/// Takes characters off the front of a field that lies in a register.
template <class Word>
class FieldCursor {
public:
    explicit FieldCursor(const char* at) : word_(load_field<Word>(at)) {}

    char front() const { return static_cast<char>(static_cast<std::uint64_t>(word_) & 0xFF); }
    void skip(unsigned count) { word_ = count >= sizeof(Word) ? 0 : word_ >> (8 * count); }
    void skip_blanks() {
        for (;;) {
            const std::uint64_t others = low() ^ 0x2020202020202020;
            const unsigned count = static_cast<unsigned>(std::countr_zero(others)) / 8;
            skip(count);
            if (count < 8 || sizeof(Word) == 8) return;
        }
    }
    /// Digits off the front, at most 8; how many.
    unsigned take_digits(std::uint64_t& value) {
        const unsigned count = count_digits(low());
        value = value * kWholePowersOfTen[count] + value_of_digits(low(), count);
        skip(count);
        return count;
    }
    /// Nothing but blanks is left.
    bool at_end() const {
        constexpr std::uint64_t kBlanks = 0x2020202020202020;
        const auto is_blank = [](std::uint64_t part) { return (part & ~kBlanks) == 0; };
        if constexpr (sizeof(Word) == 16) {
            return is_blank(low()) && is_blank(static_cast<std::uint64_t>(word_ >> 64));
        }
        return is_blank(low());
    }
    /// The field is no more than its first `width` characters.
    void cut(std::size_t width) {
        if (width < sizeof(Word)) word_ &= (Word{1} << (8 * width)) - 1;
    }

private:
    std::uint64_t low() const { return static_cast<std::uint64_t>(word_); }

    Word word_;
};

/// A field of 8 or 16 columns that holds digits between blanks, or blanks alone (then `blank`). False:
/// something else. Beyond `width`, the columns that the line has, nothing counts, but all are read.
template <class Word>
bool fixed_integer(const char* at, std::size_t width, std::int64_t blank, std::int64_t& out) {
    // Digits to the end of the field first: nearly all are written so.
    if (width == sizeof(Word)) {
        std::uint64_t bad = sizeof(Word) == 16 ? load8(at) ^ 0x2020202020202020 : 0;
        out = eight_columns(load8(at + sizeof(Word) - 8), bad);
        if (bad == 0) return true;
    }
    FieldCursor<Word> field(at);
    field.cut(width);
    field.skip_blanks();
    std::uint64_t value = 0;
    const unsigned first = field.take_digits(value);
    if (first == 8) field.take_digits(value);
    out = first == 0 ? blank : static_cast<std::int64_t>(value);
    return field.at_end();
}

/// The same for a real: -1.5 .5 1.5E-3 1.5-3. Blanks alone are refused.
template <class Word>
bool fixed_real(const char* at, std::size_t width, double& out) {
    FieldCursor<Word> field(at);
    field.cut(width);
    field.skip_blanks();
    const bool negative = field.front() == '-';
    field.skip(negative ? 1 : 0);
    std::uint64_t digits = 0;
    unsigned all = field.take_digits(digits);
    if (all == 8) return false;
    int exponent = 0;
    if (field.front() == '.') {
        field.skip(1);
        unsigned count = field.take_digits(digits);
        exponent -= static_cast<int>(count);
        all += count;
        if (count == 8) {
            count = field.take_digits(digits);
            exponent -= static_cast<int>(count);
            all += count;
        }
    }
    if (all == 0) return false;
    if (!field.at_end()) {
        const char letter = field.front();
        const bool has_letter = letter == 'E' || letter == 'e' || letter == 'D' || letter == 'd';
        field.skip(has_letter ? 1 : 0);
        const char sign = field.front();
        if (!has_letter && sign != '+' && sign != '-') return false;
        field.skip(sign == '+' || sign == '-' ? 1 : 0);
        std::uint64_t written = 0;
        const unsigned count = field.take_digits(written);
        if (count == 0 || count > 3 || !field.at_end()) return false;
        exponent += sign == '-' ? -static_cast<int>(written) : static_cast<int>(written);
    }
    return scale_exactly(digits, exponent, negative, out);
}

}  // namespace feelem
