// SPDX-License-Identifier: Apache-2.0
// The sections of a .msh file, and numbers from them in either coding.
#pragma once

#include "base/byte_reader.hpp"
#include "base/input.hpp"
#include "base/number.hpp"
#include "base/take_numbers.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::gmsh {

/// What $MeshFormat says.
struct Coding {
    int version = 22;  ///< 20 to 22, 40, 41
    bool binary = false;
    bool swap = false;
};

struct Section {
    std::string name;  ///< "Nodes"
    std::size_t first = 0, last = 0;
};

struct Layout {
    Coding coding;
    std::vector<Section> sections;  ///< In file order, without MeshFormat.
};

/// Throws Error when the file is not whole or of a version that is not read.
Layout find_sections(const Input& input, Diagnostics& diagnostics);

/// Walks the numbers of [first, last); each read throws Error where there is none.
class Numbers {
public:
    Numbers(const Input& input, const Coding& coding, std::size_t first, std::size_t last)
        : input_(&input), text_(input.text().data()), coding_(coding), at_(first), last_(last) {}

    std::int64_t integer() { return coding_.binary ? bytes<std::int32_t>() : text_integer(); }
    /// Counts and tags of version 4.1: eight bytes.
    std::int64_t size() { return coding_.binary ? bytes<std::int64_t>() : text_integer(); }
    double real() {
        if (coding_.binary) return bytes<double>();
        double plain = 0;
        if (const char* const first = plain_word(); first != nullptr) {
            const char* at = first;
            if (take_real(at, plain) && ends_word(*at)) {
                at_ = static_cast<std::size_t>(at - text_);
                return plain;
            }
        }
        const auto value = parse_double(word());
        if (!value) bad("a number");
        return *value;
    }
    /// As real(), rounded once.
    float value() {
        if (coding_.binary) return static_cast<float>(bytes<double>());
        const auto value = parse_float(word());
        if (!value) bad("a number");
        return *value;
    }
    /// A count of things that take at least `least` bytes each: more than the section could hold is an error.
    std::size_t count(std::int64_t value, std::size_t least) const;
    std::size_t offset() const noexcept { return at_; }
    std::size_t left() const noexcept { return last_ - at_; }
    std::string where() const { return coding_.binary ? input_->where_byte(at_) : input_->where_line(at_); }
    [[noreturn]] void bad(std::string_view expected) const;

private:
    template <class T>
    T bytes() {
        if (last_ - at_ < sizeof(T)) bad("more bytes");
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), text_ + at_, sizeof(T));
        if (coding_.swap) std::ranges::reverse(raw);
        at_ += sizeof(T);
        return std::bit_cast<T>(raw);
    }
    static bool ends_word(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
    /// Where the next word starts, if a few blanks are before it and enough text is behind; else null.
    const char* plain_word() const {
        constexpr std::size_t kMostBlanks = 4;
        if (last_ - at_ < kMostBlanks + static_cast<std::size_t>(kNumberRoom)) return nullptr;
        const char* at = text_ + at_;
        for (std::size_t i = 0; i < kMostBlanks && ends_word(*at); ++i) ++at;
        return at;
    }
    std::int64_t text_integer() {
        std::int64_t value = 0;
        if (const char* at = plain_word(); at != nullptr && take_digits(at, value) && ends_word(*at)) {
            at_ = static_cast<std::size_t>(at - text_);
            return value;
        }
        return any_integer();
    }
    std::string_view word();
    std::int64_t any_integer();

    const Input* input_;
    const char* text_;
    Coding coding_;
    std::size_t at_, last_;
};

}  // namespace feelem::gmsh
