// SPDX-License-Identifier: Apache-2.0
#include "read_abaqus/fil_text.hpp"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>

namespace feelem::test {
namespace {

std::string padded(std::string text, std::size_t width) {
    text.resize(width, ' ');
    return text;
}

std::string ascii_item(const FilWord& word) {
    if (const int* number = std::get_if<int>(&word)) {
        const std::string digits = std::to_string(*number);
        char head[8];
        std::snprintf(head, sizeof head, "I%2d", static_cast<int>(digits.size()));
        return head + digits;
    }
    if (const double* real = std::get_if<double>(&word)) {
        char text[32];
        std::snprintf(text, sizeof text, "% .15E", *real);
        std::string out(text);
        out[out.find('E')] = 'D';
        return "D" + out;
    }
    return "A" + padded(std::get<std::string>(word), 8);
}

std::uint64_t binary_word(const FilWord& word, bool big_endian) {
    std::uint64_t bits = 0;
    if (const int* number = std::get_if<int>(&word)) {
        auto raw = static_cast<std::uint32_t>(*number);
        if (big_endian) raw = __builtin_bswap32(raw);
        std::memcpy(&bits, &raw, 4);
    } else if (const double* real = std::get_if<double>(&word)) {
        bits = std::bit_cast<std::uint64_t>(*real);
        if (big_endian) bits = __builtin_bswap64(bits);
    } else {
        const std::string text = padded(std::get<std::string>(word), 8);
        std::memcpy(&bits, text.data(), 8);
    }
    return bits;
}

}  // namespace

std::string ascii_fil(const std::vector<FilRecord>& records) {
    std::string stream;
    for (const FilRecord& record : records) {
        stream += "*" + ascii_item(static_cast<int>(record.words.size()) + 2) + ascii_item(record.key);
        for (const FilWord& word : record.words) stream += ascii_item(word);
        if (record.key == 2001) stream.resize((stream.size() + 79) / 80 * 80 + 80, ' ');
    }
    std::string out;
    for (std::size_t at = 0; at < stream.size(); at += 80) out += stream.substr(at, 80) + "\n";
    return out;
}

std::string binary_fil(const std::vector<FilRecord>& records, bool big_endian) {
    std::vector<std::uint64_t> words;
    for (const FilRecord& record : records) {
        std::size_t length = record.words.size() + 2;
        if (record.key == 2001) length += (512 - (words.size() + length) % 512) % 512;
        const std::size_t end = words.size() + length;
        words.push_back(binary_word(static_cast<int>(length), big_endian));
        words.push_back(binary_word(record.key, big_endian));
        for (const FilWord& word : record.words) words.push_back(binary_word(word, big_endian));
        words.resize(end, 0);
    }
    words.resize((words.size() + 511) / 512 * 512, 0);
    std::uint32_t mark = 4096;
    if (big_endian) mark = __builtin_bswap32(mark);
    std::string out;
    for (std::size_t at = 0; at < words.size(); at += 512) {
        out.append(reinterpret_cast<const char*>(&mark), 4);
        out.append(reinterpret_cast<const char*>(&words[at]), 4096);
        out.append(reinterpret_cast<const char*>(&mark), 4);
    }
    return out;
}

}  // namespace feelem::test
