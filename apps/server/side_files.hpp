// SPDX-License-Identifier: Apache-2.0
// Files of the scene being served: the scene itself and those of its side folder, and nothing else.
#pragma once

#include "base/input.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace feelem::server {

/// A file as it was when it was last looked at.
struct ServedFile {
    Input bytes;
    std::string etag;  ///< "\"sha256...\""
};

class SceneFolder {
public:
    explicit SceneFolder(std::string scene_path);

    /// "/scene.glb", "/NAME.glb", "/scene.d/FILE", "/NAME.d/FILE" (and .gltf); null for every other path.
    /// A file that was written anew is opened anew.
    std::shared_ptr<const ServedFile> find(std::string_view url_path);

private:
    std::string file_behind(std::string_view url_path) const;

    struct Opened {
        long long modified_ns = 0;
        std::size_t size = 0;
        unsigned long inode = 0;
        std::shared_ptr<const ServedFile> file;
    };
    std::string scene_path_;
    std::string name_;         ///< "boiler.glb"
    std::string stem_;         ///< "boiler"
    std::string suffix_;       ///< ".glb"
    std::string side_folder_;  ///< ".../boiler.d"
    std::mutex mutex_;
    std::map<std::string, Opened> opened_;
};

}  // namespace feelem::server
