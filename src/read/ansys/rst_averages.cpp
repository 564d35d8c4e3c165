// SPDX-License-Identifier: Apache-2.0
// Results that Ansys averaged at nodes itself. Their index holds places of: numbers of elements, stress,
// elastic, plastic, creep and thermal strain; each a row a node of the solution.
#include "read/ansys/rst_nodal.hpp"

#include "feelem/error.hpp"

#include <array>
#include <string>
#include <string_view>

namespace feelem::rst {
namespace {

struct Average {
    std::size_t entry;  ///< In the index, from 0, of two words each.
    std::size_t width;
    Item item;
    std::string_view name;
    std::string_view label;
};
constexpr std::array kAverages{
    Average{1, 6, Item::Stress, "stress", "S"},
    Average{2, 7, Item::ElasticStrain, "elastic_strain", "EPEL"},
    Average{3, 7, Item::PlasticStrain, "plastic_strain", "EPPL"},
    Average{4, 7, Item::CreepStrain, "creep_strain", "EPCR"},
    Average{5, 8, Item::ThermalStrain, "thermal_strain", "EPTH"},
};

}  // namespace

std::vector<NodalResult> list_nodal_averages(
    const ResultSets& sets, const ResultHeader& header, const Records& records
) {
    std::vector<NodalResult> out;
    for (std::size_t i = 0; i < sets.sets.size(); ++i) {
        const ResultSet& set = sets.sets[i];
        if (set.nodal_averages == 0) continue;
        std::vector<std::int32_t> index;
        try {
            index = records.integers(set.nodal_averages);
        } catch (const Error&) {
            continue;  // The rest of the set may be whole.
        }
        for (const Average& average : kAverages) {
            const Word offset = pointer(index, 2 * average.entry + 1, 2 * average.entry + 2);
            if (offset == 0) continue;
            NodalResult result;
            ResultInfo& info = result.info;
            const bool also_of_elements = set.elements != 0 && set.has(average.item);
            info.name = (also_of_elements ? "averaged_" : "") + std::string(average.name);
            info.solver_name = std::string(average.label) + ",NAR";
            info.components = {"xx", "yy", "zz", "xy", "yz", "zx"};
            info.step = set.step;
            info.complex = set.complex;
            info.shape = Shape::SymmetricTensor;
            info.averaging = Averaging::Solver;
            info.corner_only = true;
            if (average.item == Item::Stress) {
                info.unit = units_of(header.units).stress;
            } else {
                info.shear = Shear::Engineering;
            }
            result.set = i;
            result.record = NodalRecord::Average;
            result.at = set.nodal_averages + offset;
            result.width = average.width;
            result.columns = {0, 1, 2, 3, 4, 5};
            out.push_back(std::move(result));
        }
    }
    return out;
}

}  // namespace feelem::rst
