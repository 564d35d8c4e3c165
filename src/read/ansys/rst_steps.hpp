// SPDX-License-Identifier: Apache-2.0
// The sets of results in a file: which step each is, and where its records stand.
#pragma once

#include "read/ansys/rst_header.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/result.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace feelem::rst {

/// Bits of AvailData: what a set says that it holds.
enum class Item : std::uint8_t {
    Summable = 1,       ///< EMS
    Stress = 3,         ///< ENS
    Energy = 4,         ///< ENG
    Gradient = 5,       ///< EGR
    ElasticStrain = 6,  ///< EEL
    PlasticStrain = 7,  ///< EPL
    CreepStrain = 8,    ///< ECR
    ThermalStrain = 9,  ///< ETH
    EulerAngles = 10,   ///< EUL
    Flux = 11,          ///< EFX
    NotSummable = 13,   ///< EMN
};

struct ResultSet {
    Word base = 0;           ///< Pointers below are whole; 0 = not in the file.
    std::uint32_t step = 0;  ///< Into steps.
    Complex complex = Complex::No;
    std::size_t nodes = 0;            ///< Rows of the nodal solution.
    std::vector<std::int32_t> dofs;   ///< Codes of the solved unknowns.
    std::size_t columns = 0;          ///< Of a row: the unknowns and further ones.
    std::uint32_t available = 0;      ///< AvailData.
    std::int32_t harmonic_index = 0;  ///< Of cyclic symmetry.
    std::size_t reactions = 0;
    Word nodal = 0, elements = 0, reaction = 0, velocity = 0, acceleration = 0, nodal_averages = 0;

    bool has(Item item) const { return (available >> static_cast<unsigned>(item) & 1) != 0; }
};

struct ResultSets {
    std::vector<Step> steps;
    std::vector<ResultSet> sets;
};

/// Reads heads only. Sets whose heads are cut off are left out (TruncatedInput); so are sets on another mesh.
ResultSets read_sets(const Records& records, const ResultHeader& header, Diagnostics& diagnostics);

}  // namespace feelem::rst
