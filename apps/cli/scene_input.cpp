// SPDX-License-Identifier: Apache-2.0
#include "scene_input.hpp"

#include "terminal.hpp"

#include "feelem/error.hpp"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace feelem::cli {
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

SceneInput::SceneInput(const Options& options) {
    const Job& given = options.job;
    if (given.inputs.size() == 1 && is_scene(given.inputs.front())) {
        path_ = given.inputs.front();
        return;
    }
    folder_ = make_folder();
    Job job = given;
    const std::string stem = fs::path(given.inputs.front()).stem().string();
    job.output = (fs::path(folder_) / ((stem.empty() ? "scene" : stem) + ".glb")).string();
    try {
        Terminal terminal(options.verbose);
        ToldDiagnostics diagnostics(terminal);
        const bool done = convert(job, *diagnostics, terminal.progress());
        diagnostics.print();
        if (done) path_ = job.output;
    } catch (...) {
        std::error_code error;
        fs::remove_all(folder_, error);
        throw;
    }
}

SceneInput::~SceneInput() {
    std::error_code error;
    if (!folder_.empty()) fs::remove_all(folder_, error);
}

}  // namespace feelem::cli
