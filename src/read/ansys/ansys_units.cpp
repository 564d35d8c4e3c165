// SPDX-License-Identifier: Apache-2.0
#include "read/ansys/ansys_units.hpp"

#include "base/letter_case.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace feelem::ansys {
namespace {

struct UnitRow {
    std::string_view name;
    double metres;
};
constexpr std::array kUnits{
    UnitRow{"m", 1},
    UnitRow{"mm", 0.001},
    UnitRow{"cm", 0.01},
    UnitRow{"in", 0.0254},
    UnitRow{"ft", 0.3048},
    UnitRow{"um", 1e-6}};

struct SystemRow {
    std::string_view system;
    std::string_view length;
};
/// NMM, NMMTON and NMMDAT are Workbench's names of the millimetre systems.
constexpr std::array kSystems{
    SystemRow{"SI", "m"},
    SystemRow{"MKS", "m"},
    SystemRow{"CGS", "cm"},
    SystemRow{"BFT", "ft"},
    SystemRow{"BIN", "in"},
    SystemRow{"MPA", "mm"},
    SystemRow{"NMM", "mm"},
    SystemRow{"NMMTON", "mm"},
    SystemRow{"NMMDAT", "mm"},
    SystemRow{"UMKS", "um"}};

}  // namespace

std::optional<LengthUnit> length_unit(std::string_view name) {
    const auto* found = std::ranges::find(kUnits, name, &UnitRow::name);
    if (found == kUnits.end()) return std::nullopt;
    return LengthUnit{std::string(name), found->metres};
}

std::optional<LengthUnit> length_unit_of_system(std::string_view system) {
    const std::string label = upper_case(system);
    const auto* found = std::ranges::find(kSystems, label, &SystemRow::system);
    return found == kSystems.end() ? std::nullopt : length_unit(found->length);
}

}  // namespace feelem::ansys
