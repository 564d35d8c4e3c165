// SPDX-License-Identifier: Apache-2.0
// SCENE | INPUT...: a scene as it is, or one made for this run in a folder of its own, which goes with it.
#pragma once

#include "feelem/convert.hpp"

#include <functional>
#include <string>

namespace feelem {

/// While a scene is made: where its shape alone stands already, and where the scene will be. The first goes
/// when the second is there.
using ShapeStands = std::function<void(const std::string& shape_path, const std::string& scene_path)>;

class SceneForViewing {
public:
    /// Converts when the inputs are no scene; `job.output` means nothing. Throws what convert() throws.
    SceneForViewing(
        Job job, Diagnostics& diagnostics, const Progress& progress, const ShapeStands& shape_stands = {}
    );
    ~SceneForViewing();
    SceneForViewing(const SceneForViewing&) = delete;
    SceneForViewing& operator=(const SceneForViewing&) = delete;

    /// Empty when the conversion was cancelled.
    const std::string& path() const noexcept { return path_; }
    bool is_made() const noexcept { return !folder_.empty(); }

private:
    std::string path_;
    std::string folder_;  ///< To be removed; empty when nothing was made.
};

/// By content: a binary glTF, or a .gltf of JSON.
bool is_scene(const std::string& path);

}  // namespace feelem
