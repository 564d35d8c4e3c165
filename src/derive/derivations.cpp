// SPDX-License-Identifier: Apache-2.0
// The list of derived components. To add one: write its two functions and a row.
#include "derive/tensor.hpp"

#include "feelem/derive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace feelem {
namespace {

bool begins_with(const ResultInfo& info, std::span<const std::string_view> names) {
    return info.components.size() >= names.size() &&
           std::equal(names.begin(), names.end(), info.components.begin());
}

bool is_vector(const ResultInfo& info) {
    static constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
    return info.shape == Shape::Vector && info.complex == Complex::No && begins_with(info, kNames);
}

bool is_tensor(const ResultInfo& info) {
    static constexpr std::array<std::string_view, 6> kNames{"xx", "yy", "zz", "xy", "yz", "zx"};
    return info.shape == Shape::SymmetricTensor && info.complex == Complex::No && begins_with(info, kNames);
}

bool is_stress(const ResultInfo& info) {
    return info.name == "stress" && is_tensor(info);
}

/// The first six components, engineering shear halved.
Tensor6 tensor_of(const ResultInfo& info, std::span<const float> row) {
    const double shear = info.shear == Shear::Engineering ? 0.5 : 1.0;
    Tensor6 out{};
    for (std::size_t i = 0; i < 6; ++i) out[i] = static_cast<double>(row[i]) * (i < 3 ? 1.0 : shear);
    return out;
}

double magnitude(const ResultInfo&, std::span<const float> row) {
    const double x = static_cast<double>(row[0]);
    const double y = static_cast<double>(row[1]);
    const double z = static_cast<double>(row[2]);
    return std::sqrt(x * x + y * y + z * z);
}

double von_mises(const ResultInfo& info, std::span<const float> row) {
    const Tensor6 s = tensor_of(info, row);
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return std::sqrt((a * a + b * b + c * c) / 2 + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

using OfPrincipals = double (*)(const std::array<double, 3>&);

double tresca(const std::array<double, 3>& principals) {
    return principals[0] - principals[2];
}

template <std::size_t I>
double principal(const std::array<double, 3>& principals) {
    return principals[I];
}

template <OfPrincipals make>
double from_row(const ResultInfo& info, std::span<const float> row) {
    return make(principals_of(info, row));
}

constexpr std::array kTable{
    Derivation{"magnitude", "sqrt(x² + y² + z²)", is_vector, magnitude},
    Derivation{
        "von_mises",
        "sqrt(((xx-yy)² + (yy-zz)² + (zz-xx)²)/2 + 3 (xy² + yz² + zx²)), von Mises 1913; Ansys SEQV. Stress "
        "alone",
        is_stress,
        von_mises},
    Derivation{
        "tresca",
        "principal_1 - principal_3, Tresca 1864: twice the largest shear stress; Ansys SINT. Stress alone",
        is_stress,
        from_row<tresca>,
        tresca},
    Derivation{
        "principal_1",
        "largest eigenvalue of the tensor (engineering shear halved), by Jacobi's method; Ansys S1",
        is_tensor,
        from_row<principal<0>>,
        principal<0>},
    Derivation{
        "principal_2",
        "middle eigenvalue of the tensor; Ansys S2",
        is_tensor,
        from_row<principal<1>>,
        principal<1>},
    Derivation{
        "principal_3",
        "smallest eigenvalue of the tensor; Ansys S3",
        is_tensor,
        from_row<principal<2>>,
        principal<2>},
};

}  // namespace

std::array<double, 3> principals_of(const ResultInfo& info, std::span<const float> row) {
    return eigenvalues(tensor_of(info, row));
}

std::span<const Derivation> derivations() {
    return kTable;
}

std::vector<std::string_view> derivable_components(const ResultInfo& info) {
    std::vector<std::string_view> names;
    for (const Derivation& derivation : kTable) {
        if (derivation.applies(info) && component_index(info, derivation.name) < 0)
            names.push_back(derivation.name);
    }
    return names;
}

}  // namespace feelem
