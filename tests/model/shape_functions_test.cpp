// SPDX-License-Identifier: Apache-2.0
// Each row of the table of shape functions against what defines shape functions.
#include "model/shape_functions.hpp"
#include "model/vector.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace feelem {
namespace {

Point3 reference(ElementType type, std::size_t node) {
    const auto& at = element_row(type).reference[node];
    return {at[0], at[1], at[2]};
}

/// Places inside the reference element: its nodes weighted by random positive numbers.
std::vector<Point3> places_inside(ElementType type, std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.01, 1);
    std::vector<Point3> places;
    for (std::size_t k = 0; k < count; ++k) {
        Point3 at{};
        double sum = 0;
        for (std::size_t i = 0; i < element_row(type).corner_count; ++i) {
            const double weight = share(random);
            const Point3 corner = reference(type, i);
            for (std::size_t d = 0; d < 3; ++d) at[d] += weight * corner[d];
            sum += weight;
        }
        for (double& v : at) v /= sum;
        places.push_back(at);
    }
    return places;
}

class ShapeFunctions : public testing::TestWithParam<int> {
protected:
    ElementType type() const { return static_cast<ElementType>(GetParam()); }
    const ElementRow& row() const { return element_row(type()); }
    std::vector<NodeIndex> nodes() const {
        std::vector<NodeIndex> out;
        for (std::uint32_t i = 0; i < row().node_count; ++i) out.push_back(NodeIndex{i});
        return out;
    }
    std::vector<Point3> reference_places() const {
        std::vector<Point3> out;
        for (std::size_t i = 0; i < row().node_count; ++i) out.push_back(reference(type(), i));
        return out;
    }
};

TEST_P(ShapeFunctions, are_one_at_their_own_node_and_zero_at_the_others) {
    for (std::size_t i = 0; i < row().node_count; ++i) {
        const ShapeWeights at = shape_at(type(), reference(type(), i));
        for (std::size_t k = 0; k < row().node_count; ++k)
            EXPECT_NEAR(at[k], i == k ? 1 : 0, 1e-12) << row().name << " function " << k << " at node " << i;
    }
}

TEST_P(ShapeFunctions, add_up_to_one) {
    for (const Point3& at : places_inside(type(), 50)) {
        const ShapeWeights weights = shape_at(type(), at);
        EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-13) << row().name;
    }
}

TEST_P(ShapeFunctions, give_a_linear_field_and_a_quadratic_one_where_they_should) {
    const auto linear = [](const Point3& p) { return 3 + 2 * p[0] - 5 * p[1] + 7 * p[2]; };
    const auto quadratic = [&](const Point3& p) {
        return linear(p) + p[0] * p[0] - 2 * p[1] * p[1] + 3 * p[2] * p[2] + 4 * p[0] * p[1] - p[1] * p[2] +
               6 * p[2] * p[0];
    };
    for (const Point3& at : places_inside(type(), 50)) {
        const ShapeWeights weights = shape_at(type(), at);
        Point3 in = at;
        for (std::size_t d = row().dimension; d < 3; ++d) in[d] = 0;
        double first = 0, second = 0;
        for (std::size_t i = 0; i < row().node_count; ++i) {
            first += weights[i] * linear(reference(type(), i));
            second += weights[i] * quadratic(reference(type(), i));
        }
        EXPECT_NEAR(first, linear(in), 1e-12) << row().name;
        if (row().order == 2) {
            EXPECT_NEAR(second, quadratic(in), 1e-12) << row().name;
        }
    }
}

TEST_P(ShapeFunctions, have_the_slopes_of_their_differences) {
    constexpr double kStep = 1e-6;
    for (const Point3& at : places_inside(type(), 20)) {
        const ShapeSlopes slopes = shape_slopes_at(type(), at);
        const ShapeWeights here = shape_at(type(), at);
        for (std::size_t d = 0; d < row().dimension; ++d) {
            Point3 up = at, down = at;
            up[d] += kStep;
            down[d] -= kStep;
            const ShapeWeights above = shape_at(type(), up), below = shape_at(type(), down);
            for (std::size_t i = 0; i < row().node_count; ++i) {
                EXPECT_EQ(slopes.weights[i], here[i]);
                EXPECT_NEAR(slopes.slopes[i][d], (above[i] - below[i]) / (2 * kStep), 1e-7)
                    << row().name << " function " << i << " by " << d;
            }
        }
    }
}

