// SPDX-License-Identifier: Apache-2.0
// `feelem convert`: results in, a scene or another format out.
#include "command.hpp"
#include "review_file.hpp"
#include "scene_input.hpp"
#include "terminal.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace feelem::cli {
namespace {

namespace fs = std::filesystem;

/// What can be known to fail is found before the work begins.
void check_review_output(const Job& job) {
    const fs::path path(job.output);
    std::error_code error;
    if (!fs::is_directory(path.has_parent_path() ? path.parent_path() : ".", error)) {
        throw Error(Code::WriteFailed, job.output, "its folder does not exist");
    }
    for (const std::string& input : job.inputs) {
        if (!fs::equivalent(input, path, error)) continue;
        throw Error(Code::BadOption, job.output, "is an input too; the output needs a name of its own");
    }
}

/// Page and scene in one file. The input may be a scene already.
int convert_to_review(const Options& options) {
    check_review_output(options.job);
    refuse_making_a_scene_again(options);
    const SceneInput scene(options);
    if (scene.path().empty()) {
        fmt::print(stderr, "feelem: cancelled, nothing was written\n");
        return 1;
    }
    server::write_review_file(scene.path(), options.job.output);
    return 0;
}

}  // namespace

int run_convert(const Options& options) {
    if (fs::path(options.job.output).extension() == ".html") return convert_to_review(options);
    Terminal terminal(options.verbose);
    ToldDiagnostics diagnostics(terminal);
    const bool done = convert(options.job, *diagnostics, terminal.progress());
    diagnostics.print();
    if (done) return 0;
    fmt::print(stderr, "feelem: cancelled, nothing was written\n");
    return 1;
}

}  // namespace feelem::cli
