// SPDX-License-Identifier: Apache-2.0
// The meshes that skins are timed on: made in memory, the same every time.
#pragma once

#include "feelem/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace bench {

/// hex8, tet4 (six a cube), hex20, tet10: a cube of them. mixed: hexes, wedges and pyramids side by side, and
/// tets apart. plate: hex8, one layer thick. degenerate: hex8, half of them prisms with repeated nodes.
/// free=PATH: tetrahedra of free_tets.py. `numbering`: natural (x first); windowed (nodes and elements
/// shuffled among their 4,096 neighbours); random (all shuffled), as free meshers leave them. About `cells`
/// elements. Throws std::invalid_argument for an unknown word.
feelem::Mesh make_mesh(const std::string& kind, std::size_t cells, const std::string& numbering);

/// The value that node `index` carries, so that lost or mixed-up results show in a sum.
float value_at(std::uint32_t index);

/// What two programs must agree in, whatever the order of facets and vertices: the facets by the nodes at
/// their corners.
class FacetSum {
public:
    void add(std::span<std::uint32_t> corners);  ///< Sorts them.
    std::uint64_t sum = 0;
    std::uint64_t count = 0;
};

/// Bytes of resident memory now and the most since forget_peak().
std::size_t resident_bytes();
std::size_t peak_bytes();
void forget_peak();
/// User and system time of this process in seconds.
double cpu_seconds();

}  // namespace bench
