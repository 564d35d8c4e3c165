// SPDX-License-Identifier: Apache-2.0
// The files of a scene, new beside old until all are whole, then put in place.
#pragma once

#include "scene/scene_build.hpp"

#include <string>

namespace feelem {

/// Decides names by the suffix of `path` (.glb or .gltf). Throws Error(BadOption | WriteFailed).
SceneFiles open_files(const std::string& path);
/// Name of buffer 0: empty in a .glb, else a file of the folder.
std::string main_uri(const SceneFiles& files);
/// The last step: the new files replace the old ones.
void store(SceneFiles& files, const std::string& json);
/// Removes what a failed write left.
void discard(SceneFiles& files) noexcept;

}  // namespace feelem
