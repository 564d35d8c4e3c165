// SPDX-License-Identifier: Apache-2.0
#include "viewer/doctor/machine.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <system_error>

namespace feelem::viewer {

Machine this_machine() {
    Machine machine;
    machine.environment = [](const std::string& name) {
        const char* value = std::getenv(name.c_str());
        return std::string(value == nullptr ? "" : value);
    };
    machine.can_use = [](const std::filesystem::path& path) {
        return access(path.c_str(), R_OK | W_OK) == 0;
    };
    return machine;
}

std::string text_of(const std::filesystem::path& file) {
    constexpr std::streamsize kMost = 65536;
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) return "";
    std::string text(kMost, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(text.data(), kMost);
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return text;
}

bool is_there(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::exists(path, error);
}

}  // namespace feelem::viewer
