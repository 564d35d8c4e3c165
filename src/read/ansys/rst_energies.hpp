// SPDX-License-Identifier: Apache-2.0
// Volume and energies of elements, as Ansys stores them.
#pragma once

#include "read/ansys/rst_element.hpp"

#include <cstddef>
#include <vector>

namespace feelem::rst {

struct EnergyResult {
    ResultInfo info;
    std::size_t set = 0;
    std::size_t place = 0;  ///< In the record, from 0.
};

/// Of sets whose elements have such numbers: looks at the first element of each kind.
std::vector<EnergyResult> list_energies(const ResultSets& sets, const ElementSource& source);

/// One value an element of the mesh.
ElementValues read_energy(const ElementSource& source, const ResultSet& set, const EnergyResult& result);

}  // namespace feelem::rst
