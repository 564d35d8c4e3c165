// SPDX-License-Identifier: Apache-2.0
// Runs the helper program that reads through other people's libraries: they may crash, hang or take all
// memory on a damaged file, and must take nobody with them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace feelem::exchange {

/// What the helper answered to its arguments. `name` is the file for messages, `bytes` its size, by which
/// time and memory are bounded. Throws Error: UnsupportedFormat when there is no helper beside this program,
/// BadStructure with its words, or with how it ended.
std::string ask_helper(
    const std::vector<std::string>& arguments, const std::string& name, std::uint64_t bytes
);

/// Whether there is one: tests are skipped without.
bool has_helper();

}  // namespace feelem::exchange
