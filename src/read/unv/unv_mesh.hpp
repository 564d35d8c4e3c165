// SPDX-License-Identifier: Apache-2.0
// Nodes, elements, groups and units of a universal file -> Mesh.
#pragma once

#include "base/input.hpp"
#include "read/unv/unv_datasets.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <cstdint>
#include <span>

namespace feelem::unv {

/// Throws Error on damaged records and where nothing can be read.
Mesh read_mesh(const Input& input, std::span<const Dataset> datasets, Diagnostics& diagnostics);

}  // namespace feelem::unv
