// SPDX-License-Identifier: Apache-2.0
#include "read_nastran_op2/op2_writer.hpp"

#include <algorithm>
#include <bit>

namespace feelem::test {

std::string Op2Writer::number(std::uint64_t bits, int size) const {
    std::string out;
    for (int i = 0; i < size; ++i) {
        const int byte = form_.big_endian ? size - 1 - i : i;
        out += static_cast<char>(bits >> (8 * byte) & 0xFF);
    }
    return out;
}

std::string Op2Writer::bytes_of(const Op2Word& word) const {
    if (const auto* integer = std::get_if<std::int64_t>(&word))
        return number(static_cast<std::uint64_t>(*integer), form_.word);
    if (const auto* real = std::get_if<double>(&word)) {
        if (form_.word == 8) return number(std::bit_cast<std::uint64_t>(*real), 8);
        return number(std::bit_cast<std::uint32_t>(static_cast<float>(*real)), 4);
    }
    if (const auto* wide = std::get_if<WideReal>(&word))
        return number(std::bit_cast<std::uint64_t>(wide->value), 8);
    std::string text = std::get<std::string>(word);
    text.resize(4, ' ');
    if (form_.word == 8) text += "    ";
    return text;
}

std::string Op2Writer::bytes_of(const Op2Words& words) const {
    std::string out;
    for (const Op2Word& word : words) out += bytes_of(word);
    return out;
}

void Op2Writer::fortran(const std::string& bytes) {
    const std::string mark = number(bytes.size(), 4);
    out_ += mark + bytes + mark;
}

void Op2Writer::key(std::int64_t value) {
    fortran(bytes_of(Op2Word{value}));
}

void Op2Writer::head(std::string_view version) {
    key(3);
    fortran(bytes_of(Op2Words{std::int64_t{11}, std::int64_t{22}, std::int64_t{26}}));
    key(7);
    fortran(bytes_of(text_words("NASTRAN FORT TAPE ID CODE - ", 7)));
    key(2);
    fortran(bytes_of(text_words(version, 2)));
    key(-1);
    key(0);
}

void Op2Writer::begin_table(std::string_view name) {
    key(2);
    fortran(bytes_of(text_words(name, 2)));
    key(-1);
    key(7);
    fortran(bytes_of(Op2Words(7, std::int64_t{0})));
    key(-2);
    next_end_ = -3;
    record(text_words(name, 2));
}

void Op2Writer::record(const Op2Words& words, std::size_t piece) {
    key(1);
    key(0);  // A record of one word: rows of a table.
    for (std::size_t at = 0; at < words.size(); at += piece) {
        const auto first = words.begin() + static_cast<std::ptrdiff_t>(at);
        const auto last = words.begin() + static_cast<std::ptrdiff_t>(std::min(at + piece, words.size()));
        const std::string bytes = bytes_of(Op2Words(first, last));
        key(static_cast<std::int64_t>(bytes.size()) / form_.word);
        fortran(bytes);
    }
    key(next_end_--);
}

void Op2Writer::matrix_column(const Op2Words& words) {
    key(1);
    key(1);
    key(static_cast<std::int64_t>(words.size()));
    fortran(bytes_of(std::int64_t{1}) + bytes_of(words));  // The row comes first and is not counted.
    key(next_end_--);
}

void Op2Writer::block(const Op2Ident& ident, const Op2Words& data, std::size_t piece) {
    Op2Words words(50, std::int64_t{0});
    words[0] = std::int64_t{ident.approach * 10 + 1};
    words[1] = std::int64_t{ident.table_code};
    words[2] = std::int64_t{ident.element_type};
    words[3] = std::int64_t{ident.subcase};
    words[4] = ident.word5;
    words[5] = ident.word6;
    words[8] = std::int64_t{ident.format};
    words[9] = std::int64_t{ident.row_words};
    words[10] = std::int64_t{ident.stress_bits};
    words[22] = std::int64_t{ident.thermal};
    record(joined({words, text_words("A TITLE", 32), text_words("", 32), text_words(ident.label, 32)}));
    record(data, piece);
}

void Op2Writer::end_table() {
    key(1);
    key(0);
    key(0);
}

std::string Op2Writer::finish() const {
    Op2Writer ended = *this;
    ended.key(0);
    return ended.out_;
}

Op2Words text_words(std::string_view text, std::size_t words) {
    Op2Words out;
    for (std::size_t i = 0; i < words; ++i)
        out.emplace_back(std::string(text.substr(std::min(4 * i, text.size()), 4)));
    return out;
}

Op2Words joined(std::initializer_list<Op2Words> lists) {
    Op2Words out;
    for (const Op2Words& list : lists) out.insert(out.end(), list.begin(), list.end());
    return out;
}

}  // namespace feelem::test
