// SPDX-License-Identifier: Apache-2.0
#include "vtk/exodus_values.hpp"

#include <fmt/format.h>
#include <netcdf.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace feelem::exchange {
namespace {

constexpr std::size_t kMostComponents = 100;

/// Extents of a variable; empty when there is none of that name.
std::vector<std::size_t> extents_of(int file, const std::string& name, int& variable) {
    int dimensions[NC_MAX_VAR_DIMS];
    int count = 0;
    if (nc_inq_varid(file, name.c_str(), &variable) != NC_NOERR) return {};
    if (nc_inq_varndims(file, variable, &count) != NC_NOERR || count > 3) return {};
    if (nc_inq_vardimid(file, variable, dimensions) != NC_NOERR) return {};
    std::vector<std::size_t> extents(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        if (nc_inq_dimlen(file, dimensions[i], &extents[static_cast<std::size_t>(i)]) != NC_NOERR) return {};
    }
    return extents;
}

/// Node id -> place in the file.
std::unordered_map<std::int64_t, std::size_t> places_of_ids(int file, std::size_t nodes) {
    int variable = 0;
    std::vector<long long> ids(nodes);
    const auto extents = extents_of(file, "node_num_map", variable);
    const bool has_map = extents.size() == 1 && extents[0] == nodes &&
                         nc_get_var_longlong(file, variable, ids.data()) == NC_NOERR;
    std::unordered_map<std::int64_t, std::size_t> places;
    for (std::size_t i = 0; i < nodes; ++i) places[has_map ? ids[i] : static_cast<std::int64_t>(i) + 1] = i;
    return places;
}

}  // namespace

ExodusValues::ExodusValues(const std::string& path) {
    int file = 0, size = 0;
    if (nc_open(path.c_str(), NC_NOWRITE, &file) != NC_NOERR) return;
    const bool says_size = nc_get_att_int(file, NC_GLOBAL, "file_size", &size) == NC_NOERR;
    int variable = 0;
    const bool one_a_variable = nc_inq_varid(file, "vals_nod_var1", &variable) == NC_NOERR;
    if (!says_size && one_a_variable)
        file_ = file;
    else
        nc_close(file);
}

ExodusValues::~ExodusValues() {
    if (file_ >= 0) nc_close(file_);
}

std::vector<std::string> ExodusValues::names() const {
    int variable = 0;
    const auto extents = extents_of(file_, "name_nod_var", variable);
    if (extents.size() != 2 || extents[0] > 10'000 || extents[1] > 1000) return {};
    std::string text(extents[0] * extents[1], '\0');
    if (nc_get_var_text(file_, variable, text.data()) != NC_NOERR) return {};
    std::vector<std::string> out;
    for (std::size_t i = 0; i < extents[0]; ++i) {
        std::string name = text.substr(i * extents[1], extents[1]);
        name.resize(std::min(name.find('\0'), name.size()));
        out.push_back(std::move(name));
    }
    return out;
}

void ExodusValues::put_into(std::vector<Leaf>& leaves, std::size_t step) const {
    if (file_ < 0) return;
    const std::vector<std::string> all = names();
    for (std::size_t i = 0; i < all.size(); ++i) put(leaves, step, i, all[i]);
}

void ExodusValues::put(
    std::vector<Leaf>& leaves, std::size_t step, std::size_t variable, const std::string& name
) const {
    int id = 0;
    const auto extents = extents_of(file_, fmt::format("vals_nod_var{}", variable + 1), id);
    for (Leaf& leaf : leaves) leaf.data->GetPointData()->RemoveArray(name.c_str());
    if (extents.size() < 2 || step >= extents[0]) return;
    const std::size_t nodes = extents[1], width = extents.size() == 3 ? extents[2] : 1;
    if (width < 1 || width > kMostComponents) return;
    std::vector<double> values(nodes * width);
    const std::size_t start[3]{step, 0, 0}, count[3]{1, nodes, width};
    if (nc_get_vara_double(file_, id, start, count, values.data()) != NC_NOERR) return;
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
