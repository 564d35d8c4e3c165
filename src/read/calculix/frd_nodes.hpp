// SPDX-License-Identifier: Apache-2.0
// The nodes of an .frd file.
#pragma once

#include "base/input.hpp"
#include "model/mesh_builder.hpp"
#include "read/calculix/frd_blocks.hpp"

#include "feelem/diagnostics.hpp"

namespace feelem::frd {

/// Throws Error(BadNumber) for a record that cannot be understood.
void read_nodes(const Input& input, const Layout& layout, MeshBuilder& builder, Diagnostics& diagnostics);

}  // namespace feelem::frd
