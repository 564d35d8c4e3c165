// SPDX-License-Identifier: Apache-2.0
#include "scene_info.hpp"

#include "bound_text.hpp"
#include "scene/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace feelem::cli {
namespace {

void print_levels(const Scene& scene) {
    for (std::size_t i = 0; i < scene.levels.size(); ++i) {
        const SceneLevel& level = scene.levels[i];
        fmt::print(
            "\nLevel {}  {} triangles: values within {} % of their ranges, surface within {}\n",
            i + 1,
            level.triangles,
            bound_text(100 * level.bound),
            bound_text(level.distance_bound)
        );
        fmt::print("{:<28} {:<8} {:<14} {}\n", "Result", "Step", "Within", "Found");
        for (const SceneLevelValues& values : level.values) {
            const SceneResult& result = scene.results[values.result];
            const Step& step = scene.steps[result.values[values.values].step];
            fmt::print(
                "{:<28} {:<8} {:<14} {:.5g}\n",
                result.id,
                fmt::format("{}.{}", step.step, step.substep),
                bound_text(values.bound),
                std::max(values.max, values.shown)
            );
        }
    }
}

}  // namespace

void print_scene_info(const std::string& path, bool as_json) {
    const SceneFile file(path);
    const SceneDocument& document = file.document();
    const Scene& scene = document.scene;
    if (as_json) {
        fmt::print("{{\"version\":1,\"scene\":{}}}\n", scene.extras_json);
        return;
    }
    fmt::print("Scene    {}  (\"{}\")\n", path, scene.title);
    for (const InputRecord& input : scene.inputs)
        fmt::print("Input    {}  ({}, {} bytes)\n", input.path, input.format, input.bytes);
    for (std::size_t p = 0; p < scene.parts.size(); ++p) {
        fmt::print(
            "Part     {}: {}, {} triangles on {} vertices\n",
            scene.parts[p].name,
            scene.parts[p].kind,
            document.triangles[p],
            document.vertices[p]
        );
    }
    for (const SceneResult& result : scene.results) {
        const std::string_view unit = result.unit.empty() ? std::string_view("unit unknown") : result.unit;
        const std::string bound = result.bound > 0 ? "; within " + bound_text(result.bound) : "";
        fmt::print(
            "Result   {} ({}; at {} of {} steps{})\n",
            result.id,
            unit,
            result.values.size(),
            scene.steps.size(),
            bound
        );
    }
    if (scene.position_bound > 0) fmt::print("Places   within {}\n", bound_text(scene.position_bound));
    if (scene.levels.empty()) fmt::print("Levels   none: the skin is drawn whole\n");
    print_levels(scene);
}

}  // namespace feelem::cli
