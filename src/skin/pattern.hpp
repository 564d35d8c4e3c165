// SPDX-License-Identifier: Apache-2.0
// How a facet is cut into triangles: by its points, which are its nodes and what has to be put between them.
#pragma once

#include "model/vector.hpp"
#include "skin/outline.hpp"

#include "feelem/mesh.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace feelem {

/// Points of a facet: corners 0..3, middles 4..7, centre 8.
inline constexpr std::size_t kFacetPoints = 9;
inline constexpr std::size_t kFirstMiddle = 4;
inline constexpr std::size_t kCentre = 8;
using FacetTriangle = std::array<std::uint8_t, 3>;

/// A triangle stays whole or is cut through its middles into 4; a quad is cut round its centre into 4, or 8
/// with middles (docs/cli.md).
std::span<const FacetTriangle> pattern_of(const Outline& facet) noexcept;
/// The triangles of the pattern that lie along side `side`.
std::span<const std::uint8_t> pattern_along(const Outline& facet, std::size_t side) noexcept;

/// A point as a weighted sum of the facet's nodes; weights are exact in binary.
struct WeightedPoints {
    std::array<std::uint8_t, kFacetPoints> points{};
    std::array<double, kFacetPoints> weights{};
    std::size_t count = 0;

    void add(std::size_t point, double weight) {
        points[count] = static_cast<std::uint8_t>(point);
        weights[count++] = weight;
    }
};
/// Middle `side`, halfway between its corners: the place of a middle that is left out.
WeightedPoints blend_of_middle(const Outline& facet, std::size_t side) noexcept;
/// Centre of a quad: the mean of its corners, or the serendipity centre (-1/4 corners + 1/2 middles).
WeightedPoints blend_of_centre(const Outline& facet) noexcept;

using FacetPlaces = std::array<Point3, kFacetPoints>;
/// Of a quad without middles: the sum that blend_of_centre describes, in its order.
Point3 centre_of_corners(const FacetPlaces& places) noexcept;
/// Coordinates of the facet's points; those the pattern does not use stay 0.
FacetPlaces places_of(const Outline& facet, std::span<const Point3> coordinates) noexcept;

/// Normal of a triangle, as long as twice its area.
inline Point3 area_vector(const Point3& a, const Point3& b, const Point3& c) noexcept {
    return cross(minus(b, a), minus(c, a));
}

}  // namespace feelem
