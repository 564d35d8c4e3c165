// SPDX-License-Identifier: Apache-2.0
// Scopes of a deck -> one Mesh: instances placed, ids made unique, sets and parts named.
#pragma once

#include "read/abaqus/deck_model.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

namespace feelem::abaqus {

/// Takes the model apart as it goes. Instances that repeat ids: those of the second get an offset of a power
/// of ten, those of the third twice that, and so on (IdsOffset).
Mesh build_mesh(const Deck& deck, DeckModel& model, Diagnostics& diagnostics);

}  // namespace feelem::abaqus
