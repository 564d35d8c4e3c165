// SPDX-License-Identifier: Apache-2.0
// `feelem check`: every claim of a scene's certificate, recomputed.
#include "command.hpp"

#include "feelem/probe.hpp"
#include "feelem/scene.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace feelem::cli {

int run_check(const Options& options) {
    const std::string& scene = options.job.inputs.front();
    if (options.job.inputs.size() > 1) {
        throw UsageError(
            "check with inputs is not available yet; feelem check SCENE verifies the scene itself"
        );
    }
    const std::vector<Claim> claims = check_scene(scene);
    const auto failed = std::ranges::count(claims, false, &Claim::holds);
    if (options.json) {
        fmt::print("{}", claims_json(claims));
        return failed == 0 ? 0 : 1;
    }
    for (const Claim& claim : claims) {
        if (claim.holds) continue;
        fmt::print("FAILS  {}: the certificate says {}, found {}\n", claim.name, claim.claimed, claim.found);
    }
    if (failed == 0)
        fmt::print("All {} claims of {} hold.\n", claims.size(), scene);
    else
        fmt::print("{} of {} claims of {} fail.\n", failed, claims.size(), scene);
    return failed == 0 ? 0 : 1;
}

}  // namespace feelem::cli
