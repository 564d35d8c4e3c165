// SPDX-License-Identifier: Apache-2.0
// The records of an Abaqus results file (.fil), ASCII and binary: a key and words, whatever the coding.
#pragma once

#include "base/input.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace feelem::fil {

enum class Coding : std::uint8_t {
    Ascii,
    Little,  ///< Fortran records of 512 words of 8 bytes, little-endian.
    Big,
    None,  ///< No results file.
};
/// By the first bytes.
Coding coding_of(const Input& input);

/// Eight bytes that are an integer, a real or eight letters: who reads them knows which.
class Word {
public:
    static Word integer(std::int64_t value);
    static Word real(double value);
    static Word text(const std::array<char, 8>& letters);
    static Word binary(std::uint64_t bits, Coding coding);

    std::int64_t as_integer() const;
    double as_real() const;
    std::string as_text() const;  ///< All eight.

private:
    enum class Kind : std::uint8_t {
        Integer,
        Real,
        Text,
        Little,
        Big
    };
    std::uint64_t bits_ = 0;  ///< Of a Text word the letters, first in the lowest byte.
    Kind kind_ = Kind::Integer;
};

struct Record {
    std::int64_t key = 0;
    std::vector<Word> words;  ///< Attributes: without length and key.
};

/// Goes through a file. `position` is a place to come back to.
class RecordReader {
public:
    RecordReader(const Input& input, Coding coding, std::size_t position = 0);

    /// False at the end of the file, or where it is damaged (then broken() is true).
    bool next(Record& record);
    std::size_t position() const noexcept { return position_; }
    bool broken() const noexcept { return broken_; }
    std::string where() const;

private:
    bool next_ascii(Record& record);
    bool next_binary(Record& record);
    bool letter(char& out);
    bool item(Word& word);
    bool number_item(int width, std::int64_t& value);
    bool word(std::size_t index, std::uint64_t& bits) const;

    const Input* input_;
    Coding coding_;
    std::size_t position_ = 0;  ///< ASCII: byte; binary: word.
    std::size_t column_ = 0;    ///< ASCII: in a line of 80.
    bool broken_ = false;
};

}  // namespace feelem::fil
