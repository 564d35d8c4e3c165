// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_store.hpp"

#include "feelem/error.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace feelem {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMainName = "scene.bin";

/// Only folders that hold nothing but buffers are replaced: a folder of that name may be somebody's own.
void refuse_foreign_folder(const std::string& folder) {
    if (!fs::exists(folder)) return;
    if (!fs::is_directory(folder))
        throw Error(Code::WriteFailed, folder, "the scene needs a folder of this name");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".bin") continue;
        throw Error(
            Code::WriteFailed,
            folder,
            "holds " + entry.path().filename().string() +
                ", which is not part of a scene, and would be replaced. Move it away or choose another name."
        );
    }
}

void put_u32(std::string& out, std::uint64_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) out += static_cast<char>(value >> shift & 0xFF);
}

/// Header and JSON chunk of a .glb, padded.
std::string glb_head(const std::string& text, std::uint64_t binary) {
    const std::uint64_t json_size = (text.size() + 3) / 4 * 4;
    const std::uint64_t total = 12 + 8 + json_size + 8 + binary;
    if (total > 0xFFFFFFFFull)
        throw Error(Code::TooLarge, "", "a .glb holds at most 4 GiB. Write a .gltf, or fewer results.");
    std::string head = "glTF";
    put_u32(head, 2);
    put_u32(head, total);
    put_u32(head, json_size);
    head += "JSON" + text + std::string(json_size - text.size(), ' ');
    put_u32(head, binary);
    head.append("BIN\0", 4);
    return head;
}

void swap_folders(const std::string& first, const std::string& second) {
    if (renameat2(AT_FDCWD, first.c_str(), AT_FDCWD, second.c_str(), RENAME_EXCHANGE) == 0) return;
    throw Error(Code::WriteFailed, second, std::string("cannot replace the folder: ") + std::strerror(errno));
}

void remove_quietly(const std::string& folder) noexcept {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
}

}  // namespace

SceneFiles open_files(const std::string& path) {
    SceneFiles files;
    const fs::path target(path);
    files.path = path;
    files.is_glb = target.extension() == ".glb";
    if (!files.is_glb && target.extension() != ".gltf")
        throw Error(Code::BadOption, path, "a scene is written as .glb or .gltf");
    const fs::path folder = fs::path(target).replace_extension(".d");
    files.folder = folder.string();
    files.folder_name = folder.filename().string();
    files.new_folder = files.folder + ".tmp-" + std::to_string(getpid());
    refuse_foreign_folder(files.folder);
    remove_quietly(files.new_folder);
    if (files.is_glb) {
        files.main = std::make_unique<ScratchFile>(path, ScratchFile::Kind::Unnamed);
        return files;
    }
    std::error_code error;
    fs::create_directories(files.new_folder, error);
    if (error) throw Error(Code::WriteFailed, files.folder, "cannot create the folder: " + error.message());
    const std::string name = (fs::path(files.new_folder) / kMainName).string();
    files.main = std::make_unique<ScratchFile>(name, ScratchFile::Kind::Named);
    return files;
}

std::string main_uri(const SceneFiles& files) {
    return files.is_glb ? "" : files.folder_name + "/" + kMainName;
}

void store(SceneFiles& files, const std::string& json) {
    AtomicFile file(files.path);
    if (files.is_glb) {
        files.main->pad_to(4);
        file.write(glb_head(json, files.main->size()));
        files.main->copy_to(file);
    } else {
        files.main->finish();
        file.write(json);
    }
    const bool has_new = fs::exists(files.new_folder);
    const bool has_old = fs::exists(files.folder);
    // Two renames in a row, nothing slow between them; the old folder comes back when the second one fails.
    if (has_new && has_old)
        swap_folders(files.new_folder, files.folder);
    else if (has_new)
        fs::rename(files.new_folder, files.folder);
    try {
        file.commit();
    } catch (...) {
        if (has_new && has_old)
            swap_folders(files.new_folder, files.folder);
        else if (has_new)
            fs::rename(files.folder, files.new_folder);
        throw;
    }
    remove_quietly(has_new ? files.new_folder : files.folder);
}

void discard(SceneFiles& files) noexcept {
    files.main.reset();
    remove_quietly(files.new_folder);
}

}  // namespace feelem
