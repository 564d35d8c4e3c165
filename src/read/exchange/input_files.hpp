// SPDX-License-Identifier: Apache-2.0
// Inputs as files on disk, for libraries that open files themselves.
#pragma once

#include "base/input.hpp"
#include "read/include_files.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace feelem::exchange {

/// Where a main file and what belongs to it can be opened. Files that were given in memory are written to a
/// folder of their own, which goes with this object.
class InputFiles {
public:
    /// `others`: names that the main file refers to, from its folder; those that cannot be found are left to
    /// the library to miss. `includes` may be null.
    InputFiles(const Input& main, const std::vector<std::string>& others, IncludeFiles* includes);
    ~InputFiles();
    InputFiles(const InputFiles&) = delete;
    InputFiles& operator=(const InputFiles&) = delete;

    const std::string& path() const noexcept { return path_; }
    std::uint64_t bytes() const noexcept { return bytes_; }  ///< Of all files that were found.

private:
    void write(const std::string& name, const Input& input) const;

    std::string path_;
    std::string folder_;  ///< Empty: nothing had to be written.
    std::uint64_t bytes_ = 0;
};

}  // namespace feelem::exchange
