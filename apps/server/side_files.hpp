// SPDX-License-Identifier: Apache-2.0
// Files of the scene being served: the scene itself and those of its side folder, and nothing else.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>

namespace feelem::server {

/// An open file. It is read piece by piece, so that a big one never is in memory as a whole; one that is
/// replaced by another meanwhile stays what it was.
class ServedFile {
public:
    /// Takes the open file over.
    explicit ServedFile(int descriptor);
    ~ServedFile();
    ServedFile(const ServedFile&) = delete;
    ServedFile& operator=(const ServedFile&) = delete;

    void is_known_as(std::size_t size, std::string etag);
    std::size_t size() const { return size_; }
    const std::string& etag() const { return etag_; }
    /// How many bytes were there: fewer than asked for when somebody has cut the file.
    std::size_t read(std::size_t offset, std::span<char> bytes) const;

private:
    int descriptor_;
    std::size_t size_ = 0;
    std::string etag_;  ///< "\"sha256...\""; of a file beyond kHashedWhole by size, place and time.
};

/// A bigger file would keep its first reader waiting.
inline constexpr std::size_t kHashedWhole = 256u << 20;

class SceneFolder {
public:
    explicit SceneFolder(std::string scene_path);

    /// "/scene.glb", "/NAME.glb", "/scene.d/FILE", "/NAME.d/FILE" (and .gltf); null for every other path.
    /// A file that was written anew has another etag.
    std::shared_ptr<const ServedFile> find(std::string_view url_path);
    /// Whether such a path is ours, be there a file or not.
    bool owns(std::string_view url_path) const;

private:
    std::string file_behind(std::string_view url_path) const;

    /// What a file was when it was last hashed.
    struct Hashed {
        long long modified_ns = 0;
        std::size_t size = 0;
        unsigned long inode = 0;
        std::string etag;
    };
    std::string etag_of(const std::string& path, int descriptor, const Hashed& now);

    std::string scene_path_;
    std::string name_;         ///< "boiler.glb"
    std::string stem_;         ///< "boiler"
    std::string suffix_;       ///< ".glb"
    std::string side_folder_;  ///< ".../boiler.d"
    std::mutex mutex_;
    std::map<std::string, Hashed> hashed_;
};

}  // namespace feelem::server
