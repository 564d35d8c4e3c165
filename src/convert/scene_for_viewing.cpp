// SPDX-License-Identifier: Apache-2.0
#include "convert/scene_for_viewing.hpp"

#include "feelem/error.hpp"

#include <stdlib.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace feelem {
namespace {

namespace fs = std::filesystem;

std::string make_folder() {
    std::error_code error;
    fs::path base = fs::temp_directory_path(error);
    if (error) base = "/tmp";
    std::string name = (base / "feelem-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw Error(Code::WriteFailed, name, std::string("cannot make a folder: ") + std::strerror(errno));
    }
    return name;
}

}  // namespace

bool is_scene(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, 4> head{};
    if (!file.read(head.data(), head.size())) return false;
    if (std::string_view(head.data(), head.size()) == "glTF") return true;
    return fs::path(path).extension() == ".gltf" && head[0] == '{';
}

SceneForViewing::SceneForViewing(
    Job job, Diagnostics& diagnostics, const Progress& progress, const ShapeStands& shape_stands
) {
    if (job.inputs.size() == 1 && is_scene(job.inputs.front())) {
        path_ = job.inputs.front();
        return;
    }
    folder_ = make_folder();
    const std::string stem = fs::path(job.inputs.front()).stem().string();
    job.output = (fs::path(folder_) / ((stem.empty() ? "scene" : stem) + ".glb")).string();
    EarlyShape early;
    if (shape_stands) {
        early.output = job.output + ".shape.glb";
        early.stands = [&] { shape_stands(early.output, job.output); };
    }
    try {
        if (convert(job, diagnostics, progress, early)) path_ = job.output;
        std::error_code error;
        if (!early.output.empty()) fs::remove(early.output, error);
    } catch (...) {
        std::error_code error;
        fs::remove_all(folder_, error);
        throw;
    }
}

SceneForViewing::~SceneForViewing() {
    std::error_code error;
    if (!folder_.empty()) fs::remove_all(folder_, error);
}

}  // namespace feelem
