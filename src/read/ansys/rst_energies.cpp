// SPDX-License-Identifier: Apache-2.0
// Must: tell 0 from "this element has none", which Ansys writes as 2^-100.
// Assumes: the order volume, stiffness, artificial, kinetic energy, proved on real files: volumes are those
// of the shapes; in modes of unit mass both energies are half of the square of the angular frequency.
#include "read/ansys/rst_energies.hpp"

#include "read/ansys/rst_tables.hpp"

#include "feelem/error.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace feelem::rst {
namespace {

struct Energy {
    std::string_view name;
    std::string_view label;
};
/// In the order of the record.
constexpr std::array kEnergies{
    Energy{"element_volume", "VOLU"},
    Energy{"strain_energy", "SENE"},
    Energy{"artificial_energy", "AENE"},
    Energy{"kinetic_energy", "KENE"},
};
constexpr double kNoEnergy = 0x1p-100;

bool is_structural(const ResultSet& set) {
    return std::ranges::any_of(set.dofs, [](std::int32_t code) { return code >= 1 && code <= 3; });
}

using Present = std::array<bool, kEnergies.size()>;

/// Looks at the first element of each kind that is drawn.
Present present_in(const ElementSource& source, const ResultSet& set) {
    Present present{};
    try {
        ElementTables tables(source.records, set, source.mesh.element_count, kEnergies[0].name);
        std::vector<bool> seen(source.mesh.kinds.size());
        std::vector<double> values;
        for (const std::uint32_t at : source.order) {
            const FileElement& element = source.mesh.elements[at];
            if (seen[element.kind]) continue;
            seen[element.kind] = true;
            if (!tables.go_to(element.place) || !tables.read(kEnergyEntry, values)) continue;
            for (std::size_t i = 0; i < std::min(present.size(), values.size()); ++i)
                present[i] = present[i] || values[i] != kNoEnergy;
        }
    } catch (const Error&) {
        return {};  // The rest of the set may be whole; its elements are told of when they are read.
    }
    return present;
}

}  // namespace

std::vector<EnergyResult> list_energies(const ResultSets& sets, const ElementSource& source) {
    std::vector<EnergyResult> out;
    std::optional<Present> present;
    for (std::size_t i = 0; i < sets.sets.size(); ++i) {
        const ResultSet& set = sets.sets[i];
        if (set.elements == 0 || !set.has(Item::Energy) || set.complex == Complex::Imaginary) continue;
        // All sets of a file are of one analysis.
        if (!present) present = present_in(source, set);
        // What parts of a complex response, or other fields, store here is not known.
        const bool energies = is_structural(set) && set.complex == Complex::No;
        for (std::size_t place = 0; place < kEnergies.size(); ++place) {
            if (!(*present)[place] || (place > 0 && !energies)) continue;
            EnergyResult result;
            result.info.name = kEnergies[place].name;
            result.info.solver_name = kEnergies[place].label;
            result.info.components = {"value"};
            result.info.step = set.step;
            result.info.location = Location::Elemental;
            result.info.on_request = true;
            result.set = i;
            result.place = place;
            out.push_back(std::move(result));
        }
    }
    return out;
}

ElementValues read_energy(const ElementSource& source, const ResultSet& set, const EnergyResult& result) {
    ElementValues out;
    out.values.assign(source.mesh.mesh.element_count(), std::numeric_limits<float>::quiet_NaN());
    ElementTables tables(source.records, set, source.mesh.element_count, result.info.name);
    std::vector<double> values;
    for (const std::uint32_t at : source.order) {
        const FileElement& element = source.mesh.elements[at];
        if (!tables.go_to(element.place) || !tables.read(kEnergyEntry, values)) continue;
        if (result.place >= values.size() || values[result.place] == kNoEnergy) continue;
        const StoredValue stored = stored_value(values[result.place]);
        out.values[raw(element.index)] = stored.value;
        if (!stored.is_number) ++out.without_number;
    }
    return out;
}

}  // namespace feelem::rst
