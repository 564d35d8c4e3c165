// SPDX-License-Identifier: Apache-2.0
#include "skin/facet_grid.hpp"

#include <algorithm>

namespace feelem {
namespace {

/// The facet's point at (i, j) of 0..2 halves of each side, or kNoPoint.
std::uint8_t point_at_halves(std::size_t corner_count, unsigned i, unsigned j) {
    constexpr std::uint8_t kOfTriangle[3][3]{{0, 4, 1}, {6, 5, 0}, {2, 0, 0}};
    constexpr std::uint8_t kOfQuad[3][3]{{0, 4, 1}, {7, 8, 5}, {3, 6, 2}};
    return corner_count == 3 ? kOfTriangle[j][i] : kOfQuad[j][i];
}

struct GridRows {
    std::size_t corner_count;
    std::uint32_t n;

    std::uint32_t length(std::uint32_t j) const { return corner_count == 3 ? n + 1 - j : n + 1; }
    std::uint32_t at(std::uint32_t i, std::uint32_t j) const {
        return corner_count == 3 ? j * (n + 1) - j * (j - 1) / 2 + i : j * (n + 1) + i;
    }
};

void add_triangles_of_triangle(const GridRows& rows, FacetGrid& grid) {
    for (std::uint32_t j = 0; j < rows.n; ++j) {
        for (std::uint32_t i = 0; i + j < rows.n; ++i) {
            grid.triangles.push_back({rows.at(i, j), rows.at(i + 1, j), rows.at(i, j + 1)});
            if (i + j + 1 < rows.n)
                grid.triangles.push_back({rows.at(i + 1, j), rows.at(i + 1, j + 1), rows.at(i, j + 1)});
        }
    }
}

/// The diagonals run towards the centre, as in the coarse pattern.
void add_triangles_of_quad(const GridRows& rows, FacetGrid& grid) {
    const std::uint32_t half = rows.n / 2;
    for (std::uint32_t j = 0; j < rows.n; ++j) {
        for (std::uint32_t i = 0; i < rows.n; ++i) {
            const std::uint32_t a = rows.at(i, j), b = rows.at(i + 1, j);
            const std::uint32_t c = rows.at(i + 1, j + 1), d = rows.at(i, j + 1);
            if ((i < half) == (j < half)) {
                grid.triangles.push_back({a, b, c});
                grid.triangles.push_back({a, c, d});
            } else {
                grid.triangles.push_back({a, b, d});
                grid.triangles.push_back({b, c, d});
            }
        }
    }
}

/// Shape functions of corners 0..3, middles 4..7 and the centre.
using Shape9 = std::array<double, kFacetPoints>;

Shape9 triangle_shape(double u, double v) {
    const std::array<double, 3> l{1 - u - v, u, v};
    Shape9 shape{};
    for (std::size_t i = 0; i < 3; ++i) {
        shape[i] = l[i] * (2 * l[i] - 1);
        shape[kFirstMiddle + i] = 4 * l[i] * l[(i + 1) % 3];
    }
    return shape;
}

constexpr double kCornerU[]{-1, 1, 1, -1};
constexpr double kCornerV[]{-1, -1, 1, 1};

Shape9 quad8_shape(double u, double v) {
    Shape9 shape{};
    for (std::size_t i = 0; i < 4; ++i) {
        const double a = u * kCornerU[i], b = v * kCornerV[i];
        shape[i] = (1 + a) * (1 + b) * (a + b - 1) / 4;
    }
    shape[4] = (1 - u * u) * (1 - v) / 2;
    shape[5] = (1 - v * v) * (1 + u) / 2;
    shape[6] = (1 - u * u) * (1 + v) / 2;
    shape[7] = (1 - v * v) * (1 - u) / 2;
    return shape;
}

/// The 8-node functions with the centre's own added, which takes from each what it has there.
Shape9 quad9_shape(double u, double v) {
    Shape9 shape = quad8_shape(u, v);
    const double centre = (1 - u * u) * (1 - v * v);
    for (std::size_t i = 0; i < 4; ++i) {
        shape[i] += centre / 4;
        shape[kFirstMiddle + i] -= centre / 2;
    }
    shape[kCentre] = centre;
    return shape;
}

NodeIndex node_at(const Outline& facet, std::size_t point) {
    if (point == kCentre) return facet.centre;
    return point < kFirstMiddle ? facet.corners[point] : facet.middles[point - kFirstMiddle];
}

}  // namespace

FacetGrid grid_of(std::size_t corner_count, unsigned pieces) {
    const GridRows rows{corner_count, pieces};
    FacetGrid grid;
    const std::uint32_t half = pieces / 2;
    std::uint32_t between = 0;
    for (std::uint32_t j = 0; j <= pieces; ++j) {
        for (std::uint32_t i = 0; i < rows.length(j); ++i) {
            FacetGrid::Point point;
            point.u = static_cast<double>(i) / pieces;
            point.v = static_cast<double>(j) / pieces;
            if (corner_count == 4) {
                point.u = 2 * point.u - 1;
                point.v = 2 * point.v - 1;
            }
            const bool is_half = i % half == 0 && j % half == 0;
            point.point = is_half ? point_at_halves(corner_count, i / half, j / half) : FacetGrid::kNoPoint;
            grid.points.push_back(point);
            grid.rank.push_back(between);
            if (!is_half) ++between;
        }
    }
    for (std::uint32_t k = 0; k <= pieces; ++k) {
        grid.sides[0].push_back(rows.at(k, 0));
        if (corner_count == 3) {
            grid.sides[1].push_back(rows.at(pieces - k, k));
            grid.sides[2].push_back(rows.at(0, pieces - k));
        } else {
            grid.sides[1].push_back(rows.at(pieces, k));
            grid.sides[2].push_back(rows.at(pieces - k, pieces));
            grid.sides[3].push_back(rows.at(0, pieces - k));
        }
    }
    if (corner_count == 3) {
        add_triangles_of_triangle(rows, grid);
    } else {
        add_triangles_of_quad(rows, grid);
    }
    return grid;
}

WeightedPoints shape_weights(const Outline& facet, double u, double v) noexcept {
    Shape9 shape = facet.count == 3          ? triangle_shape(u, v)
                   : facet.centre == kNoNode ? quad8_shape(u, v)
                                             : quad9_shape(u, v);
    for (std::size_t i = 0; i < facet.count; ++i) {
        if (facet.middles[i] != kNoNode) continue;
        shape[i] += shape[kFirstMiddle + i] / 2;
        shape[facet.after(i)] += shape[kFirstMiddle + i] / 2;
        shape[kFirstMiddle + i] = 0;
    }
    std::array<std::uint8_t, kFacetPoints> order{0, 1, 2, 3, 4, 5, 6, 7, 8};
    std::ranges::sort(order, {}, [&](std::uint8_t point) { return node_at(facet, point); });
    WeightedPoints out;
    for (const std::uint8_t point : order) {
        if (shape[point] != 0) out.add(point, shape[point]);
    }
    return out;
}

}  // namespace feelem
