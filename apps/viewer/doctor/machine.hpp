// SPDX-License-Identifier: Apache-2.0
// What the doctor looks at: this machine, or one that a test made up.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace feelem::viewer {

struct Machine {
    std::filesystem::path root = "/";
    std::function<std::string(const std::string&)> environment;  ///< "" where the variable is not set.
    std::function<bool(const std::filesystem::path&)> can_use;   ///< May this user read and write the device?

    /// A path of the machine, such as /proc/asound/cards, where it lies for us.
    std::filesystem::path at(const std::filesystem::path& path) const { return root / path.relative_path(); }
};

/// The one we run on.
Machine this_machine();

/// "" when it cannot be read; at most 64 KiB.
std::string text_of(const std::filesystem::path& file);
bool is_there(const std::filesystem::path& path);

}  // namespace feelem::viewer
