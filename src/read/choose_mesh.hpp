// SPDX-License-Identifier: Apache-2.0
// Of several sources with meshes of their own: which mesh is shown, and how the others' results get there.
#pragma once

#include "read/merged_model.hpp"
#include "read/mesh_agreement.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace feelem {

struct MeshChoice {
    std::size_t shown = 0;                     ///< The source whose mesh is shown.
    std::vector<std::optional<MeshMap>> maps;  ///< By source; none: the mesh shown is its own.
};

/// The mesh shown has elements, and most results of all sources find their nodes in it; of equals the one
/// that carries results itself, then the one with more elements, then the first. Throws Error(MeshesDiffer)
/// when a source has too little in common with it. What does not agree is told.
MeshChoice choose_mesh(
    std::span<const OpenedSource> sources, std::span<const std::string> names, Diagnostics& diagnostics
);

}  // namespace feelem
