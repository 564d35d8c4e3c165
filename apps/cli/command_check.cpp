// SPDX-License-Identifier: Apache-2.0
// `feelem check`: every claim of a scene's certificate, recomputed; with inputs, the scene against them.
#include "command.hpp"
#include "terminal.hpp"

#include "feelem/convert.hpp"
#include "feelem/probe.hpp"
#include "feelem/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace feelem::cli {

int run_check(const Options& options) {
    const std::string& scene = options.job.inputs.front();
    std::vector<Claim> claims = check_scene(scene);
    for (Claim& claim : check_levels(scene)) claims.push_back(std::move(claim));
    const std::size_t own = claims.size();
    if (options.job.inputs.size() > 1) {
        Job job = options.job;
        job.inputs.erase(job.inputs.begin());
        Terminal terminal(options.verbose);
        ToldDiagnostics diagnostics(terminal);
        for (Claim& claim : check_against_inputs(scene, job, *diagnostics, terminal.progress()))
            claims.push_back(std::move(claim));
        if (was_interrupted()) {
            fmt::print(stderr, "feelem: cancelled\n");
            return 1;
        }
    }
    const auto failed = std::ranges::count(claims, false, &Claim::holds);
    if (options.json) {
        fmt::print("{}", claims_json(claims));
        return failed == 0 ? 0 : 1;
    }
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const Claim& claim = claims[i];
        if (claim.holds) continue;
        const char* who = i < own ? "the certificate says" : "expected";
        fmt::print("FAILS  {}: {} {}, found {}\n", claim.name, who, claim.claimed, claim.found);
    }
    if (failed == 0)
        fmt::print("All {} claims of {} hold.\n", claims.size(), scene);
    else
        fmt::print("{} of {} claims of {} fail.\n", failed, claims.size(), scene);
    return failed == 0 ? 0 : 1;
}

}  // namespace feelem::cli
