// SPDX-License-Identifier: Apache-2.0
// A scanned deck -> Mesh.
#pragma once

#include "read/ansys/cdb_deck.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

namespace feelem::ansys::cdb {

/// Streams over the blocks, releasing the inputs behind itself; `types`: what the user says of them, before
/// the deck's own. Throws Error on a damaged row.
Mesh read_mesh(const Deck& deck, const TypeTable& types, Diagnostics& diagnostics);

}  // namespace feelem::ansys::cdb
