// SPDX-License-Identifier: Apache-2.0
// read -> derive -> skin -> present -> write.
#include "base/letter_case.hpp"
#include "convert/make_levels.hpp"
#include "convert/prepared_source.hpp"
#include "convert/scene_plan.hpp"
#include "convert/selection.hpp"
#include "convert/stage.hpp"
#include "convert/stale_files.hpp"
#include "convert/work.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

namespace feelem {
namespace {

enum class OutputKind {
    Glb,
    Gltf,
    Ply,
    Vtu
};

OutputKind output_kind(const std::string& path) {
    const std::string suffix = lower_case(std::filesystem::path(path).extension().string());
    if (suffix == ".glb") return OutputKind::Glb;
    if (suffix == ".gltf") return OutputKind::Gltf;
    if (suffix == ".ply") return OutputKind::Ply;
    if (suffix == ".vtu") return OutputKind::Vtu;
    throw Error(
        Code::UnknownName,
        path,
        fmt::format(
            "\"{}\" is no suffix that can be written. Known are .glb, .gltf, .html, .ply and .vtu", suffix
        )
    );
}

/// Everything that can be known to fail is found before the work begins.
void check_output(const Job& job) {
    const OutputKind kind = output_kind(job.output);
    if (job.compress && kind != OutputKind::Glb && kind != OutputKind::Gltf)
        throw Error(Code::BadOption, job.output, "only scenes (.glb, .gltf, .html) can be compressed");
    const std::filesystem::path path(job.output);
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error)) {
        throw Error(Code::WriteFailed, job.output, "the folder " + folder.string() + " does not exist");
    }
    if (std::filesystem::is_directory(path, error)) {
        throw Error(Code::WriteFailed, job.output, "is a folder; expected the name of a file to write");
    }
    for (const std::string& input : job.inputs) {
        if (std::filesystem::equivalent(input, path, error)) {
            throw Error(Code::BadOption, job.output, "is an input too; the output needs a name of its own");
        }
    }
    remove_stale_files(job.output);
}

DefaultSteps default_steps_of(OutputKind kind) {
    switch (kind) {
    case OutputKind::Glb: return DefaultSteps::UpToTwenty;
    case OutputKind::Gltf: return DefaultSteps::All;
    case OutputKind::Ply:
    case OutputKind::Vtu: return DefaultSteps::Last;
    }
    return DefaultSteps::All;
}

/// .ply and .vtu hold one step: the last of those chosen that has a result.
std::vector<std::size_t> only_last(const ScenePlan& plan, std::vector<std::size_t> results) {
    if (plan.steps.empty()) return {};
    std::vector<std::size_t> kept;
    for (const PlannedResult& planned : plan.results) {
        for (const PlannedValues& values : planned.values) {
            if (values.step + 1 == plan.steps.size()) kept.push_back(values.source_result);
        }
    }
    std::erase_if(results, [&](std::size_t i) { return std::ranges::find(kept, i) == kept.end(); });
    return results;
}

void report_left_out(const Job& job, const ScenePlan& plan, Diagnostics& diagnostics) {
    if (plan.steps.size() < 2) return;
    const Step& written = plan.steps.back();
    diagnostics.add(
        Code::StepsLeftOut,
        job.output,
        fmt::format(
            "the file holds one step, {}.{} ({} {:g}); steps that were left out: {}. --steps names another",
            written.step,
            written.substep,
            word(written.kind),
            written.value,
            plan.steps.size() - 1
        )
    );
}

void run(Job job, Diagnostics& diagnostics, const Progress& progress, const EarlyShape& early) {
    const OutputKind kind = output_kind(job.output);
    check_output(job);
    const bool is_scene = kind == OutputKind::Glb || kind == OutputKind::Gltf;
    job.read.hash_early = is_scene;
    parse_levels(job.levels);
    const std::unique_ptr<ModelSource> source = open_job(job, diagnostics, progress);
    if (!source) throw Cancelled{};
    const auto steps = select_steps(source->steps(), job.steps, default_steps_of(kind), diagnostics);
    PreparedSource shown(*source, select_results(*source, steps, job.results), preparing_of(job));
    std::vector<std::size_t> results = shown.all_results();
    Work work{job, diagnostics, progress, shown, plan_scene(shown, shown.used_steps(), results), early};
    if (is_scene) return write_as_scene(work);
    report_left_out(job, work.plan, diagnostics);
    results = only_last(work.plan, std::move(results));
    work.plan = plan_scene(shown, shown.used_steps(), results);
    if (kind == OutputKind::Ply) return write_as_ply(work);
    write_as_vtu(work);
}

}  // namespace

bool convert(const Job& job, Diagnostics& diagnostics, const Progress& progress, const EarlyShape& early) {
    try {
        run(job, diagnostics, progress, early);
        if (progress) progress("write", 1);  // Done: too late to cancel.
        return true;
    } catch (const Cancelled&) {
        return false;
    }
}

}  // namespace feelem
