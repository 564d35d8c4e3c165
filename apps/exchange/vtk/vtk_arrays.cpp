// SPDX-License-Identifier: Apache-2.0
#include "vtk/vtk_arrays.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>

#include <algorithm>
#include <limits>

namespace feelem::exchange {
namespace {

constexpr int kMostComponents = 100;

vtkDataSetAttributes* attributes_of(const Leaf& leaf, Location location) {
    if (location == Location::Nodal) return leaf.data->GetPointData();
    return leaf.data->GetCellData();
}

vtkIdType count_of(const Leaf& leaf, Location location) {
    return location == Location::Nodal ? leaf.data->GetNumberOfPoints() : leaf.data->GetNumberOfCells();
}

bool same(const NeutralResult& a, const NeutralResult& b) {
    return a.name == b.name && a.location == b.location && a.components == b.components;
}

}  // namespace

std::vector<NeutralResult> arrays_of(const std::vector<Leaf>& leaves) {
    std::vector<NeutralResult> results;
    for (const Location location : {Location::Nodal, Location::Elemental}) {
        for (const Leaf& leaf : leaves) {
            vtkDataSetAttributes* const data = attributes_of(leaf, location);
            for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
                vtkDataArray* const array = data->GetArray(i);
                if (array == nullptr || array->GetName() == nullptr || is_id_array(array->GetName()))
                    continue;
                const int components = array->GetNumberOfComponents();
                if (components < 1 || components > kMostComponents) continue;
                if (array->GetNumberOfTuples() != count_of(leaf, location)) continue;
                NeutralResult result{array->GetName(), static_cast<std::uint32_t>(components), location, 0};
                const bool known =
                    std::ranges::any_of(results, [&](const NeutralResult& one) { return same(one, result); });
                if (!known) results.push_back(std::move(result));
            }
        }
    }
    return results;
}

std::vector<float> values_of(
    const std::vector<Leaf>& leaves, const Merged& merged, const NeutralResult& result
) {
    const bool nodal = result.location == Location::Nodal;
    const std::size_t width = result.components;
    std::vector<float> values(
        (nodal ? merged.nodes : merged.elements) * width, std::numeric_limits<float>::quiet_NaN()
    );
    for (std::size_t l = 0; l < leaves.size(); ++l) {
        vtkDataArray* const array = attributes_of(leaves[l], result.location)->GetArray(result.name.c_str());
        const vtkIdType count = count_of(leaves[l], result.location);
        if (array == nullptr || array->GetNumberOfTuples() != count) continue;
        if (array->GetNumberOfComponents() != static_cast<int>(width)) continue;
        const std::vector<std::uint32_t>& places = nodal ? merged.node_of[l] : merged.element_of[l];
        for (vtkIdType i = 0; i < count; ++i) {
            const std::uint32_t to = places[static_cast<std::size_t>(i)];
            if (to == kNowhere) continue;
            for (std::size_t c = 0; c < width; ++c)
                values[to * width + c] = static_cast<float>(array->GetComponent(i, static_cast<int>(c)));
        }
    }
    return values;
}

}  // namespace feelem::exchange
