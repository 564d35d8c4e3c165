// SPDX-License-Identifier: Apache-2.0
// Every row of the element table is checked: nothing in it is taken on trust.
#include "feelem/element_type.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace feelem {
namespace {

using Vector = std::array<double, 3>;

Vector at(const ElementRow& row, std::uint8_t local) {
    return {row.reference[local][0], row.reference[local][1], row.reference[local][2]};
}
Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

class EveryElement : public testing::TestWithParam<int> {
protected:
    const ElementRow& row() const { return element_row(static_cast<ElementType>(GetParam())); }
};

TEST_P(EveryElement, each_node_stands_somewhere_of_its_own) {
    std::set<std::array<float, 3>> places;
    for (std::size_t i = 0; i < row().node_count; ++i) places.insert(row().reference[i]);

    EXPECT_EQ(places.size(), row().node_count) << row().name;
}

TEST_P(EveryElement, each_edge_of_a_solid_lies_in_two_facets_once_each_way) {
    if (row().dimension != 3) return;
    std::map<std::pair<int, int>, int> uses;
    for (const FacetRow& facet : facets_of(row().type)) {
        const auto corners = facet_corners(facet);
        for (std::size_t i = 0; i < corners.size(); ++i)
            ++uses[{corners[i], corners[(i + 1) % corners.size()]}];
    }

    EXPECT_EQ(uses.size(), 2U * row().edge_count) << row().name;
    for (const EdgeRow& edge : edges_of(row().type)) {
        EXPECT_EQ((uses[{edge.first, edge.second}]), 1);
        EXPECT_EQ((uses[{edge.second, edge.first}]), 1);
    }
}

TEST_P(EveryElement, a_solid_is_a_ball_by_eulers_number) {
    if (row().dimension != 3) return;

    EXPECT_EQ(row().corner_count - row().edge_count + row().facet_count, 2) << row().name;
}

TEST_P(EveryElement, facets_point_outward_and_enclose_the_volume_of_the_reference_element) {
    if (row().dimension != 3) return;
    double volume = 0;
    Vector area_sum{};
    for (const FacetRow& facet : facets_of(row().type)) {
        const auto corners = facet_corners(facet);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            const Vector a = at(row(), corners[0]), b = at(row(), corners[i]), c = at(row(), corners[i + 1]);
            const Vector normal = cross(minus(b, a), minus(c, a));
            volume += dot(a, normal) / 6;
            for (std::size_t axis = 0; axis < 3; ++axis) area_sum[axis] += normal[axis];
        }
    }

    const std::map<int, double> by_corners{{4, 1.0 / 6}, {5, 1.0 / 3}, {6, 0.5}, {8, 1.0}};
    EXPECT_NEAR(volume, by_corners.at(row().corner_count), 1e-12) << row().name;
    EXPECT_NEAR(dot(area_sum, area_sum), 0, 1e-12) << row().name;
}

TEST_P(EveryElement, mid_side_nodes_lie_on_their_edges_and_facets_name_the_same_ones) {
    std::map<std::pair<int, int>, int> middle;
    for (const EdgeRow& edge : edges_of(row().type)) {
        ASSERT_EQ(edge.middle == kNoLocalNode, row().order == 1) << row().name;
        if (edge.middle == kNoLocalNode) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(
                2 * at(row(), edge.middle)[axis], at(row(), edge.first)[axis] + at(row(), edge.second)[axis]
            );
        }
        middle[{edge.first, edge.second}] = middle[{edge.second, edge.first}] = edge.middle;
    }
    for (const FacetRow& facet : facets_of(row().type)) {
        const auto nodes = facet_nodes(facet);
        for (const EdgeRow& side : edges_of(facet.type)) {
            ASSERT_EQ(side.middle == kNoLocalNode, row().order == 1) << row().name;
            if (side.middle == kNoLocalNode) continue;
            EXPECT_EQ((middle[{nodes[side.first], nodes[side.second]}]), nodes[side.middle]) << row().name;
        }
    }
}

TEST_P(EveryElement, the_centre_node_of_a_facet_is_the_mean_of_its_corners) {
    for (const FacetRow& facet : facets_of(row().type)) {
        if (facet.type != ElementType::Quad9) continue;
        Vector mean{};
        for (const std::uint8_t corner : facet_corners(facet)) {
            for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] += at(row(), corner)[axis] / 4;
        }
        EXPECT_EQ(at(row(), facet.nodes[8]), mean) << row().name;
    }
}

TEST_P(EveryElement, its_linear_type_has_the_same_corners) {
    const ElementRow& linear = element_row(row().linear);

    EXPECT_EQ(linear.order, 1);
    EXPECT_EQ(linear.dimension, row().dimension);
    EXPECT_EQ(linear.corner_count, row().corner_count);
    EXPECT_EQ(linear.node_count, row().corner_count);
    for (std::size_t i = 0; i < row().corner_count; ++i) EXPECT_EQ(linear.reference[i], row().reference[i]);
}

INSTANTIATE_TEST_SUITE_P(
    Table,
    EveryElement,
    testing::Range(0, static_cast<int>(kElementTypeCount)),
    [](const auto& row) { return std::string(element_row(static_cast<ElementType>(row.param)).name); }
);

}  // namespace
}  // namespace feelem
