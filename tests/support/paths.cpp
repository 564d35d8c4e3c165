// SPDX-License-Identifier: Apache-2.0
#include "support/paths.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace feelem::test {

namespace fs = std::filesystem;

std::string project_file(const std::string& path) {
    return (fs::path(FEELEM_SOURCE_DIR) / path).string();
}

std::optional<std::string> corpus_file(const std::string& path) {
    const fs::path file = fs::path(FEELEM_SOURCE_DIR) / ".." / "shared" / "corpus" / path;
    if (!fs::exists(file)) return std::nullopt;
    return fs::canonical(file).string();
}

std::string scratch_folder(const std::string& name) {
    const fs::path folder = fs::path(FEELEM_BINARY_DIR) / "scratch" / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder.string();
}

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const std::string& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file << bytes;
    if (!file) throw std::runtime_error("cannot write " + path);
}

}  // namespace feelem::test
