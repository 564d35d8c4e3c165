// SPDX-License-Identifier: Apache-2.0
// Point and cell arrays of leaves: their names, and their values in the order of nodes and elements.
#pragma once

#include "read/exchange/neutral_form.hpp"
#include "vtk/vtk_mesh.hpp"
#include "vtk/vtk_readers.hpp"

#include <vector>

namespace feelem::exchange {

/// Arrays of numbers that are no ids, in order of first appearance; `step` is left to the caller.
std::vector<NeutralResult> arrays_of(const std::vector<Leaf>& leaves);

/// Each number rounded once to float; NaN where no leaf gives one.
std::vector<float> values_of(
    const std::vector<Leaf>& leaves, const Merged& merged, const NeutralResult& result
);

}  // namespace feelem::exchange
