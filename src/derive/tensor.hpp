// SPDX-License-Identifier: Apache-2.0
// Symmetric tensors of rank two, in double: eigenvalues.
#pragma once

#include "model/rotation.hpp"

#include "feelem/result.hpp"

#include <array>
#include <span>

namespace feelem {

/// Largest first. NaN in any component gives NaN.
std::array<double, 3> eigenvalues(const Tensor6& tensor) noexcept;

/// Of the tensor that a row of a result begins with (engineering shear halved).
std::array<double, 3> principals_of(const ResultInfo& info, std::span<const float> row);

}  // namespace feelem
