// SPDX-License-Identifier: Apache-2.0
// Files that a deck names inside itself (INCLUDE), opened beside it and remembered, so that the model's input
// records hold them too.
#pragma once

#include "base/input.hpp"

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace feelem {

class IncludeFiles {
public:
    /// `given`: the inputs of the model; an include is looked for among them first.
    explicit IncludeFiles(std::span<const Input> given) : given_(given) {}

    /// The file that `from` includes as `name`: an input of that file name, else the file at `name` from
    /// the folder of `from`. Text is UTF-8 without a byte-order mark. Decks in memory find inputs only.
    /// Empty when there is none; throws Error(FileUnreadable) when it exists but cannot be read.
    std::optional<Input> find(const std::string& name, const Input& from);

    /// What find() took from outside the given inputs, in order of first use, each once.
    std::span<const Input> opened() const noexcept { return opened_; }
    /// Names of the given inputs that find() took: they are no models of their own.
    const std::set<std::string>& taken() const noexcept { return taken_; }

private:
    std::span<const Input> given_;
    std::vector<Input> opened_;
    std::set<std::string> taken_;
};

}  // namespace feelem
