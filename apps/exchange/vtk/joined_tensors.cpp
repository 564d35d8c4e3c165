// SPDX-License-Identifier: Apache-2.0
#include "vtk/joined_tensors.hpp"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string>

namespace feelem::exchange {
namespace {

constexpr std::size_t kComponents = 6;
/// In VTK's order.
constexpr const char* kEndings[kComponents][2]{
    {"xx", "xx"}, {"yy", "yy"}, {"zz", "zz"}, {"xy", "yx"}, {"yz", "zy"}, {"xz", "zx"}};

/// One number of an array.
struct Source {
    vtkDataArray* array = nullptr;
    int component = 0;
};
using Six = std::array<Source, kComponents>;

std::string lower_ending(const std::string& name) {
    std::string ending = name.substr(name.size() - 2);
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

/// VTK's reader of CGNS makes a vector StressX of StressXX StressXY StressXZ.
void add_vector(vtkDataArray* array, const std::string& name, std::map<std::string, Six>& found) {
    if (name.back() != 'X' && name.back() != 'x') return;
    Six& six = found[name.substr(0, name.size() - 1)];
    six[0] = {array, 0};
    six[3] = {array, 1};
    six[5] = {array, 2};
}

/// Name without its ending -> where the six numbers stand; null where there is none.
std::map<std::string, Six> candidates_of(vtkDataSetAttributes* data) {
    std::map<std::string, Six> found;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
        vtkDataArray* const array = data->GetArray(i);
        if (array == nullptr || array->GetName() == nullptr) continue;
        const std::string name = array->GetName();
        if (name.size() < 3) continue;
        if (array->GetNumberOfComponents() == 3) add_vector(array, name, found);
        if (array->GetNumberOfComponents() != 1) continue;
        const std::string ending = lower_ending(name);
        for (std::size_t c = 0; c < kComponents; ++c) {
            if (ending == kEndings[c][0] || ending == kEndings[c][1])
                found[name.substr(0, name.size() - 2)][c] = {array, 0};
        }
    }
    return found;
}

void join(vtkDataSetAttributes* data, std::string name, const Six& six) {
    while (!name.empty() && (name.back() == '_' || name.back() == '-' || name.back() == ' ')) name.pop_back();
    if (name.empty() || data->HasArray(name.c_str()) != 0) return;
    for (const auto& [array, component] : six) {
        if (array == nullptr || array->GetNumberOfTuples() != six[0].array->GetNumberOfTuples()) return;
    }
    vtkNew<vtkDoubleArray> joined;
    joined->SetName(name.c_str());
    joined->SetNumberOfComponents(static_cast<int>(kComponents));
    joined->SetNumberOfTuples(six[0].array->GetNumberOfTuples());
    for (std::size_t c = 0; c < kComponents; ++c) {
        for (vtkIdType i = 0; i < joined->GetNumberOfTuples(); ++i)
            joined->SetComponent(i, static_cast<int>(c), six[c].array->GetComponent(i, six[c].component));
    }
    std::set<std::string> taken;
    for (const auto& [array, component] : six) taken.insert(array->GetName());
    for (const std::string& one : taken) data->RemoveArray(one.c_str());
    data->AddArray(joined);
}

}  // namespace

void join_tensors(std::vector<Leaf>& leaves) {
    for (Leaf& leaf : leaves) {
        for (vtkDataSetAttributes* data :
             {static_cast<vtkDataSetAttributes*>(leaf.data->GetPointData()),
              static_cast<vtkDataSetAttributes*>(leaf.data->GetCellData())}) {
            for (const auto& [name, six] : candidates_of(data)) join(data, name, six);
        }
    }
}

}  // namespace feelem::exchange
