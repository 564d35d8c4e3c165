// SPDX-License-Identifier: Apache-2.0
// Rotated axes, and vectors and tensors along them turned into the global system; in double.
#pragma once

#include "feelem/mesh.hpp"

#include <array>

namespace feelem {

/// xx yy zz xy yz zx.
using Tensor6 = std::array<double, 6>;
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Sine and cosine of an angle in degrees: exact at multiples of 90, which people write.
std::array<double, 2> sine_and_cosine(double degrees) noexcept;

/// The matrix with these columns.
Matrix3 from_columns(const Point3& x, const Point3& y, const Point3& z) noexcept;

Matrix3 product(const Matrix3& a, const Matrix3& b) noexcept;

/// The tensor as a symmetric matrix.
Matrix3 matrix_of(const Tensor6& tensor) noexcept;

/// Axes of an Ansys nodal system as columns: turned by angles[0] degrees about Z, then by angles[1] about the
/// new X, then by angles[2] about the newest Y (THXY, THYZ, THZX of the N command).
Matrix3 nodal_axes(const NodalAngles& angles) noexcept;

/// Components in the global system of a vector, or tensor, given along `axes`. A term whose coefficient is 0
/// does not count, so that a missing component spoils only what it takes part in.
std::array<double, 3> to_global(const Matrix3& axes, const std::array<double, 3>& vector) noexcept;
Tensor6 to_global(const Matrix3& axes, const Tensor6& tensor) noexcept;

}  // namespace feelem
