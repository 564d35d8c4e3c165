// SPDX-License-Identifier: Apache-2.0
#include "viewer/core/scene_in_memory.hpp"

#include "support/paths.hpp"

#include "feelem/convert.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace feelem::viewer::test {

SceneInMemory::SceneInMemory(Scene scene) : scene_(std::move(scene)) {
    for (const ScenePart& part : scene_.parts) {
        const auto first = static_cast<std::uint32_t>(positions_.size());
        const auto first_triangle = static_cast<std::uint32_t>(triangles_.size());
        arrays_.parts.push_back(
            {first,
             static_cast<std::uint32_t>(part.positions.size()),
             first_triangle,
             static_cast<std::uint32_t>(part.triangles.size())}
        );
        positions_.insert(positions_.end(), part.positions.begin(), part.positions.end());
        for (auto triangle : part.triangles) {
            for (std::uint32_t& corner : triangle) corner += first;
            triangles_.push_back(triangle);
        }
        node_ids_.insert(node_ids_.end(), part.node_ids.begin(), part.node_ids.end());
        element_ids_.insert(element_ids_.end(), part.element_ids.begin(), part.element_ids.end());
    }
    arrays_.positions = positions_;
    arrays_.triangles = triangles_;
    arrays_.node_ids = node_ids_;
    arrays_.element_ids = element_ids_;
    arrays_.low.fill(std::numeric_limits<float>::infinity());
    arrays_.high.fill(-std::numeric_limits<float>::infinity());
    for (const auto& position : positions_) {
        for (std::size_t k = 0; k < 3; ++k) {
            arrays_.low[k] = std::min(arrays_.low[k], position[k]);
            arrays_.high[k] = std::max(arrays_.high[k], position[k]);
        }
    }
}

const SceneInMemory::Values& SceneInMemory::values(std::size_t result, std::size_t values) {
    auto& kept = values_[{result, values}];
    if (kept) return *kept;
    kept = std::make_unique<Values>();
    const SceneResult& of = scene_.results[result];
    kept->components = of.components.size();
    for (std::size_t p = 0; p < scene_.parts.size(); ++p) {
        const std::size_t vertices = scene_.parts[p].positions.size();
        const auto field = std::ranges::find_if(scene_.fields, [&](const SceneField& f) {
            return f.result == result && f.step == of.values[values].step && f.part == p;
        });
        if (field == scene_.fields.end()) {
            kept->values.resize(
                kept->values.size() + vertices * kept->components, std::numeric_limits<float>::quiet_NaN()
            );
            kept->validity.resize(kept->validity.size() + vertices, Validity::Missing);
            continue;
        }
        kept->values.insert(kept->values.end(), field->values.begin(), field->values.end());
        kept->validity.insert(kept->validity.end(), field->validity.begin(), field->validity.end());
    }
    return *kept;
}

ModelSource SceneInMemory::source() {
    return {&scene_, arrays_, [this](std::size_t result, std::size_t step) {
                const Values& found = values(result, step);
                return FieldSpan{found.components, found.values, found.validity};
            }};
}

const std::string& boiler_path() {
    static const std::string path = [] {
        // CTest runs each test in a process of its own.
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        Job job;
        job.inputs = {feelem::test::project_file("examples/boiler/boiler.frd")};
        job.output = feelem::test::scratch_folder("viewer_core_" + test) + "/boiler.glb";
        job.length_unit = "mm";
        job.units = {{"temperature", "degC"}, {"displacement", "mm"}, {"stress", "MPa"}};
        job.presentation_file = feelem::test::project_file("examples/boiler/boiler.presentation.json");
        job.levels = "8000";
        Diagnostics diagnostics;
        convert(job, diagnostics, {});
        return job.output;
    }();
    return path;
}

void add_result_to(
    Scene& scene,
    const std::string& name,
    std::vector<std::string> components,
    const std::vector<std::vector<float>>& steps
) {
    SceneResult result;
    result.id = result.quantity = result.title = name;
    result.components = std::move(components);
    const std::size_t width = result.components.size();
    for (std::size_t step = 0; step < steps.size(); ++step) {
        result.values.push_back({step, {}, {}, 0});
        std::size_t at = 0;
        for (std::size_t p = 0; p < scene.parts.size(); ++p) {
            const std::size_t vertices = scene.parts[p].positions.size();
            SceneField field{scene.results.size(), step, p, {}, {}};
            for (std::size_t i = 0; i < vertices; ++i) {
                bool is_missing = false;
                for (std::size_t k = 0; k < width; ++k) {
                    const float value = steps[step].at(at++);
                    is_missing |= std::isnan(value);
                    field.values.push_back(value);
                }
                field.validity.push_back(is_missing ? Validity::Missing : Validity::Solver);
            }
            scene.fields.push_back(std::move(field));
        }
        if (scene.steps.size() <= step) {
            Step made;
            made.substep = static_cast<int>(step) + 1;
            scene.steps.push_back(made);
        }
    }
    scene.results.push_back(std::move(result));
}

ScenePart square_at(float z, std::int64_t first_node, const std::string& kind) {
    ScenePart part;
    part.name = "square";
    part.kind = kind;
    part.positions = {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
    part.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (std::int64_t i = 0; i < 4; ++i) part.node_ids.push_back(first_node + i);
    part.element_ids = {first_node * 10, first_node * 10 + 1};
    return part;
}

Scene two_squares(const std::string& kind) {
    Scene scene;
    scene.title = "two squares";
    scene.parts = {square_at(0, 1, kind), square_at(-1, 11, kind)};
    return scene;
}

PresentedResult presented(const std::string& key, const std::string& name, const std::string& component) {
    PresentedResult result;
    result.key = key;
    result.name = name;
    result.component = component;
    result.range_mode = "manual";
    result.lo = 0;
    result.hi = 100;
    return result;
}

Scene sensed_squares() {
    Scene scene = two_squares();
    add_result_to(
        scene, "temperature", {"value"}, {{10, 20, 30, 40, 50, 50, 50, 50}, std::vector<float>(8, 5)}
    );
    scene.presentation.results = {presented("T", "temperature", "value")};
    for (const Sense sense : {Sense::Colour, Sense::Pitch, Sense::Pulses}) {
        PresentedEffect effect;
        effect.result = "T";
        effect.sense = sense;
        scene.presentation.effects.push_back(effect);
    }
    return scene;
}

Ready::Ready(Scene scene) : memory(std::move(scene)), viewer(memory.source()) {
    viewer.prober.grow();
    viewer.state.placement = glm::mat4(1);
    show();
}

void Ready::show() {
    viewer.prober.set_look(make_look(viewer.state, viewer.model, false));
}

Snapshot Ready::frame(FrameInput& input, double seconds) {
    time += seconds;
    input.time = time;
    update(viewer, input);
    const Snapshot snapshot = snapshot_of(viewer, input);
    input.commands.clear();
    return snapshot;
}

}  // namespace feelem::viewer::test
