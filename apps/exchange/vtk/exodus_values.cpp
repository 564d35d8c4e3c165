// SPDX-License-Identifier: Apache-2.0
#include "vtk/exodus_values.hpp"

#include <fmt/format.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cstdint>
#include <limits>
#include <unordered_map>

namespace feelem::exchange {
namespace {

constexpr std::size_t kMostComponents = 100;

/// Node id -> place in the file.
std::unordered_map<std::int64_t, std::size_t> places_of_ids(const NetcdfFile& file, std::size_t nodes) {
    const std::vector<std::int64_t> ids = file.integers("node_num_map");
    const bool has_map = ids.size() == nodes;
    std::unordered_map<std::int64_t, std::size_t> places;
    for (std::size_t i = 0; i < nodes; ++i) places[has_map ? ids[i] : static_cast<std::int64_t>(i) + 1] = i;
    return places;
}

}  // namespace

ExodusValues::ExodusValues(const std::string& path) : file_(path) {
    needed_ = !file_.has_global_integer("file_size") && file_.has_variable("vals_nod_var1");
}

void ExodusValues::put_into(std::vector<Leaf>& leaves, std::size_t step) const {
    if (!needed_) return;
    const std::vector<std::string> all = file_.texts("name_nod_var");
    for (std::size_t i = 0; i < all.size(); ++i) put(leaves, step, i, all[i]);
}

void ExodusValues::put(
    std::vector<Leaf>& leaves, std::size_t step, std::size_t variable, const std::string& name
) const {
    const std::string own = fmt::format("vals_nod_var{}", variable + 1);
    for (Leaf& leaf : leaves) leaf.data->GetPointData()->RemoveArray(name.c_str());
    const std::vector<double> values = file_.reals_of_step(own, step);
    if (values.empty()) return;
    const std::size_t nodes = file_.extents(own)[1], width = values.size() / nodes;
    if (width > kMostComponents) return;
    const auto places = places_of_ids(file_, nodes);
    for (Leaf& leaf : leaves) {
        vtkDataArray* const ids = leaf.data->GetPointData()->GetArray("GlobalNodeId");
        if (ids == nullptr) continue;
        vtkNew<vtkDoubleArray> array;
        array->SetName(name.c_str());
        array->SetNumberOfComponents(static_cast<int>(width));
        array->SetNumberOfTuples(leaf.data->GetNumberOfPoints());
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
            const auto place = places.find(static_cast<std::int64_t>(ids->GetComponent(i, 0)));
            for (std::size_t c = 0; c < width; ++c) {
                const double value = place == places.end() ? std::numeric_limits<double>::quiet_NaN()
                                                           : values[place->second * width + c];
                array->SetComponent(i, static_cast<int>(c), value);
            }
        }
        leaf.data->GetPointData()->AddArray(array);
    }
}

}  // namespace feelem::exchange
