// SPDX-License-Identifier: Apache-2.0
#include "side_files.hpp"

#include "base/sha256.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <utility>
#include <vector>

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

std::size_t read_at(int descriptor, std::size_t offset, std::span<char> bytes) {
    std::size_t size = 0;
    while (size < bytes.size()) {
        const auto at = static_cast<off_t>(offset + size);
        const ssize_t got = pread(descriptor, bytes.data() + size, bytes.size() - size, at);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        size += static_cast<std::size_t>(got);
    }
    return size;
}

std::string hash_of(int descriptor, std::size_t size) {
    Sha256 hash;
    std::vector<char> chunk(std::min<std::size_t>(size, 1 << 20));
    for (std::size_t at = 0; at < size;) {
        const std::size_t got = read_at(descriptor, at, chunk);
        if (got == 0) break;
        hash.add(std::as_bytes(std::span(chunk).first(got)));
        at += got;
    }
    return hash.hex();
}

}  // namespace

ServedFile::ServedFile(int descriptor) : descriptor_(descriptor) {}

ServedFile::~ServedFile() {
    close(descriptor_);
}

void ServedFile::is_known_as(std::size_t size, std::string etag) {
    size_ = size;
    etag_ = std::move(etag);
}

std::size_t ServedFile::read(std::size_t offset, std::span<char> bytes) const {
    return read_at(descriptor_, offset, bytes);
}

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

bool SceneFolder::owns(std::string_view url_path) const {
    return url_path == "/scene" + suffix_ || url_path == "/" + name_ || url_path.starts_with("/scene.d/") ||
           url_path.starts_with("/" + stem_ + ".d/");
}

std::shared_ptr<const ServedFile> SceneFolder::find(std::string_view url_path) {
    const std::string path = file_behind(url_path);
    if (path.empty()) return nullptr;
    // The scene itself may be a link; what is beside it must not lead out of the folder.
    const int link = path == scene_path_ ? 0 : O_NOFOLLOW;
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | link);
    if (descriptor < 0) return nullptr;
    const auto file = std::make_shared<ServedFile>(descriptor);  // Closes it, whatever comes.
    struct stat now {};
    if (fstat(descriptor, &now) != 0 || !S_ISREG(now.st_mode)) return nullptr;
    const long long modified = now.st_mtim.tv_sec * 1'000'000'000LL + now.st_mtim.tv_nsec;
    const auto size = static_cast<std::size_t>(now.st_size);
    file->is_known_as(size, etag_of(path, descriptor, {modified, size, now.st_ino, ""}));
    return file;
}

std::string SceneFolder::etag_of(const std::string& path, int descriptor, const Hashed& now) {
    if (now.size > kHashedWhole)
        return fmt::format("\"{:x}-{:x}-{:x}\"", now.size, now.modified_ns, now.inode);
    const std::lock_guard lock(mutex_);
    Hashed& known = hashed_[path];
    if (known.etag.empty() || known.modified_ns != now.modified_ns || known.size != now.size ||
        known.inode != now.inode) {
        known = now;
        known.etag = "\"" + hash_of(descriptor, now.size) + "\"";
    }
    return known.etag;
}

}  // namespace feelem::server
