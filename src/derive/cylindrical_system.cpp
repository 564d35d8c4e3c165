// SPDX-License-Identifier: Apache-2.0
// Vectors and tensors along r, theta and z of a cylinder: hoop and axial stress of a boiler.
#include "model/rotation.hpp"
#include "model/vector.hpp"

#include "feelem/derive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

namespace feelem {
namespace {

constexpr std::array<std::string_view, 3> kVector{"x", "y", "z"};
constexpr std::array<std::string_view, 6> kTensor{"xx", "yy", "zz", "xy", "yz", "zx"};
constexpr std::array<const char*, 6> kCylindricalNames{
    "radial", "hoop", "axial", "radial_hoop", "hoop_axial", "axial_radial"};

bool leads_with(const ResultInfo& info, std::span<const std::string_view> names) {
    return info.components.size() >= names.size() &&
           std::equal(names.begin(), names.end(), info.components.begin());
}

/// The axis as a unit vector.
Point3 unit_axis(const CylindricalSystem& system) {
    const double size = length(system.axis);
    return {system.axis[0] / size, system.axis[1] / size, system.axis[2] / size};
}

/// Rows r, theta, z at a place. On the axis r and theta are NaN: there they have no direction.
Matrix3 axes_at(const CylindricalSystem& system, const Point3& z, const Point3& place) {
    const Point3 from_origin = minus(place, system.origin);
    const double along = dot(from_origin, z);
    Point3 r = minus(from_origin, {along * z[0], along * z[1], along * z[2]});
    const double radius = std::sqrt(dot(r, r));
    const double size = std::sqrt(dot(from_origin, from_origin));
    constexpr double kOnAxis = 1e-9;  // Of the distance from the origin: what rounding leaves.
    const bool is_on_axis = !(radius > kOnAxis * size);
    for (double& x : r) x = is_on_axis ? std::numeric_limits<double>::quiet_NaN() : x / radius;
    return {r, cross(z, r), z};
}

/// Where a row stands: its node, or the mean of its element's corners.
class Places {
public:
    Places(const Mesh& mesh, const Result& result) : mesh_(mesh), result_(result) {}
    Point3 operator()(std::size_t row) const {
        switch (result_.info.location) {
        case Location::Nodal: return mesh_.coordinates[row];
        case Location::PartNodal:
        case Location::ElementNodal: return mesh_.coordinates[raw(result_.row_node[row])];
        case Location::Elemental: return centre(ElementIndex{static_cast<std::uint32_t>(row)});
        }
        return {};
    }

private:
    Point3 centre(ElementIndex index) const {
        const ElementRef element = element_at(mesh_, index);
        const auto corners = element.nodes().first(element_row(element.block->type).corner_count);
        Point3 sum{};
        for (const NodeIndex node : corners) {
            for (std::size_t i = 0; i < 3; ++i) sum[i] += mesh_.coordinates[raw(node)][i];
        }
        for (double& x : sum) x /= static_cast<double>(corners.size());
        return sum;
    }

    const Mesh& mesh_;
    const Result& result_;
};

}  // namespace

bool can_be_cylindrical(const ResultInfo& info) {
    const bool is_linear = info.complex != Complex::Amplitude && info.complex != Complex::Phase;
    return is_linear && info.system.empty() &&
           ((info.shape == Shape::Vector && leads_with(info, kVector)) ||
            (info.shape == Shape::SymmetricTensor && leads_with(info, kTensor)));
}

ResultInfo cylindrical_info(const ResultInfo& info) {
    ResultInfo out = info;
    const std::size_t width = info.shape == Shape::Vector ? 3 : 6;
    out.components.assign(kCylindricalNames.begin(), kCylindricalNames.begin() + width);
    out.shape = Shape::Other;
    out.nodal_system = false;
    return out;
}

Result to_cylindrical(const Mesh& mesh, const Result& result, const CylindricalSystem& system) {
    Result out;
    out.info = cylindrical_info(result.info);
    out.row_owner = result.row_owner;
    out.row_node = result.row_node;
    const std::size_t from_width = result.component_count(), width = out.info.components.size();
    out.values.resize(result.row_count() * width);
    const double shear = result.info.shear == Shear::Engineering ? 2.0 : 1.0;
    const Point3 z = unit_axis(system);
    const Places place_of(mesh, result);
    for (std::size_t row = 0; row < result.row_count(); ++row) {
        const float* from = &result.values[row * from_width];
        float* to = &out.values[row * width];
        const Matrix3 axes = axes_at(system, z, place_of(row));
        if (width == 3) {
            std::array<double, 3> vector{};
            for (std::size_t i = 0; i < 3; ++i) vector[i] = static_cast<double>(from[i]);
            vector = to_global(axes, vector);
            for (std::size_t i = 0; i < 3; ++i) to[i] = static_cast<float>(vector[i]);
            continue;
        }
        Tensor6 tensor{};
        for (std::size_t i = 0; i < 6; ++i) tensor[i] = static_cast<double>(from[i]) / (i < 3 ? 1.0 : shear);
        tensor = to_global(axes, tensor);
        for (std::size_t i = 0; i < 6; ++i) to[i] = static_cast<float>(tensor[i] * (i < 3 ? 1.0 : shear));
    }
    return out;
}

}  // namespace feelem
