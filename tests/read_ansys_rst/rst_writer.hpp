// SPDX-License-Identifier: Apache-2.0
// Writes small result files in Ansys' layout for tests: SYNTHETIC, after the layout that real files have.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace feelem::test {

/// Flags of a record: what its numbers are and how they are packed.
inline constexpr std::uint8_t kReals = 0x00, kFloats = 0x40, kIntegers = 0x80, kShorts = 0xC0;
inline constexpr std::uint8_t kZlib = 0x20, kWindows = 0x10, kMask = 0x08;

/// Bytes that are put together value by value.
class Bytes {
public:
    template <class T>
    Bytes& put(T value) {
        text_.append(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
    }
    template <class T>
    Bytes& put_all(const std::vector<T>& values) {
        for (const T value : values) put(value);
        return *this;
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// A file of records, one behind the other.
class RecordFile {
public:
    /// Returns the word at which the record begins. The payload is filled up to whole words.
    std::size_t add(std::uint8_t flags, std::string payload);
    std::size_t add(const std::vector<std::int32_t>& values);
    std::size_t add(const std::vector<double>& values);
    std::size_t words() const { return bytes_.size() / 4; }
    /// Overwrites an integer of a record of integers (counted from 1).
    void set_item(std::size_t record, std::size_t item, std::int32_t value);
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

struct WrittenElement {
    std::int32_t id = 1, type = 1, material = 1;
    std::vector<std::int32_t> nodes;
};
struct WrittenType {
    std::int32_t routine = 185;
    std::int32_t corners = 8;
    std::int32_t keyopt1 = 0;
    std::int32_t keyopt8 = 0;
};
/// One record of an element: 3 is ENS, 10 is EUL. Empty values: nothing; `zeros`: only said to be all zero.
struct WrittenElementRecord {
    std::size_t element = 0;  ///< Position in the file.
    std::size_t table_entry = 3;
    std::vector<double> values;
    std::size_t zeros = 0;
};
struct WrittenSet {
    std::int32_t load_step = 1, substep = 1;
    double time = 1;
    bool imaginary = false;
    std::vector<double> solution;           ///< Rows in the order of `storage`; empty: no record.
    std::vector<std::int32_t> rows;         ///< Nodes that have a row (from 1), when not all have.
    std::vector<std::int64_t> reaction_at;  ///< (row - 1) * unknowns + unknown
    std::vector<double> reactions;
    std::vector<WrittenElementRecord> element_records;
};
struct WrittenComponent {
    std::string name;  ///< At most 32 characters.
    bool of_nodes = true;
    std::vector<std::int32_t> members;
};
struct WrittenModel {
    std::vector<std::array<double, 7>> nodes;  ///< id x y z THXY THYZ THZX
    std::vector<WrittenType> types;            ///< Numbered from 1.
    std::vector<WrittenElement> elements;
    std::vector<WrittenComponent> components;
    std::vector<std::int32_t> storage;  ///< Node ids in the order of the solution.
    std::vector<std::int32_t> dofs{1, 2, 3};
    std::vector<WrittenSet> sets;
    std::int32_t analysis = 0, units = 0, sectors = 1;
    std::int32_t nodes_of_all = 0;  ///< 0: those of this file.
    std::int32_t time = 120000;     ///< Of day, when it was written.
    bool is_complex = false, has_principal = false;
    bool has_axis = false;  ///< Cylindrical system 12, round z.
    std::int32_t sector_nodes = 0, sector_elements = 0;
    std::vector<std::int32_t> harmonics;  ///< Of each set.
    std::string title = "SYNTHETIC";
};
std::string write_rst(const WrittenModel& model);

/// Two bricks side by side, nodes 10, 20, ... 120, elements 7 and 8 of materials 1 and 2, without sets.
WrittenModel two_bricks();

}  // namespace feelem::test