/// On a facet only the facet's nodes count, and as they do in the facet's own type: neighbours agree.
TEST_P(ShapeFunctions, are_those_of_the_facet_on_a_facet) {
    if (row().dimension != 3) return;
    for (const FacetRow& facet : facets_of(type())) {
        for (const Point3& on : places_inside(facet.type, 10)) {
            const ShapeWeights expected = shape_at(facet.type, on);
            const ShapeWeights linear = shape_at(element_row(facet.type).linear, on);
            Point3 at{};
            for (std::size_t i = 0; i < facet_corners(facet).size(); ++i) {
                const Point3 corner = reference(type(), facet.nodes[i]);
                for (std::size_t d = 0; d < 3; ++d) at[d] += linear[i] * corner[d];
            }
            ShapeWeights found = shape_at(type(), at);
            for (std::size_t i = 0; i < facet_nodes(facet).size(); ++i) {
                EXPECT_NEAR(found[facet.nodes[i]], expected[i], 1e-12) << row().name;
                found[facet.nodes[i]] = 0;
            }
            for (const double rest : found) EXPECT_NEAR(rest, 0, 1e-12) << row().name;
        }
    }
}

TEST_P(ShapeFunctions, without_a_node_are_linear_along_its_edge) {
    for (const EdgeRow& edge : edges_of(type())) {
        if (edge.middle == kNoLocalNode) continue;
        std::vector<NodeIndex> some = nodes();
        some[edge.middle] = kNoNode;
        Point3 at{};
        for (std::size_t d = 0; d < 3; ++d)
            at[d] = 0.75 * reference(type(), edge.first)[d] + 0.25 * reference(type(), edge.second)[d];
        const ShapeWeights weights = shape_at(type(), some, at);
        EXPECT_NEAR(weights[edge.first], 0.75, 1e-12) << row().name;
        EXPECT_NEAR(weights[edge.second], 0.25, 1e-12) << row().name;
        EXPECT_EQ(weights[edge.middle], 0) << row().name;
    }
}

TEST_P(ShapeFunctions, without_an_inner_node_still_give_a_quadratic_field) {
    const std::size_t inner = row().node_count - std::size_t{1};
    const bool has_inner =
        type() == ElementType::Quad9 || type() == ElementType::Wedge18 || type() == ElementType::Hex27;
    if (!has_inner) return;
    std::vector<NodeIndex> some = nodes();
    some[inner] = kNoNode;
    for (const Point3& at : places_inside(type(), 20)) {
        const ShapeWeights weights = shape_at(type(), some, at);
        double sum = 0;
        for (std::size_t i = 0; i < row().node_count; ++i)
            sum += weights[i] * reference(type(), i)[0] * reference(type(), i)[1];
        EXPECT_NEAR(sum, at[0] * at[1], 1e-12) << row().name;
        EXPECT_EQ(weights[inner], 0);
    }
}

/// A bent element, far from the origin: the way from natural coordinates to a place and back.
TEST_P(ShapeFunctions, lead_back_from_a_place_to_where_it_is_in_the_element) {
    if (row().dimension != 3) return;
    std::vector<Point3> bent = reference_places();
    for (Point3& p : bent)
        p = {1000 + p[0] + 0.1 * p[1] * p[2], -500 + p[1] - 0.1 * p[0] * p[0], 2 * p[2] + 0.1 * p[0] * p[1]};
    for (const Point3& at : places_inside(type(), 50)) {
        const ShapeWeights weights = shape_at(type(), at);
        Point3 place{};
        for (std::size_t i = 0; i < bent.size(); ++i) {
            for (std::size_t d = 0; d < 3; ++d) place[d] += weights[i] * bent[i][d];
        }
        const auto found = find_natural(type(), nodes(), bent, place);
        ASSERT_TRUE(found) << row().name;
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR((*found)[d], at[d], 1e-9) << row().name;
    }
}

TEST_P(ShapeFunctions, know_inside_from_outside) {
    if (row().dimension != 3) return;
    EXPECT_GT(depth_inside(type(), reference_centre(type())), 0.1);
    for (const Point3& at : places_inside(type(), 20)) EXPECT_GT(depth_inside(type(), at), 0);
    for (std::size_t i = 0; i < row().node_count; ++i) {
        const Point3 at = reference(type(), i), centre = reference_centre(type());
        Point3 beyond{};
        for (std::size_t d = 0; d < 3; ++d) beyond[d] = at[d] + 0.01 * (at[d] - centre[d]);
        const bool is_centre = length(minus(at, centre)) < 1e-6;
        EXPECT_EQ(depth_inside(type(), beyond) < 0, !is_centre) << row().name << " node " << i;
        EXPECT_NEAR(is_centre ? 0.5 : 0, depth_inside(type(), at), 1e-7) << row().name;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Rows,
    ShapeFunctions,
    testing::Range(0, static_cast<int>(kElementTypeCount)),
    [](const auto& row) { return std::string(element_row(static_cast<ElementType>(row.param)).name); }
);

}  // namespace
}  // namespace feelem
