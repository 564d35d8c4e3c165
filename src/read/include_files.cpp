// SPDX-License-Identifier: Apache-2.0
#include "read/include_files.hpp"

#include "base/text_encoding.hpp"

#include <algorithm>
#include <filesystem>

namespace feelem {
namespace {

namespace fs = std::filesystem;

/// Decks are written on Windows as often as not: C:\\run\\mesh.inp.
std::string with_slashes(std::string name) {
    std::ranges::replace(name, '\\', '/');
    return name;
}

std::string file_name(const std::string& path) {
    return fs::path(with_slashes(path)).filename().string();
}

}  // namespace

std::optional<Input> IncludeFiles::find(const std::string& name, const Input& from) {
    const std::string wanted = file_name(name);
    if (wanted.empty()) return {};
    for (const Input& input : given_) {
        if (file_name(input.name()) != wanted || input.name() == from.name()) continue;
        taken_.insert(input.name());
        return without_encoding(input);
    }
    std::error_code error;
    const fs::path path = (fs::path(from.name()).parent_path() / with_slashes(name)).lexically_normal();
    if (!fs::is_regular_file(from.name(), error) || !fs::is_regular_file(path, error)) return {};
    const auto known =
        std::ranges::find(opened_, path.string(), [](const Input& input) { return input.name(); });
    if (known != opened_.end()) return without_encoding(*known);
    opened_.push_back(Input::from_file(path.string()));
    return without_encoding(opened_.back());
}

}  // namespace feelem
