// SPDX-License-Identifier: Apache-2.0
// Files that a main file names, or that belong to it by their names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace feelem::exchange {

/// One <DataSet> of a .pvd collection.
struct PvdEntry {
    double time = 0;
    std::string file;
    std::string part{};  ///< Empty: the collection names none.
};
/// In file order. Throws Error(BadStructure) when there is none, Error(Truncated) when the end is missing.
std::vector<PvdEntry> read_pvd(std::string_view text, const std::string& name);

/// Values of an attribute in the tags of that name: the pieces of .pvtu (Source) and .vtm (file).
std::vector<std::string> attribute_values(
    std::string_view text, std::string_view tag, std::string_view attribute
);

}  // namespace feelem::exchange
