// SPDX-License-Identifier: Apache-2.0
#include "vtk/vtk_model.hpp"

#include "read/exchange/neutral_form.hpp"
#include "vtk/vtk_arrays.hpp"
#include "vtk/vtk_mesh.hpp"
#include "vtk/vtk_readers.hpp"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

namespace feelem::exchange {
namespace {

/// Where a file says that all steps have the same arrays, the first step's stand for all.
std::vector<NeutralResult> results_of(VtkReader& reader, const std::vector<Leaf>& first, std::size_t steps) {
    const std::vector<NeutralResult> arrays = arrays_of(first);
    std::vector<NeutralResult> results;
    for (std::size_t step = 0; step < steps; ++step) {
        const bool known = step == 0 || reader.same_arrays();
        for (NeutralResult result : known ? arrays : arrays_of(reader.read(step))) {
            result.step = static_cast<std::uint32_t>(step);
            results.push_back(std::move(result));
        }
    }
    return results;
}

}  // namespace

std::string list_vtk(const std::string& format, const std::string& path) {
    const auto reader = open_vtk(format, path);
    const std::vector<double> times = reader->times();
    const std::vector<Leaf> leaves = reader->read(0);
    if (leaves.empty()) throw std::runtime_error("the file holds no mesh");
    NeutralModel model;
    reader->add_sets(merge(leaves, reader->own_format(), model), model);
    if (model.types.empty() && model.skipped.empty())
        throw std::runtime_error("the file holds points but no cells: it was cut, or is no mesh");
    const std::size_t steps = times.empty() ? 1 : times.size();
    model.results = results_of(*reader, leaves, steps);
    if (!model.results.empty()) {
        for (std::size_t i = 0; i < steps; ++i) {
            Step step;
            step.step = static_cast<std::int32_t>(i) + 1;
            step.kind = times.empty() ? StepKind::Other : StepKind::Time;
            step.value = times.empty() ? 0 : times[i];
            model.steps.push_back(std::move(step));
        }
    }
    return write_model(model);
}

std::string load_vtk(
    const std::string& format, const std::string& path, const std::vector<NeutralResult>& results
) {
    NeutralWriter to(Answer::Values);
    std::vector<Leaf> leaves;
    Merged merged;
    std::uint64_t digest = 0;
    std::optional<std::uint32_t> step;
    for (const NeutralResult& result : results) {
        if (step != result.step) {
            // A reader for each step: what one keeps of the step before would stand where a file has nothing.
            const auto reader = open_vtk(format, path);
            reader->times();
            leaves = reader->read(result.step);
            NeutralModel model;
            merged = merge(leaves, reader->own_format(), model);
            digest = mesh_digest(model);
            step = result.step;
        }
        write_values(to, digest, values_of(leaves, merged, result));
    }
    return to.take();
}

}  // namespace feelem::exchange
