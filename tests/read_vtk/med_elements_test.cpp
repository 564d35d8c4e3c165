// SPDX-License-Identifier: Apache-2.0
// MED's mirrored node order, by geometry: no file of a program that follows it lies in the corpus.
#include "med/med_elements.hpp"
#include "support/exchange_checks.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

namespace feelem::exchange {
namespace {

TEST(MedElements, mirrored_order_turns_every_solid_inside_out_and_back) {
    std::size_t solids = 0;
    for (const MedType& med : med_types()) {
        const ElementRow& row = element_row(med.type);
        const auto order = mirrored_order(med.type);
        EXPECT_EQ(order.size(), row.dimension == 3 ? row.node_count : 0U) << med.name;
        if (order.empty()) continue;
        ++solids;
        Mesh mesh = test::one_element(med.type);
        const std::vector<NodeIndex> right = mesh.blocks[0].nodes;
        for (std::size_t i = 0; i < order.size(); ++i) mesh.blocks[0].nodes[i] = right[order[i]];
        EXPECT_NE(test::wrong_node_order(mesh), "") << med.name;
        EXPECT_EQ(test::wrong_node_order(mesh, true), "") << med.name;
        const std::vector<NodeIndex> turned = mesh.blocks[0].nodes;
        for (std::size_t i = 0; i < order.size(); ++i) mesh.blocks[0].nodes[i] = turned[order[i]];
        EXPECT_EQ(mesh.blocks[0].nodes, right) << med.name;
    }
    EXPECT_EQ(solids, 10U);
}

TEST(MedElements, types_have_at_least_the_nodes_of_their_shape) {
    for (const MedType& med : med_types()) EXPECT_GE(med.nodes, element_row(med.type).node_count) << med.name;
}

}  // namespace
}  // namespace feelem::exchange
