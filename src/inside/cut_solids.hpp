// SPDX-License-Identifier: Apache-2.0
// The triangles where a number that is linear in each tetrahedron of the solids passes through zero.
#pragma once

#include "inside/element_values.hpp"

#include "feelem/inside.hpp"

#include <functional>
#include <optional>
#include <span>

namespace feelem {

/// Fills one number a node of the solid; NaN: there is none.
using NodeNumbers = std::function<void(const SolidRef& solid, std::span<double> out)>;

struct CutJob {
    NodeNumbers level;     ///< Triangles look to where it is positive; zero counts as positive.
    NodeNumbers values;    ///< Of the vertices.
    bool is_flat = false;  ///< The values are those of the element: the first counts.
    /// Where triangles look, for the area: a unit vector. None: each counts as it is.
    std::optional<Point3> normal;
};
std::optional<Section> cut_solids(const Solids& solids, const CutJob& job, const SectionLimits& limits);

}  // namespace feelem
