// SPDX-License-Identifier: Apache-2.0
// Results at the ends of beams, along the axes of the beam, as Ansys stores them under numbers.
#pragma once

#include "read/ansys/rst_element.hpp"

#include "feelem/diagnostics.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace feelem::rst {

struct BeamQuantity;

struct BeamResult {
    ResultInfo info;
    std::size_t set = 0;
    const BeamQuantity* quantity = nullptr;
};

/// Of the kinds of beams whose numbers are known; others are told (UnknownBlock), by name and count.
std::vector<BeamResult> list_beam_results(
    const ResultSets& sets,
    const ResultHeader& header,
    const FileMesh& mesh,
    const std::string& file,
    Diagnostics& diagnostics
);

ElementValues read_beam_values(const ElementSource& source, const ResultSet& set, const BeamResult& result);

}  // namespace feelem::rst
