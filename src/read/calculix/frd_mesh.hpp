// SPDX-License-Identifier: Apache-2.0
// Nodes and elements of a .frd file -> Mesh.
#pragma once

#include "base/input.hpp"
#include "read/calculix/frd_blocks.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

namespace feelem::frd {

/// Streams over the two blocks, releasing the input behind itself. Throws Error on a damaged record.
Mesh read_mesh(const Input& input, const Layout& layout, Diagnostics& diagnostics);

}  // namespace feelem::frd
