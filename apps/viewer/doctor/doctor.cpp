// SPDX-License-Identifier: Apache-2.0
#include "viewer/doctor/doctor.hpp"

#include "viewer/doctor/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace feelem::viewer {
namespace {

std::string_view word_of(Health health) {
    switch (health) {
    case Health::Well: return "yes";
    case Health::Poor: return "poor";
    case Health::Missing: return "no";
    }
    std::abort();
}

const Finding* find(const std::vector<Finding>& findings, std::string_view what) {
    const auto found =
        std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.what == what; });
    return found == findings.end() ? nullptr : &*found;
}

bool works(const std::vector<Finding>& findings, std::string_view what) {
    const Finding* finding = find(findings, what);
    return finding != nullptr && finding->health != Health::Missing;
}

}  // namespace

std::vector<Finding> examine(const Machine& machine, const TriedGraphics& graphics, const XrStatus* headset) {
    std::vector<Finding> findings{examine_graphics(machine, graphics), examine_screen(machine, graphics)};
    const RuntimeFiles runtime = find_runtime(machine);
    findings.push_back(examine_runtime(runtime));
    if (runtime.fault == RuntimeFault::None) {
        findings.push_back(examine_service(machine, runtime, headset));
        findings.push_back(examine_headset(runtime, headset));
    }
    findings.push_back(examine_sound(machine));
    findings.push_back(examine_gamepad(machine));
    return findings;
}

Verdict verdict_on(const std::vector<Finding>& findings) {
    if (!works(findings, "graphics")) return {};
    return {works(findings, "screen"), works(findings, "headset")};
}

std::string report_of(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings)
        text += fmt::format("{:<10} {:<5} {}\n", finding.what, word_of(finding.health), finding.text);
    const Verdict verdict = verdict_on(findings);
    text += fmt::format(
        "\nOn the desk: {}. In a headset: {}.\n", verdict.desk ? "yes" : "no", verdict.headset ? "yes" : "no"
    );
    const auto first =
        std::find_if(findings.begin(), findings.end(), [](const Finding& f) { return !f.advice.empty(); });
    if (first != findings.end()) text += fmt::format("To do first ({}): {}\n", first->what, first->advice);
    return text;
}

}  // namespace feelem::viewer
