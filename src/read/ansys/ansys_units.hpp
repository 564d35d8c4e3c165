// SPDX-License-Identifier: Apache-2.0
// Units of length as Ansys declares them: by a unit's name or by a system of units.
#pragma once

#include "feelem/mesh.hpp"

#include <optional>
#include <string_view>

namespace feelem::ansys {

/// "m", "mm", "cm", "in", "ft", "um"; empty for any other name.
std::optional<LengthUnit> length_unit(std::string_view name);

/// By the label of /UNITS, of Workbench's "Data in consistent NMM units" or of .rst's code, in any case:
/// "SI", "MKS", "CGS", "BFT", "BIN", "MPA", "NMM", "uMKS". Empty for USER and what is not known.
std::optional<LengthUnit> length_unit_of_system(std::string_view system);

}  // namespace feelem::ansys
