// SPDX-License-Identifier: Apache-2.0
// Solids that should not be as they are: listed twice, or turned inside out.
#pragma once

#include "skin/outline.hpp"

#include "feelem/mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace feelem {

/// Distinct corners of a solid in ascending order, then kNoNode.
using CornerSet = std::array<NodeIndex, 8>;
CornerSet corner_set(const ElementBlock& block, std::size_t position);

/// One flag an element: a solid with the same corners as an earlier one.
std::vector<bool> find_duplicate_solids(const Mesh& mesh);

/// Whether the corners of a solid enclose a negative volume; false for flat ones and unknown coordinates.
bool is_inverted(const Mesh& mesh, const ElementBlock& block, std::size_t position);

std::uint64_t count_inverted_solids(const Mesh& mesh, const std::vector<bool>& set_aside);

/// Marks facets of inverted solids as flipped; says whether there was one.
bool flip_facets_of_inverted_solids(const Mesh& mesh, std::vector<FacetRef>& facets);

}  // namespace feelem
