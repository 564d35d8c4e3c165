// SPDX-License-Identifier: Apache-2.0
#include "read/exchange/input_files.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace feelem::exchange {
namespace {

namespace fs = std::filesystem;

std::string make_folder() {
    std::error_code error;
    std::string pattern = (fs::temp_directory_path(error) / "feelem-XXXXXX").string();
    if (error || mkdtemp(pattern.data()) == nullptr)
        throw Error(
            Code::WriteFailed,
            pattern,
            fmt::format("cannot make a temporary folder: {}", std::strerror(errno))
        );
    return pattern;
}

/// Only below the folder: "../x" and "/x" stay with the user's own files.
bool stays_below(const fs::path& name) {
    return !name.empty() && name.is_relative() && std::ranges::find(name, fs::path("..")) == name.end();
}

/// Whether the bytes are those of the file of that name, not something else that was given in memory.
bool is_on_disk(const Input& input) {
    std::error_code error;
    if (!fs::is_regular_file(input.name(), error) || fs::file_size(input.name(), error) != input.size())
        return false;
    try {
        return Input::from_file(input.name()).text() == input.text();
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

InputFiles::InputFiles(const Input& main, const std::vector<std::string>& others, IncludeFiles* includes)
    : path_(main.name()), bytes_(main.size()) {
    std::vector<std::pair<std::string, Input>> found;
    bool on_disk = is_on_disk(main);
    for (const std::string& other : others) {
        auto input = includes != nullptr ? includes->find(other, main) : std::nullopt;
        if (!input) continue;
        bytes_ += input->size();
        on_disk = on_disk && is_on_disk(*input);
        found.emplace_back(other, std::move(*input));
    }
    if (on_disk) return;
    folder_ = make_folder();
    const std::string name = fs::path(main.name()).filename().string();
    path_ = (fs::path(folder_) / (name.empty() ? "file" : name)).string();
    write(name.empty() ? "file" : name, main);
    for (const auto& [other, input] : found) {
        if (stays_below(other)) write(other, input);
    }
}

InputFiles::~InputFiles() {
    std::error_code error;
    if (!folder_.empty()) fs::remove_all(folder_, error);
}

void InputFiles::write(const std::string& name, const Input& input) const {
    const fs::path path = fs::path(folder_) / name;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    std::ofstream out(path, std::ios::binary);
    out.write(input.text().data(), static_cast<std::streamsize>(input.size()));
    if (!out.flush())
        throw Error(Code::WriteFailed, path.string(), "cannot write a temporary copy of the input");
}

}  // namespace feelem::exchange
