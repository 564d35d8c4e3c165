// SPDX-License-Identifier: Apache-2.0
// The rows of one *ELEMENT.
#pragma once

#include "read/abaqus/deck_model.hpp"

namespace feelem::abaqus {

/// Of a type without a shape only the ids are kept. Rows of an unknown type are reported and counted.
ElementRun read_elements(const Deck& deck, const Keyword& keyword, Diagnostics& diagnostics);

}  // namespace feelem::abaqus
