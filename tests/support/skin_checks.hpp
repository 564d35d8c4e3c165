// SPDX-License-Identifier: Apache-2.0
// What must hold for the skin of any good mesh, however its elements are listed or numbered.
#pragma once

#include "feelem/mesh.hpp"
#include "feelem/skin.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace feelem::test {

/// The same mesh with the elements of each block in another order.
Mesh shuffled(const Mesh& mesh, unsigned seed);
/// The same mesh with other node numbers: the nodes stand in another order.
Mesh renumbered(const Mesh& mesh, unsigned seed);
/// The mirror image: x negated, so that every solid is inverted.
Mesh mirrored(const Mesh& mesh);
/// The mesh and a copy of it, far enough along x.
Mesh with_copy(const Mesh& mesh, double distance);
/// Every element of solid blocks with index in [first, last) listed once more.
Mesh with_duplicates(const Mesh& mesh, std::size_t first, std::size_t last);

/// Volume of all solids by the divergence theorem over each element's own facets, quads cut round their
/// centre and through their mid-side nodes as in the skin.
double volume_of_elements(const Mesh& mesh);

/// Owners of each facet of the solids by its corners: the slow and simple way.
std::map<std::vector<std::uint32_t>, int> facet_owners(const Mesh& mesh);

/// Fails the running test when the skin of the mesh, or of any variation of it, is not closed, oriented, as
/// large as its elements, or differs in its number of triangles. Returns the plain skin.
Surface check_skin(const Mesh& mesh, const SkinOptions& options = {});

}  // namespace feelem::test
