// SPDX-License-Identifier: Apache-2.0
// `feelem convert`: results in, a scene or another format out.
#include "command.hpp"
#include "terminal.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace feelem::cli {

int run_convert(const Options& options) {
    Diagnostics diagnostics;
    Terminal terminal(options.verbose);
    const bool done = convert(options.job, diagnostics, terminal.progress());
    terminal.finish();
    print_diagnostics(diagnostics);
    if (done) return 0;
    fmt::print(stderr, "feelem: cancelled, nothing was written\n");
    return 1;
}

}  // namespace feelem::cli
