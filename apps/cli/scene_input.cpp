// SPDX-License-Identifier: Apache-2.0
#include "scene_input.hpp"

#include "terminal.hpp"

namespace feelem::cli {

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
