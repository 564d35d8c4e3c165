// SPDX-License-Identifier: Apache-2.0
#include "side_files.hpp"

#include "base/sha256.hpp"

#include "feelem/error.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <utility>

namespace feelem::server {
namespace {

namespace fs = std::filesystem;

/// One name without folders, as the converter writes them.
bool is_plain_name(std::string_view name) {
    if (name.empty() || name.front() == '.') return false;
    for (const char c : name) {
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        const bool is_other = (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
        if (!is_letter && !is_other) return false;
    }
    return true;
}

}  // namespace

SceneFolder::SceneFolder(std::string scene_path) : scene_path_(std::move(scene_path)) {
    const fs::path path(scene_path_);
    name_ = path.filename().string();
    stem_ = path.stem().string();
    suffix_ = path.extension().string();
    side_folder_ = (path.parent_path() / (stem_ + ".d")).string();
}

std::string SceneFolder::file_behind(std::string_view url_path) const {
    if (url_path == "/scene" + suffix_ || url_path == "/" + name_) return scene_path_;
    for (const std::string& folder : {std::string("/scene.d/"), "/" + stem_ + ".d/"}) {
        if (!url_path.starts_with(folder)) continue;
        const std::string_view name = url_path.substr(folder.size());
        if (!is_plain_name(name)) return {};
        const fs::path file = fs::path(side_folder_) / name;
        std::error_code error;
        // A link would lead out of the folder.
        if (!fs::is_regular_file(fs::symlink_status(file, error))) return {};
        return file.string();
    }
    return {};
}

std::shared_ptr<const ServedFile> SceneFolder::find(std::string_view url_path) {
    const std::string path = file_behind(url_path);
    if (path.empty()) return nullptr;
    struct stat now {};
    if (stat(path.c_str(), &now) != 0 || !S_ISREG(now.st_mode)) return nullptr;
    const long long modified = now.st_mtim.tv_sec * 1'000'000'000LL + now.st_mtim.tv_nsec;
    const auto size = static_cast<std::size_t>(now.st_size);
    const std::lock_guard lock(mutex_);
    Opened& opened = opened_[path];
    const bool is_same =
        opened.file && opened.modified_ns == modified && opened.size == size && opened.inode == now.st_ino;
    if (is_same) return opened.file;
    try {
        Input bytes = Input::from_file(path);
        std::string etag = "\"" + sha256_hex(bytes) + "\"";
        opened = {
            modified,
            size,
            now.st_ino,
            std::make_shared<ServedFile>(ServedFile{std::move(bytes), std::move(etag)})};
    } catch (const Error&) {
        opened_.erase(path);  // Gone since stat(): not found, like any other file that is not there.
        return nullptr;
    }
    return opened.file;
}

}  // namespace feelem::server
