// SPDX-License-Identifier: Apache-2.0
// What is in the inputs: mesh, skin, steps, and every result with its ranges over the whole model.
#include "convert/model_values.hpp"
#include "convert/prepared_source.hpp"
#include "convert/selection.hpp"
#include "convert/skin_options.hpp"
#include "convert/stage.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace feelem {
namespace {

std::optional<std::array<Point3, 2>> bounds_of_elements(const Mesh& mesh) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Point3 low{kInfinity, kInfinity, kInfinity};
    Point3 high{-kInfinity, -kInfinity, -kInfinity};
    for (const ElementBlock& block : mesh.blocks) {
        for (const NodeIndex node : block.nodes) {
            if (node == kNoNode) continue;
            const Point3& point = mesh.coordinates[raw(node)];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (point[axis] < low[axis]) low[axis] = point[axis];
                if (point[axis] > high[axis]) high[axis] = point[axis];
            }
        }
    }
    if (!(low[0] <= high[0] && low[1] <= high[1] && low[2] <= high[2])) return std::nullopt;
    return std::array{low, high};
}

void describe_mesh(const Mesh& mesh, ModelReport& report) {
    report.nodes = mesh.node_count();
    report.elements = mesh.element_count();
    std::vector<std::uint64_t> by_part(mesh.parts.size(), 0);
    for (const ElementBlock& block : mesh.blocks) {
        report.elements_by_type.emplace_back(element_row(block.type).name, block.ids.size());
        for (const PartIndex part : block.parts) ++by_part[raw(part)];
    }
    for (const auto& [type, count] : mesh.skipped_elements) {
        report.skipped_elements.emplace_back(type, count);
        report.elements += count;
    }
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        report.parts.emplace_back(mesh.parts[i].name, by_part[i]);
    }
    for (const NodeSet& set : mesh.node_sets) report.node_sets.emplace_back(set.name, set.nodes.size());
    for (const ElementSet& set : mesh.element_sets) {
        report.element_sets.emplace_back(set.name, set.elements.size());
    }
    report.bounds = bounds_of_elements(mesh);
    report.length_unit = mesh.length_unit;
}

/// The skin's figures; its arrays are gone again when this returns.
std::optional<SkinReport> describe_skin(const Mesh& mesh, const Job& job, Diagnostics& diagnostics) {
    try {
        return make_skin(mesh, skin_options(job), diagnostics).report;
    } catch (const Error& error) {
        if (error.code() != Code::NoElements) throw;
        return std::nullopt;  // Nodes alone: there is still something to tell.
    }
}

/// The sum of a reaction over all nodes; nothing for other results, and for amplitudes, which have no sum.
std::optional<ReactionSum> sum_of_reaction(const Result& result) {
    const ResultInfo& info = result.info;
    const bool is_linear = info.complex != Complex::Amplitude && info.complex != Complex::Phase;
    const bool is_sum = info.name.starts_with("reaction_") && info.location == Location::Nodal &&
                        info.system.empty() && is_linear && info.shape != Shape::Other;
    if (!is_sum) return std::nullopt;
    const std::size_t width = result.component_count();
    const std::size_t leading = info.shape == Shape::Vector ? std::min<std::size_t>(width, 3) : 1;
    ReactionSum reaction{info, std::vector<double>(leading, 0.0), 0};
    reaction.info.components.resize(leading);
    for (std::size_t row = 0; row < result.row_count(); ++row) {
        bool any = false;
        for (std::size_t c = 0; c < leading; ++c) {
            const float value = result.values[row * width + c];
            if (std::isnan(value)) continue;
            any = true;
            reaction.sum[c] += static_cast<double>(value);
        }
        if (any) ++reaction.nodes;
    }
    return reaction;
}

/// Every result, one at a time, and the steps that they stand at; steps without results are listed too.
void describe_results(
    PreparedSource& shown, std::vector<std::size_t> steps, const Progress& progress, ModelReport& report
) {
    for (const std::size_t step : shown.used_steps()) {
        if (std::ranges::find(steps, step) == steps.end()) steps.push_back(step);  // An envelope.
    }
    for (const std::size_t step : steps) report.steps.push_back(shown.steps()[step]);
    for (std::size_t i = 0; i < shown.results().size(); ++i) {
        report_progress(progress, "results", fraction_of(i, shown.results().size()));
        // Heads alone: names and steps were read when the inputs were opened.
        const Result result = report.is_brief ? Result{shown.results()[i], {}, {}, {}} : shown.load(i);
        const auto at = std::ranges::find(steps, static_cast<std::size_t>(result.info.step));
        const auto step = static_cast<std::uint32_t>(at - steps.begin());
        report.results.push_back({result.info, {}});
        report.results.back().info.step = step;
        if (report.is_brief) continue;
        report.results.back().ranges = ranges_over_model(shown.mesh(), result);
        if (auto reaction = sum_of_reaction(result)) {
            reaction->info.step = step;
            report.reactions.push_back(std::move(*reaction));
        }
    }
}

}  // namespace

std::optional<ModelReport> report_model(
    const Job& given, Diagnostics& diagnostics, const Progress& progress
) {
    Job job = given;
    job.read.hash_inputs = !job.brief;
    try {
        const std::unique_ptr<ModelSource> source = open_job(job, diagnostics, progress);
        if (!source) return std::nullopt;
        ModelReport report;
        const auto inputs = source->inputs();
        report.inputs.assign(inputs.begin(), inputs.end());
        describe_mesh(source->mesh(), report);
        report_progress(progress, "skin", 0);
        report.skin_method = job.skin.method;
        report.is_brief = job.brief;
        if (!job.brief) report.skin = describe_skin(source->mesh(), job, diagnostics);

        const auto steps = select_steps(source->steps(), job.steps, DefaultSteps::All, diagnostics);
        const std::string_view wanted = job.results.empty() ? "all" : std::string_view(job.results);
        PreparedSource shown(*source, select_results(*source, steps, wanted), preparing_of(job));
        describe_results(shown, steps, progress, report);
        report_progress(progress, "results", 1);
        return report;
    } catch (const Cancelled&) {
        return std::nullopt;
    }
}

std::string_view version() {
    return FEELEM_VERSION;
}

}  // namespace feelem
