// SPDX-License-Identifier: Apache-2.0
// Small scenes for tests, made without the skin stage: outer facets of bricks by a plain count.
#pragma once

#include "feelem/scene.hpp"

#include <memory>
#include <string>
#include <vector>

namespace feelem::test {

/// A mesh, its skin and results that can be asked for; keep it alive while `contents` is used.
struct Sample {
    Mesh mesh;
    Surface surface;
    SceneContents contents;
    std::vector<std::vector<SurfaceField>> fields;  ///< [result][values]
    std::vector<std::size_t> asked;                 ///< Results in the order in which they were asked for.
};

/// Outer facets of a mesh of bricks, each quad as four triangles round a centre; as skin does it.
Surface outer_facets(const Mesh& mesh, Domain domain);

/// nx x ny x nz bricks with one static step: temperature (scalar), displacement (vector), stress (tensor).
/// Values are made of the node ids: every one differs and none is round in binary.
std::unique_ptr<Sample> brick_sample(int nx, int ny, int nz);

/// Adds a result with a value at each step; `make(id, step, component)` for vertices with a node.
struct SampleResult {
    std::string id;
    Shape shape = Shape::Scalar;
    std::vector<std::string> components{"value"};
    std::string unit{};
};
void add_result(
    Sample& sample,
    const SampleResult& result,
    const std::function<float(std::int64_t, std::size_t, std::size_t)>& make
);

/// Temperature as colour in 10 bands, displacement as sound and shape (x 50), stress xx as pulses.
Presentation sample_presentation();

/// Writes the sample as build/scratch/<name>/scene.glb (or the suffix given) and returns the path.
std::string write_sample(
    const Sample& sample,
    const std::string& name,
    const SceneOptions& options = {},
    const std::string& file = "scene.glb"
);

}  // namespace feelem::test
