// SPDX-License-Identifier: Apache-2.0
// derive -> skin -> present -> write, for scenes.
#include "convert/make_levels.hpp"
#include "convert/presenting.hpp"
#include "convert/scene_values.hpp"
#include "convert/skin_options.hpp"
#include "convert/stage.hpp"
#include "convert/work.hpp"

#include "feelem/scene.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <utility>

namespace feelem {
namespace {

void fill_extremes(
    const PlannedResult& planned, SceneResult& result, std::size_t index, const SceneValueStore& store
) {
    for (std::size_t i = 0; i < planned.values.size(); ++i) {
        const std::vector<ComponentRange>& ranges = store.ranges(index, i);
        SceneValues& values = result.values[i];
        for (const ComponentRange& range : ranges) {
            values.missing_in_model = std::max(values.missing_in_model, range.missing);
            if (range.valid == 0) continue;
            if (!result.range) result.range = std::array{range.min, range.max};
            (*result.range)[0] = std::min((*result.range)[0], range.min);
            (*result.range)[1] = std::max((*result.range)[1], range.max);
        }
        if (ranges.size() != 1 || ranges.front().valid == 0) continue;
        values.min = Extreme{ranges.front().min, ranges.front().min_id};
        values.max = Extreme{ranges.front().max, ranges.front().max_id};
    }
}

/// As --skin names it; `check` with the inputs needs to know which facets to expect.
const char* skin_note(SkinMethod method) {
    if (method == SkinMethod::NodeList) return "node-list";
    return method == SkinMethod::All ? "all" : "exact";
}

std::string scene_title(const Job& job, const ModelSource& source) {
    if (!job.title.empty()) return job.title;
    if (std::string title = source.title(); !title.empty()) return title;
    return std::filesystem::path(job.output).stem().string();
}

/// What the shape's scene and the finished one have in common.
SceneContents shape_of(const Work& work, const Surface& surface) {
    SceneContents contents;
    contents.title = scene_title(work.job, work.source);
    contents.solver = work.source.solver();
    contents.mesh = &work.source.mesh();
    contents.surface = &surface;
    contents.up = work.job.up;
    contents.steps = work.plan.steps;
    contents.notes["skin"] = skin_note(work.job.skin.method);
    contents.notes["subdivide"] = std::to_string(work.job.skin.subdivide);
    return contents;
}

SceneOptions scene_options(const Job& job) {
    SceneOptions options;
    options.compress = job.compress;
    options.bound = job.compress_bound;
    return options;
}

/// The inputs are not named: their digests may still be on their way.
void offer_shape(const Work& work, const Surface& surface) {
    if (work.early.output.empty()) return;
    SceneContents contents = shape_of(work, surface);
    contents.presentation.title = contents.title;
    contents.notes["preview"] = "the shape alone, while results were being read";
    Diagnostics told_by_the_finished_scene;
    write_scene(contents, work.early.output, scene_options(work.job), told_by_the_finished_scene);
    if (work.early.stands) work.early.stands();
}

}  // namespace

void report_interpolation(const Work& work, std::uint64_t interpolated) {
    if (interpolated == 0) return;
    work.diagnostics.add(
        Code::MidsideInterpolated,
        "",
        "mid-side values of corner-only results are the mean of their edge's corners; they are marked with ~",
        interpolated
    );
}

Surface skin_of(const Work& work) {
    report_progress(work.progress, "skin", 0);
    SkinOptions options = skin_options(work.job);
    options.domain = work.plan.domain;
    return make_skin(work.source.mesh(), options, work.diagnostics);
}

void write_as_scene(Work& work) {
    Surface surface = skin_of(work);
    if (work.job.compress) order_for_drawing(surface);
    offer_shape(work, surface);
    SceneValueStore store(work.source, surface, work.plan);
    store.read_all(work.progress);
    report_interpolation(work, store.interpolated());

    SceneContents contents = shape_of(work, surface);
    report_progress(work.progress, "hash", 0);
    const auto inputs = work.source.inputs();
    contents.inputs.assign(inputs.begin(), inputs.end());
    if (auto list = surface_nodes_record(work.job)) contents.inputs.push_back(std::move(*list));
    std::size_t fields = 0, done = 0;
    for (std::size_t i = 0; i < work.plan.results.size(); ++i) {
        contents.results.push_back(work.plan.results[i].scene);
        fill_extremes(work.plan.results[i], contents.results.back(), i, store);
        fields += contents.results.back().values.size();
    }
    contents.presentation = make_presentation(
        {work.source.mesh(), surface, work.plan, store}, work.job.presentation_file, contents.title
    );
    contents.shown_step = choose_shown_step(work.plan, contents.presentation);
    if (!work.job.envelopes.empty()) contents.notes["envelopes"] = work.job.envelopes;
    if (store.interpolated() > 0) {
        contents.notes["midside_interpolated"] = std::to_string(store.interpolated());
    }
    const SceneOptions options = scene_options(work.job);
    make_levels(work, surface, store, options, contents);
    contents.load = [&](std::size_t result, std::size_t values) {
        report_progress(work.progress, "write", fraction_of(done++, fields));
        return store.take_field(result, values);
    };
    report_progress(work.progress, "write", 0);
    write_scene(contents, work.job.output, options, work.diagnostics);
}

}  // namespace feelem
