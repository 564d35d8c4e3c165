// SPDX-License-Identifier: Apache-2.0
#include "scene_input.hpp"

#include "terminal.hpp"

#include <fmt/format.h>

namespace feelem::cli {

void refuse_making_a_scene_again(const Options& options) {
    const Job& job = options.job;
    if (options.making.empty() || job.inputs.size() != 1 || !is_scene(job.inputs.front())) return;
    throw UsageError(fmt::format(
        "{} is a finished scene: {} {} how one is made, and would change nothing. Leave {} out, or give the "
        "solver's files instead",
        job.inputs.front(),
        fmt::join(options.making, " and "),
        options.making.size() == 1 ? "says" : "say",
        options.making.size() == 1 ? "it" : "them"
    ));
}

SceneInput::SceneInput(const Options& options, const SceneWatcher& watcher) {
    const Job& job = options.job;
    if (job.inputs.size() == 1 && is_scene(job.inputs.front())) {
        path_ = job.inputs.front();
        return;
    }
    Terminal terminal(options.verbose);
    ToldDiagnostics diagnostics(terminal);
    const auto progress = [&, bar = terminal.progress()](std::string_view stage, double fraction) {
        if (watcher.progress) watcher.progress(stage, fraction);
        return bar(stage, fraction);
    };
    ShapeStands shape_stands;
    if (watcher.shape_stands) {
        shape_stands = [&](const std::string& shape_path, const std::string& scene_path) {
            terminal.finish();  // What is said now has a line of its own.
            watcher.shape_stands(shape_path, scene_path);
        };
    }
    made_.emplace(job, *diagnostics, progress, shape_stands);
    diagnostics.print();
    path_ = made_->path();
}

}  // namespace feelem::cli
