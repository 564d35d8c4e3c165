// SPDX-License-Identifier: Apache-2.0
// Several sources as one model: one mesh, the steps and results of all, each with its input.
#pragma once

#include "base/input.hpp"

#include "feelem/model.hpp"

#include <memory>
#include <string>
#include <vector>

namespace feelem {

/// Throws Error(MeshesDiffer), with numbers, unless both hold the same nodes, coordinates and elements under
/// the same ids. Coordinates agree to the six digits of a text .frd; parts need not agree.
void check_same_mesh(const Mesh& first, const Mesh& second, const std::string& second_name);

/// A source and which of the model's inputs it was made of.
struct OpenedSource {
    std::unique_ptr<ModelSource> source;
    std::vector<std::uint32_t> inputs;  ///< Source's input -> model's input.
};

/// An input as the user gave it, for its record.
struct UsedInput {
    Input input;
    std::string format;
};

/// Sources' meshes must agree with the first one's. At least one source.
std::unique_ptr<ModelSource> merge_sources(std::vector<OpenedSource> sources, std::vector<UsedInput> inputs);

}  // namespace feelem
