// SPDX-License-Identifier: Apache-2.0
// A mesh and what was said about it as text: two readings that should be one are compared by it.
#pragma once

#include "feelem/error.hpp"
#include "feelem/mesh.hpp"

#include <string>

namespace feelem::test {

/// Everything that a mesh says; coordinates by their bits.
std::string mesh_text(const Mesh& mesh);

/// Each diagnostic with its code, place and count.
std::string diagnostics_text(const Diagnostics& diagnostics);

}  // namespace feelem::test
