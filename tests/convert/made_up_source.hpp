// SPDX-License-Identifier: Apache-2.0
// A model that is all in the test: a brick, and results as the test lists them.
#pragma once

#include "support/meshes.hpp"

#include "feelem/model.hpp"

#include <string>
#include <utility>
#include <vector>

namespace feelem::test {

class MadeUpSource : public ModelSource {
public:
    std::vector<Step> made_steps;
    std::vector<ResultInfo> made_results;
    std::vector<InputRecord> made_inputs{{"a.frd", "", 0, ""}, {"folder/b.frd", "", 0, ""}};
    Mesh made_mesh = brick_grid(1, 1, 1);

    const Mesh& mesh() const override { return made_mesh; }
    std::span<const Step> steps() const override { return made_steps; }
    std::span<const ResultInfo> results() const override { return made_results; }
    Result load(std::size_t index) override { return {made_results[index], {}, {}, {}}; }
    std::span<const InputRecord> inputs() const override { return made_inputs; }

    void add_step(std::uint32_t input, int step, int substep, StepKind kind = StepKind::Time) {
        made_steps.push_back({input, step, substep, kind, static_cast<double>(substep), ""});
    }
    /// A result at the last step.
    ResultInfo& add_result(const std::string& name, std::vector<std::string> components, Shape shape) {
        ResultInfo info;
        info.name = name;
        info.components = std::move(components);
        info.shape = shape;
        info.step = static_cast<std::uint32_t>(made_steps.size() - 1);
        made_results.push_back(std::move(info));
        return made_results.back();
    }
    /// A step with a temperature.
    void add(std::uint32_t input, int step, int substep, StepKind kind = StepKind::Time) {
        add_step(input, step, substep, kind);
        add_result("temperature", {"value"}, Shape::Scalar);
    }
};

}  // namespace feelem::test
