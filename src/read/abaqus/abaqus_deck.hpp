// SPDX-License-Identifier: Apache-2.0
// Decks of Abaqus and CalculiX (.inp): the mesh with its sets and parts.
#pragma once

#include "read/read_format.hpp"

namespace feelem {

ReadFormat abaqus_deck_format();

}  // namespace feelem
