// SPDX-License-Identifier: Apache-2.0
// Several sources as one model: one mesh, the steps and results of all, each with its input.
#pragma once

#include "base/input.hpp"
#include "read/early_digests.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/model.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace feelem {

/// For readers: a mesh that another source has already, in every node, place, element and part, is not held
/// twice. `own` is emptied then and `shared` returned, with the sets of both, also when `own` has no nodes;
/// else, and when sets of one name differ, `own` stays.
const Mesh* own_or_shared(Mesh& own, const Mesh* shared);

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

/// For readers that make one source of several files, and cannot keep two meshes: throws
/// Error(MeshesDiffer), with counts, unless both are the same.
void check_same_mesh(const Mesh& first, const Mesh& second, const std::string& second_name);

/// What ReadContext::mesh is for the next source: of those opened the first with elements and results, else
/// the first with elements, else the first; null when there is none.
const Mesh* mesh_for_next(std::span<const OpenedSource> sources);

/// One mesh is shown (choose_mesh.hpp), results of the others go to it by id. `kept_alive`: their meshes
/// may be looked at by the others, nothing more. `diagnostics` must outlive the model. At least one source.
/// `hash_inputs`: as ReadOptions says; `early`: digests of the first inputs that are under way. Throws
/// Error(MeshesDiffer).
std::unique_ptr<ModelSource> merge_sources(
    std::vector<OpenedSource> sources,
    std::vector<std::unique_ptr<ModelSource>> kept_alive,
    std::vector<UsedInput> inputs,
    Diagnostics& diagnostics,
    bool hash_inputs = true,
    std::unique_ptr<EarlyDigests> early = nullptr
);

}  // namespace feelem
