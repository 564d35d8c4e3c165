// SPDX-License-Identifier: Apache-2.0
// Results made from results: invariants, averaging, rotation to the global system. Computed in double,
// rounded once.
#pragma once

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"
#include "feelem/result.hpp"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace feelem {

/// One derived component: its name, which results have it, and how a row's value is made.
struct Derivation {
    std::string_view name;     ///< "von_mises": also the component's name.
    std::string_view formula;  ///< For the docs table, with its source.
    bool (*applies)(const ResultInfo& info);
    /// `row` holds the result's components; NaN in gives NaN out.
    double (*make)(const ResultInfo& info, std::span<const float> row);
    /// The same from the tensor's eigenvalues, largest first, which several derivations share; null: it is
    /// not made of them.
    double (*of_principals)(const std::array<double, 3>& principals) = nullptr;
};
std::span<const Derivation> derivations();

/// Names of the derivations that apply and that the file does not list itself, in table order.
std::vector<std::string_view> derivable_components(const ResultInfo& info);

/// A scalar result with the rows of `result`: a stored component, or a derived one. Throws
/// Error(UnknownName).
Result component_of(const Result& result, std::string_view component);

/// The same of several components, in their order: what they share is computed once a row.
std::vector<Result> components_of(const Result& result, std::span<const std::string_view> components);
/// Those of these components that are made of the tensor's eigenvalues, the costly part.
std::vector<std::string_view> made_of_principals(
    const ResultInfo& info, std::span<const std::string_view> components
);

/// What averaging makes of an element-nodal result, without its values: part-nodal (Averaging::Part) or nodal
/// (Averaging::All). Invariants that the file lists of each element are left out: those of the averaged
/// components are derived (decision 0009). Only Averaging::None results are averaged: others come back
/// unchanged, those along the axes of each element, too.
ResultInfo averaged_info(const ResultInfo& info, Averaging averaging);

/// The arithmetic mean of the elements' values at each node; NaN rows do not count. As averaged_info().
Result average(const Mesh& mesh, const Result& result, Averaging averaging);

/// Turns vectors and tensors in rotated nodal systems into the global one (Mesh::node_angles); others
/// unchanged.
Result to_global(const Mesh& mesh, const Result& result);

/// A place and a direction: the axis of a cylinder. Need not be of unit length, but not 0 either.
struct CylindricalSystem {
    Point3 origin{};
    Point3 axis{0, 0, 1};
};

/// Vectors and tensors with x y z or xx ... that are not turned already, and no amplitudes.
bool can_be_cylindrical(const ResultInfo& info);

/// What such a result becomes, without its values: radial hoop axial, and of tensors radial_hoop hoop_axial
/// axial_radial.
ResultInfo cylindrical_info(const ResultInfo& info);

/// Components along r, theta and z at the place of each row (the mean of its corners for an element), from a
/// result in the global system. On the axis only axial components have a value.
Result to_cylindrical(const Mesh& mesh, const Result& result, const CylindricalSystem& system);

}  // namespace feelem
