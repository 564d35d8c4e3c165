// SPDX-License-Identifier: Apache-2.0
// Does with a model what the rest of Feelem does, and says what is wrong with it: for hostile and fuzzed
// inputs.
#pragma once

#include "feelem/model.hpp"

#include <string>

namespace feelem::test {

/// Touches the mesh and loads every result. Empty when all is well: indexes in range, coordinates and rows as
/// many as there should be. Errors of load() count as well (a damaged block is one). Other exceptions pass.
std::string exercise(ModelSource& model);

}  // namespace feelem::test
