// SPDX-License-Identifier: Apache-2.0
// SCENE | INPUT... of a command: what is said while one is made goes to the terminal.
#pragma once

#include "command.hpp"
#include "convert/scene_for_viewing.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace feelem::cli {

/// For commands that show a finished scene as it is. Throws UsageError when the input is one and options
/// were given that say how a scene is made: they would change nothing.
void refuse_making_a_scene_again(const Options& options);

/// Who wants to know of a scene while it is made.
struct SceneWatcher {
    ShapeStands shape_stands{};
    /// Told what the terminal's bar is told.
    std::function<void(std::string_view stage, double fraction)> progress{};
};

class SceneInput {
public:
    /// Converts when the inputs are no scene. Throws what convert() throws.
    explicit SceneInput(const Options& options, const SceneWatcher& watcher = {});

    /// Empty when the conversion was cancelled.
    const std::string& path() const noexcept { return path_; }
    bool is_made() const noexcept { return made_.has_value(); }

private:
    std::string path_;
    std::optional<SceneForViewing> made_;
};

}  // namespace feelem::cli
