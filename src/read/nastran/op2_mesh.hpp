// SPDX-License-Identifier: Apache-2.0
// The geometry tables of a .op2: grids, coordinate systems and elements.
#pragma once

#include "read/nastran/op2_records.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <span>

namespace feelem::op2 {

/// From GEOM1 and GEOM2 (or GEOM1S ...); without GEOM1 places are BGPDT's. Scalar points are nodes without a
/// place. Without nodes when the file holds none of these tables.
Mesh read_mesh(const Input& input, const Layout& layout, Diagnostics& diagnostics);

/// Throws Error(MeshesDiffer), with numbers, when a grid stands elsewhere or an element has other nodes under
/// the same id. What only one of the two has is no contradiction: decks and result files hold parts.
void check_same_ids(const Mesh& deck, const Mesh& own, const Input& input);

/// Throws Error(MeshesDiffer), with numbers, when the deck does not have half of these grids: then it is that
/// of another model, whatever numbers they happen to share.
void check_most_are_known(const Mesh& deck, std::span<const NodeId> ids, const Input& input);

}  // namespace feelem::op2
