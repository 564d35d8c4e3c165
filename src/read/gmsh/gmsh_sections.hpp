// SPDX-License-Identifier: Apache-2.0
// The sections of a .msh file, and numbers from them in either coding.
#pragma once

#include "base/byte_reader.hpp"
#include "base/input.hpp"
#include "base/number.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/error.hpp"

#include <cstddef>
#include <cstdint>
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
        : input_(&input), coding_(coding), at_(first), last_(last) {}

    std::int64_t integer() { return coding_.binary ? bytes<std::int32_t>() : text_integer(); }
    /// Counts and tags of version 4.1: eight bytes.
    std::int64_t size() { return coding_.binary ? bytes<std::int64_t>() : text_integer(); }
    double real() {
        if (coding_.binary) return bytes<double>();
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
    std::string where() const { return coding_.binary ? input_->where_byte(at_) : input_->where_line(at_); }
    [[noreturn]] void bad(std::string_view expected) const;

private:
    template <class T>
    T bytes() {
        if (last_ - at_ < sizeof(T)) bad("more bytes");
        ByteReader reader(*input_, at_, coding_.swap);
        at_ += sizeof(T);
        return reader.read<T>();
    }
    std::string_view word();
    std::int64_t text_integer();

    const Input* input_;
    Coding coding_;
    std::size_t at_, last_;
};

}  // namespace feelem::gmsh
