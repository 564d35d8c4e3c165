// SPDX-License-Identifier: Apache-2.0
#include "skin/pattern.hpp"

namespace feelem {
namespace {

constexpr FacetTriangle kPlainTriangle[]{{0, 1, 2}};
constexpr FacetTriangle kTriangleWithMiddles[]{{0, 4, 6}, {4, 1, 5}, {6, 5, 2}, {4, 5, 6}};
constexpr FacetTriangle kPlainQuad[]{{0, 1, 8}, {1, 2, 8}, {2, 3, 8}, {3, 0, 8}};
constexpr FacetTriangle kQuadWithMiddles[]{
    {0, 4, 8}, {4, 1, 8}, {1, 5, 8}, {5, 2, 8}, {2, 6, 8}, {6, 3, 8}, {3, 7, 8}, {7, 0, 8}};

constexpr std::uint8_t kWhole[]{0};
constexpr std::uint8_t kAlongTriangleSide[3][2]{{0, 1}, {1, 2}, {2, 0}};
constexpr std::uint8_t kAlongQuadSide[4][2]{{0, 1}, {2, 3}, {4, 5}, {6, 7}};
constexpr std::uint8_t kAlongPlainSide[4][1]{{0}, {1}, {2}, {3}};

}  // namespace

std::span<const FacetTriangle> pattern_of(const Outline& facet) noexcept {
    if (facet.count == 3) {
        if (facet.has_middles()) return kTriangleWithMiddles;
        return kPlainTriangle;
    }
    if (facet.has_middles()) return kQuadWithMiddles;
    return kPlainQuad;
}

std::span<const std::uint8_t> pattern_along(const Outline& facet, std::size_t side) noexcept {
    if (facet.count == 3) {
        if (facet.has_middles()) return kAlongTriangleSide[side];
        return kWhole;
    }
    if (facet.has_middles()) return kAlongQuadSide[side];
    return kAlongPlainSide[side];
}

WeightedPoints blend_of_middle(const Outline& facet, std::size_t side) noexcept {
    WeightedPoints out;
    out.add(side, 0.5);
    out.add(facet.after(side), 0.5);
    return out;
}

WeightedPoints blend_of_centre(const Outline& facet) noexcept {
    // A side without a middle counts as if it had one halfway: a quarter more for each of its corners.
    WeightedPoints out;
    for (std::size_t i = 0; i < 4; ++i) {
        const bool straight_after = facet.middles[i] == kNoNode;
        const bool straight_before = facet.middles[(i + 3) % 4] == kNoNode;
        const double weight = -0.25 + 0.25 * straight_after + 0.25 * straight_before;
        if (weight != 0) out.add(i, weight);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        if (facet.middles[i] != kNoNode) out.add(kFirstMiddle + i, 0.5);
    }
    return out;
}

namespace {

Point3 weighted(const FacetPlaces& places, const WeightedPoints& blend) noexcept {
    Point3 sum{};
    for (std::size_t i = 0; i < blend.count; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum[axis] += blend.weights[i] * places[blend.points[i]][axis];
    }
    return sum;
}

}  // namespace

Point3 centre_of_corners(const FacetPlaces& places) noexcept {
    Point3 sum{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sum[axis] =
            0.25 * places[0][axis] + 0.25 * places[1][axis] + 0.25 * places[2][axis] + 0.25 * places[3][axis];
    }
    return sum;
}

FacetPlaces places_of(const Outline& facet, std::span<const Point3> coordinates) noexcept {
    FacetPlaces places{};
    for (std::size_t i = 0; i < facet.count; ++i) places[i] = coordinates[raw(facet.corners[i])];
    if (!facet.has_middles() && facet.centre == kNoNode) {
        if (facet.count == 4) places[kCentre] = centre_of_corners(places);
        return places;
    }
    if (facet.has_middles()) {
        for (std::size_t i = 0; i < facet.count; ++i) {
            places[kFirstMiddle + i] = facet.middles[i] == kNoNode
                                           ? weighted(places, blend_of_middle(facet, i))
                                           : coordinates[raw(facet.middles[i])];
        }
    }
    if (facet.count == 4) {
        places[kCentre] = facet.centre == kNoNode ? weighted(places, blend_of_centre(facet))
                                                  : coordinates[raw(facet.centre)];
    }
    return places;
}

}  // namespace feelem
