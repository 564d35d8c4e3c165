// SPDX-License-Identifier: Apache-2.0
// A result of one mesh on another of the same model.
#pragma once

#include "read/mesh_agreement.hpp"

#include "feelem/result.hpp"

#include <cstdint>

namespace feelem {

/// Values go by node, element and part to where the map says; places that get none are missing. `left_out`
/// counts rows with a value that have no place in the mesh shown.
Result remap_result(const Result& result, const MeshMap& map, const Mesh& shown, std::uint64_t& left_out);

}  // namespace feelem
