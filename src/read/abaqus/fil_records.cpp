// SPDX-License-Identifier: Apache-2.0
#include "read/abaqus/fil_records.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

namespace feelem::fil {
namespace {

constexpr std::size_t kBlockWords = 512;
constexpr std::size_t kBlockBytes = kBlockWords * 8;
constexpr std::size_t kLine = 80;
constexpr std::int64_t kMostWords = 1 << 16;

std::uint64_t swapped(std::uint64_t bits) {
    std::uint64_t out = 0;
    for (int i = 0; i < 8; ++i) out = (out << 8) | ((bits >> (8 * i)) & 0xFF);
    return out;
}

std::uint32_t mark_at(const Input& input, std::size_t offset, bool big) {
    std::uint32_t mark = 0;
    if (offset + 4 > input.size()) return 0;
    std::memcpy(&mark, input.bytes().data() + offset, 4);
    return big ? static_cast<std::uint32_t>(swapped(mark) >> 32) : mark;
}

/// The double, but where rounding it to float would round a second time the wrong way, that float.
std::optional<double> real_of(std::string_view text) {
    const auto value = parse_double(text);
    if (!value) return {};
    if ((std::bit_cast<std::uint64_t>(*value) & 0x1FFFFFFF) != 0x10000000) return value;
    const auto single = parse_float(text);
    return single ? std::optional<double>(static_cast<double>(*single)) : value;
}

}  // namespace

Coding coding_of(const Input& input) {
    const std::string_view text = input.text();
    for (const bool big : {false, true}) {
        const Coding coding = big ? Coding::Big : Coding::Little;
        if (mark_at(input, 0, big) != kBlockBytes || mark_at(input, 4 + kBlockBytes, big) != kBlockBytes)
            continue;
        Record record;
        RecordReader reader(input, coding);
        if (reader.next(record) && (record.key == 1921 || record.key == 1900 || record.key == 1922))
            return coding;
    }
    if (!text.starts_with("*I ")) return Coding::None;
    Record record;
    RecordReader reader(input, Coding::Ascii);
    return reader.next(record) ? Coding::Ascii : Coding::None;
}

Word Word::integer(std::int64_t value) {
    Word out;
    out.bits_ = static_cast<std::uint64_t>(value);
    return out;
}
Word Word::real(double value) {
    Word out;
    out.bits_ = std::bit_cast<std::uint64_t>(value);
    out.kind_ = Kind::Real;
    return out;
}
Word Word::text(const std::array<char, 8>& letters) {
    Word out;
    std::memcpy(&out.bits_, letters.data(), 8);
    out.kind_ = Kind::Text;
    return out;
}
Word Word::binary(std::uint64_t bits, Coding coding) {
    Word out;
    out.bits_ = bits;
    out.kind_ = coding == Coding::Big ? Kind::Big : Kind::Little;
    return out;
}

std::int64_t Word::as_integer() const {
    switch (kind_) {
    case Kind::Integer: return static_cast<std::int64_t>(bits_);
    case Kind::Real: {
        const double value = std::bit_cast<double>(bits_);
        return std::abs(value) < 9e15 ? static_cast<std::int64_t>(value) : 0;
    }
    case Kind::Text: return parse_integer(as_text()).value_or(0);
    case Kind::Little: return static_cast<std::int32_t>(bits_ & 0xFFFFFFFF);
    case Kind::Big: return static_cast<std::int32_t>(swapped(bits_) >> 32);
    }
    return 0;
}

double Word::as_real() const {
    switch (kind_) {
    case Kind::Integer: return static_cast<double>(as_integer());
    case Kind::Text: return std::nan("");
    case Kind::Big: return std::bit_cast<double>(swapped(bits_));
    case Kind::Real:
    case Kind::Little: break;
    }
    return std::bit_cast<double>(bits_);
}

std::string Word::as_text() const {
    std::string out(8, ' ');
    std::memcpy(out.data(), &bits_, 8);
    return out;
}

RecordReader::RecordReader(const Input& input, Coding coding, std::size_t position)
    : input_(&input), coding_(coding), position_(position) {
    if (coding != Coding::Ascii || position == 0) return;
    const std::size_t end_of_line = input.text().rfind('\n', position - 1);
    column_ = end_of_line == std::string_view::npos ? position : position - end_of_line - 1;
}

bool RecordReader::next(Record& record) {
    record.words.clear();
    if (broken_) return false;
    return coding_ == Coding::Ascii ? next_ascii(record) : next_binary(record);
}

std::string RecordReader::where() const {
    if (coding_ == Coding::Ascii) return input_->where_line(std::min(position_, input_->size()));
    const std::size_t block = position_ / kBlockWords;
    return input_->where_byte(block * (kBlockBytes + 8) + 4 + position_ % kBlockWords * 8);
}

/// One letter of the lines, which are 80 long even where blanks at their ends were lost.
bool RecordReader::letter(char& out) {
    const std::string_view text = input_->text();
    for (;;) {
        if (position_ >= text.size()) return false;
        const char c = text[position_];
        if (c == '\r') {
            ++position_;
        } else if (c == '\n') {
            if (column_ > 0 && column_ < kLine) {
                ++column_;
                out = ' ';
                return true;
            }
            ++position_;
            column_ = 0;
        } else {
            ++position_;
            ++column_;
            out = c;
            return true;
        }
    }
}

bool RecordReader::number_item(int width, std::int64_t& value) {
    std::array<char, 32> digits{};
    if (width < 1 || width > 20) return false;
    for (int i = 0; i < width; ++i) {
        if (!letter(digits[static_cast<std::size_t>(i)])) return false;
    }
    const auto number = parse_integer({digits.data(), static_cast<std::size_t>(width)});
    value = number.value_or(0);
    return number.has_value();
}

bool RecordReader::item(Word& word) {
    char kind = 0;
    if (!letter(kind)) return false;
    std::array<char, 22> text{};
    if (kind == 'I') {
        std::int64_t width = 0, value = 0;
        if (!number_item(2, width) || !number_item(static_cast<int>(width), value)) return false;
        word = Word::integer(value);
        return true;
    }
    if (kind == 'A') {
        std::array<char, 8> letters{};
        for (char& c : letters) {
            if (!letter(c)) return false;
        }
        word = Word::text(letters);
        return true;
    }
    if (kind != 'D' && kind != 'E') return false;
    for (char& c : text) {
        if (!letter(c)) return false;
    }
    const auto value = real_of({text.data(), text.size()});
    word = Word::real(value.value_or(0));
    return value.has_value();
}

bool RecordReader::next_ascii(Record& record) {
    char c = ' ';
    const std::string_view text = input_->text();
    // Blanks fill the lines behind an increment.
    while (c != '*') {
        if (position_ >= text.size()) return false;
        if (!letter(c)) return false;
        if (c != '*' && c != ' ' && c != '\0') {
            broken_ = true;
            return false;
        }
    }
    Word length, key;
    broken_ = true;
    if (!item(length) || !item(key)) return false;
    const std::int64_t count = length.as_integer() - 2;
    record.key = key.as_integer();
    if (count < 0 || count > kMostWords) return false;
    for (std::int64_t i = 0; i < count; ++i) {
        Word word;
        // The last record of an increment counts the blanks behind it in some versions.
        if (record.key == 2001) break;
        if (!item(word)) return false;
        record.words.push_back(word);
    }
    broken_ = false;
    return true;
}

bool RecordReader::word(std::size_t index, std::uint64_t& bits) const {
    const std::size_t block = index / kBlockWords * (kBlockBytes + 8);
    const std::size_t offset = block + 4 + index % kBlockWords * 8;
    if (offset + 8 > input_->size() || mark_at(*input_, block, coding_ == Coding::Big) != kBlockBytes)
        return false;
    std::memcpy(&bits, input_->bytes().data() + offset, 8);
    return true;
}

bool RecordReader::next_binary(Record& record) {
    std::uint64_t bits = 0;
    std::int64_t length = 0;
    // Zeros fill the last block of an increment.
    while (length == 0) {
        if (!word(position_, bits)) return false;
        length = Word::binary(bits, coding_).as_integer();
        if (length == 0) ++position_;
    }
    broken_ = true;
    if (length < 2 || length > kMostWords || !word(position_ + 1, bits)) return false;
    record.key = Word::binary(bits, coding_).as_integer();
    const auto count = static_cast<std::size_t>(length);
    for (std::size_t i = 2; i < count && record.key != 2001; ++i) {
        if (!word(position_ + i, bits)) return false;
        record.words.push_back(Word::binary(bits, coding_));
    }
    position_ += count;
    broken_ = false;
    return true;
}

}  // namespace feelem::fil
