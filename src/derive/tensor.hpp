// SPDX-License-Identifier: Apache-2.0
// Symmetric tensors of rank two, in double: eigenvalues.
#pragma once

#include "model/rotation.hpp"

#include <array>

namespace feelem {

/// Largest first. NaN in any component gives NaN.
std::array<double, 3> eigenvalues(const Tensor6& tensor) noexcept;

}  // namespace feelem
