// SPDX-License-Identifier: Apache-2.0
// Records of Ansys' binary files: found by word, checked at both ends, unpacked whatever their compression.
#pragma once

#include "base/input.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace feelem::rst {

/// Places in the file are counted in words of four bytes.
using Word = std::uint64_t;

/// A record as it stands in the file.
struct Record {
    std::span<const std::byte> payload;
    std::uint8_t flags = 0;
    Word at = 0;
    Word next = 0;  ///< Where the record behind it begins.
};

/// Values that small records may unpack to: headers, index tables of a model's types.
inline constexpr std::size_t kSmallRecord = 1u << 16;

/// Reads records of one file. Everything throws Error(Truncated | BadStructure) with the place.
class Records {
public:
    explicit Records(Input input) : input_(std::move(input)) {}

    /// The record at a word. Its length must stand at both of its ends.
    Record find(Word at) const;

    /// Unpacks. `most`: what the caller has use for; a compressed record that would become longer is refused,
    /// so that a few bytes cannot ask for all memory. Integers may be read as reals, not the other way.
    void unpack(const Record& record, std::size_t most, std::vector<std::int32_t>& out) const;
    void unpack(const Record& record, std::size_t most, std::vector<double>& out) const;

    /// How many values a record unpacks to, by its own word.
    static std::size_t count(const Record& record);

    std::vector<std::int32_t> integers(Word at, std::size_t most = kSmallRecord) const;
    std::vector<double> reals(Word at, std::size_t most = kSmallRecord) const;

    /// Values that a record of this file can hold without compression: an upper bound for tables.
    std::size_t words() const noexcept { return input_.size() / 4; }
    const Input& input() const noexcept { return input_; }
    std::string where(Word at) const;

private:
    Input input_;
};

/// The reals of a record: seen where they stand when it is not packed, else unpacked.
class Reals {
public:
    /// `most`: as Records::unpack has it.
    Reals(const Records& records, const Record& record, std::size_t most);
    Reals(const Reals&) = delete;
    Reals& operator=(const Reals&) = delete;

    std::size_t size() const noexcept { return size_; }
    /// Below size().
    double operator[](std::size_t i) const noexcept {
        if (is_half_) {
            float value = 0;
            std::memcpy(&value, bytes_ + i * sizeof value, sizeof value);
            return static_cast<double>(value);
        }
        double value = 0;
        std::memcpy(&value, bytes_ + i * sizeof value, sizeof value);
        return value;
    }

private:
    std::vector<double> unpacked_;
    const std::byte* bytes_ = nullptr;
    std::size_t size_ = 0;
    bool is_half_ = false;
};

/// A 64-bit number out of two words, the low one first.
inline std::uint64_t wide(std::int32_t low, std::int32_t high) {
    return static_cast<std::uint32_t>(low) | std::uint64_t{static_cast<std::uint32_t>(high)} << 32;
}

}  // namespace feelem::rst
