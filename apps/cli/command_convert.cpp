// SPDX-License-Identifier: Apache-2.0
// `feelem convert`: results in, a scene or another format out.
#include "command.hpp"
#include "terminal.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace feelem::cli {

int run_convert(const Options& options) {
    Terminal terminal(options.verbose);
    ToldDiagnostics diagnostics(terminal);
    const bool done = convert(options.job, *diagnostics, terminal.progress());
    diagnostics.print();
    if (done) return 0;
    fmt::print(stderr, "feelem: cancelled, nothing was written\n");
    return 1;
}

}  // namespace feelem::cli
