// SPDX-License-Identifier: Apache-2.0
// What is in the inputs: mesh, skin, steps, and every result with its ranges over the whole model.
#include "convert/model_values.hpp"
#include "convert/selection.hpp"
#include "convert/skin_options.hpp"
#include "convert/stage.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace

std::optional<ModelReport> report_model(const Job& job, Diagnostics& diagnostics, const Progress& progress) {
    try {
        const std::unique_ptr<ModelSource> source = open_job(job, diagnostics, progress);
        if (!source) return std::nullopt;
        ModelReport report;
        const auto inputs = source->inputs();
        report.inputs.assign(inputs.begin(), inputs.end());
        describe_mesh(source->mesh(), report);
        report_progress(progress, "skin", 0);
        report.skin_method = job.skin.method;
        report.skin = describe_skin(source->mesh(), job, diagnostics);

        const auto steps = select_steps(source->steps(), job.steps, DefaultSteps::All, diagnostics);
        const auto results = select_results(*source, steps, job.results);
        for (const std::size_t step : steps) report.steps.push_back(source->steps()[step]);
        for (std::size_t i = 0; i < results.size(); ++i) {
            report_progress(progress, "results", fraction_of(i, results.size()));
            const Result result = load_prepared(*source, results[i], job.average);
            report.results.push_back({result.info, ranges_over_model(source->mesh(), result)});
            const auto step = std::ranges::find(steps, static_cast<std::size_t>(result.info.step));
            report.results.back().info.step = static_cast<std::uint32_t>(step - steps.begin());
        }
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
