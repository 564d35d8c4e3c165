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

SceneInput::SceneInput(const Options& options) {
    const Job& job = options.job;
    if (job.inputs.size() == 1 && is_scene(job.inputs.front())) {
        path_ = job.inputs.front();
        return;
    }
    Terminal terminal(options.verbose);
    ToldDiagnostics diagnostics(terminal);
    made_.emplace(job, *diagnostics, terminal.progress());
    diagnostics.print();
    path_ = made_->path();
}

}  // namespace feelem::cli
