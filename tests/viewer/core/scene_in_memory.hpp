// SPDX-License-Identifier: Apache-2.0
// Scenes for tests of core: read whole from a file, or made of a few triangles.
#pragma once

#include "viewer/core/viewer.hpp"

#include "feelem/scene.hpp"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace feelem::viewer::test {

/// A scene as core wants it. Not to be moved: core keeps spans of it.
class SceneInMemory {
public:
    explicit SceneInMemory(Scene scene);
    SceneInMemory(const SceneInMemory&) = delete;
    SceneInMemory& operator=(const SceneInMemory&) = delete;

    ModelSource source();
    const Scene& scene() const { return scene_; }

private:
    struct Values {
        std::vector<float> values;
        std::vector<Validity> validity;
        std::size_t components = 0;
    };
    const Values& values(std::size_t result, std::size_t values);

    Scene scene_;
    ModelArrays arrays_;
    std::vector<std::array<float, 3>> positions_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<std::int64_t> node_ids_, element_ids_;
    std::map<std::array<std::size_t, 2>, std::unique_ptr<Values>> values_;
};

/// The shipped boiler, converted once a process: temperature seen, displacement heard, stress felt.
const std::string& boiler_path();

/// Adds a result of one step; one row a vertex, over all parts.
void add_result_to(
    Scene& scene,
    const std::string& name,
    std::vector<std::string> components,
    const std::vector<std::vector<float>>& steps
);

/// A square of 1 x 1 at z in two triangles, nodes from `first_node` on, corners counted from (0, 0, z) round.
ScenePart square_at(float z, std::int64_t first_node, const std::string& kind = "shell");

/// One square at z = 0 and one at z = -1 behind it, a step, no results.
Scene two_squares(const std::string& kind = "shell");

/// Temperature 10 20 30 40 at the near square's corners, 50 behind, seen, heard and felt from 0 to 100; 5
/// everywhere in a second step.
Scene sensed_squares();

/// A result of the presentation with a typed range.
PresentedResult presented(const std::string& key, const std::string& name, const std::string& component);

/// A ray that goes straight down the z axis from 5 above.
inline Ray down_at(float x, float y) {
    return {{x, y, 5}, {0, 0, -1}};
}

/// Core with its hierarchies, the model drawn in its own units at its own place.
struct Ready {
    explicit Ready(Scene scene);
    explicit Ready(const std::string& path) : Ready(load_scene(path)) {}
    /// One frame, `seconds` after the last one.
    Snapshot frame(FrameInput& input, double seconds = 0.01);
    void show();

    SceneInMemory memory;
    Viewer viewer;
    double time = 10;
};

}  // namespace feelem::viewer::test
