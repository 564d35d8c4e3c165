// SPDX-License-Identifier: Apache-2.0
// Writes results files as Abaqus does, for tests: by the manual, sharing nothing with the reader.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace feelem::test {

/// An integer, a real, or text of eight letters.
using FilWord = std::variant<int, double, std::string>;
struct FilRecord {
    int key = 0;
    std::vector<FilWord> words;
};

/// Lines of 80; an increment's end is followed by a blank line.
std::string ascii_fil(const std::vector<FilRecord>& records);
/// Blocks of 512 words between marks; each increment fills its last block with zeros.
std::string binary_fil(const std::vector<FilRecord>& records, bool big_endian = false);

}  // namespace feelem::test
