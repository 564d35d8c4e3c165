// SPDX-License-Identifier: Apache-2.0
// Vectors and tensors from rotated nodal systems into the global one.
#include "derive/tensor.hpp"

#include "feelem/derive.hpp"

#include <array>

namespace feelem {
namespace {

bool can_turn(const Mesh& mesh, const ResultInfo& info) {
    const bool is_linear = info.complex != Complex::Amplitude && info.complex != Complex::Phase;
    const bool has_axes = (info.shape == Shape::Vector && info.components.size() >= 3) ||
                          (info.shape == Shape::SymmetricTensor && info.components.size() >= 6);
    return info.nodal_system && !mesh.node_angles.empty() && is_linear && has_axes &&
           info.location != Location::Elemental;
}

void turn_vector(const Matrix3& axes, float* values) {
    const auto turned = to_global(
        axes,
        std::array<double, 3>{
            static_cast<double>(values[0]), static_cast<double>(values[1]), static_cast<double>(values[2])}
    );
    for (std::size_t i = 0; i < 3; ++i) values[i] = static_cast<float>(turned[i]);
}

void turn_tensor(const Matrix3& axes, double shear, float* values) {
    Tensor6 tensor{};
    for (std::size_t i = 0; i < 6; ++i) tensor[i] = static_cast<double>(values[i]) / (i < 3 ? 1.0 : shear);
    tensor = to_global(axes, tensor);
    for (std::size_t i = 0; i < 6; ++i) values[i] = static_cast<float>(tensor[i] * (i < 3 ? 1.0 : shear));
}

}  // namespace

Result to_global(const Mesh& mesh, const Result& result) {
    if (!can_turn(mesh, result.info)) return result;
    Result out = result;
    out.info.nodal_system = false;
    const std::size_t width = result.component_count();
    const double shear = result.info.shear == Shear::Engineering ? 2.0 : 1.0;
    for (std::size_t row = 0; row < result.row_count(); ++row) {
        const bool is_nodal = result.info.location == Location::Nodal;
        if (!is_nodal && row >= result.row_node.size()) break;
        const std::size_t node = is_nodal ? row : raw(result.row_node[row]);
        if (node >= mesh.node_angles.size() || mesh.node_angles[node] == NodalAngles{}) continue;
        const Matrix3 axes = nodal_axes(mesh.node_angles[node]);
        float* values = out.values.data() + row * width;
        if (result.info.shape == Shape::Vector) {
            turn_vector(axes, values);
        } else {
            turn_tensor(axes, shear, values);
        }
    }
    return out;
}

}  // namespace feelem
