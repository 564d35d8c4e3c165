// SPDX-License-Identifier: Apache-2.0
// derive -> skin -> write, for the formats of other programs: one step each.
#include "convert/model_values.hpp"
#include "convert/scene_values.hpp"
#include "convert/stage.hpp"
#include "convert/work.hpp"

#include "feelem/write.hpp"

#include <map>
#include <utility>
#include <vector>

namespace feelem {
namespace {

/// The step that the file holds: the plan has one at most.
const Step* step_of(const ScenePlan& plan) {
    return plan.steps.empty() ? nullptr : &plan.steps.back();
}

}  // namespace

void write_as_ply(Work& work) {
    const Surface surface = skin_of(work);
    std::vector<NamedField> fields;
    SceneValueStore store(work.source, surface, work.plan);
    store.read_all(work.progress);
    report_interpolation(work, store.interpolated());
    report_progress(work.progress, "write", 0);
    for (std::size_t i = 0; i < work.plan.results.size(); ++i) {
        const PlannedResult& planned = work.plan.results[i];
        // A scalar's id names its component already: stress_von_mises.
        const bool is_scalar = planned.components.size() == 1;
        fields.push_back(
            {planned.scene.id,
             is_scalar ? std::vector<std::string>{"value"} : planned.components,
             store.take_field(i, 0)}
        );
    }
    write_ply(work.job.output, work.source.mesh(), surface, fields, step_of(work.plan));
}

void write_as_vtu(Work& work) {
    std::vector<Result> results;
    std::map<std::size_t, std::vector<const PlannedResult*>> users;
    for (const PlannedResult& planned : work.plan.results) {
        users[planned.values.front().source_result].push_back(&planned);
    }
    for (const auto& [index, planned] : users) {
        report_progress(work.progress, "results", fraction_of(results.size(), work.plan.results.size()));
        Result result = work.source.load(index);
        for (const PlannedResult* piece : planned) {
            const bool is_whole = piece->components.size() > 1 || piece->components.front() == "value";
            const bool is_turned = !result.info.system.empty() && piece == planned.front();
            if (is_turned) result.info.name += "_cylindrical";
            if (is_whole) result.info.name = piece->scene.id;  // "stress_top": unlike its other layers
            if (!piece->scene.derived) continue;
            results.push_back(component_of(result, piece->components.front()));
            results.back().info.name = piece->scene.id;
            results.back().info.components = {"value"};
        }
        results.push_back(std::move(result));
    }
    report_progress(work.progress, "write", 0);
    write_vtu(work.job.output, work.source.mesh(), results, step_of(work.plan));
}

}  // namespace feelem
