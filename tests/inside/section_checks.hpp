// SPDX-License-Identifier: Apache-2.0
// What must hold for any section of any good mesh, by what the skin says of the same plane.
#pragma once

#include "feelem/inside.hpp"
#include "feelem/surface.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace feelem::test {

/// A place where an edge of the skin meets the plane, and what the skin shows there.
struct RimPoint {
    Point3 place{};
    double value = 0;
};
/// The skin's own section: its points by twos, one segment a triangle, the material on the left when seen
/// from where the normal points to.
std::vector<RimPoint> rim_of_skin(const Surface& skin, const SurfaceField& field, const Plane& plane);

/// Area that the segments go round, by Green's theorem.
double area_within(const std::vector<RimPoint>& rim, const Plane& plane);

/// Edges of the section that no other triangle of it has, compared with the skin's segments: empty when they
/// are the same, else the first difference.
std::string rim_difference(const Section& section, const std::vector<RimPoint>& rim);

/// The same, values included, to `tolerance`; every end of the skin's segments is looked for.
std::string rim_value_difference(const Section& section, const std::vector<RimPoint>& rim, double tolerance);

/// One value a node, in the order of the mesh.
Result nodal(std::vector<float> values);

}  // namespace feelem::test
