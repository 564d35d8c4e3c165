// SPDX-License-Identifier: Apache-2.0
// Which card is which shape, and where its nodes stand.
#include "read/nastran/nastran_elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace feelem {
namespace {

using namespace nastran;

std::vector<std::int64_t> numbered(std::size_t count) {
    std::vector<std::int64_t> nodes(count);
    std::iota(nodes.begin(), nodes.end(), 1);
    return nodes;
}

/// The card's node between two corners (all 1-based, as the manual counts them), or 0.
std::int64_t middle_of(const ElementNodes& element, std::int64_t first, std::int64_t second) {
    for (const EdgeRow& edge : edges_of(element.type)) {
        const std::int64_t a = raw(element.nodes[edge.first]), b = raw(element.nodes[edge.second]);
        if (std::minmax(a, b) == std::minmax(first, second)) return raw(element.nodes[edge.middle]);
    }
    return 0;
}

ElementNodes whole(std::string_view name) {
    const ElementCard* card = find_element_card(name);
    EXPECT_NE(card, nullptr) << name;
    return arrange_nodes(*card, numbered(card->node_count())).value();
}

TEST(NastranElements, cards_are_in_order_so_that_each_is_found) {
    for (const ElementCard& card : element_cards()) EXPECT_EQ(find_element_card(card.name), &card);
    EXPECT_EQ(find_element_card("CHEX"), nullptr);
    EXPECT_TRUE(is_element_without_surface("RBE2"));
    EXPECT_TRUE(is_element_without_surface("CHBDYE"));
    EXPECT_FALSE(is_element_without_surface("CHEXA"));
}

TEST(NastranElements, every_order_is_a_permutation) {
    for (const ElementCard& card : element_cards()) {
        std::vector<std::uint8_t> order(card.order.begin(), card.order.begin() + card.node_count());
        std::ranges::sort(order);
        for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i) << card.name;
    }
}

// The manual's figures: edges and their mid-side grids.
TEST(NastranElements, midside_grids_stand_on_their_edges) {
    const ElementNodes hexa = whole("CHEXA");
    EXPECT_EQ(middle_of(hexa, 1, 2), 9);
    EXPECT_EQ(middle_of(hexa, 4, 1), 12);
    EXPECT_EQ(middle_of(hexa, 1, 5), 13);
    EXPECT_EQ(middle_of(hexa, 4, 8), 16);
    EXPECT_EQ(middle_of(hexa, 5, 6), 17);
    EXPECT_EQ(middle_of(hexa, 8, 5), 20);
    const ElementNodes penta = whole("CPENTA");
    EXPECT_EQ(middle_of(penta, 1, 2), 7);
    EXPECT_EQ(middle_of(penta, 1, 4), 10);
    EXPECT_EQ(middle_of(penta, 3, 6), 12);
    EXPECT_EQ(middle_of(penta, 4, 5), 13);
    const ElementNodes tetra = whole("CTETRA");
    EXPECT_EQ(middle_of(tetra, 3, 1), 7);
    EXPECT_EQ(middle_of(tetra, 3, 4), 10);
    const ElementNodes pyramid = whole("CPYRAM");
    EXPECT_EQ(middle_of(pyramid, 4, 1), 9);
    EXPECT_EQ(middle_of(pyramid, 4, 5), 13);
    EXPECT_EQ(middle_of(whole("CQUAD8"), 4, 1), 8);
    EXPECT_EQ(middle_of(whole("CTRIA6"), 3, 1), 6);
    // Round the triangle: 1 and 3 are corners, 2 between them.
    EXPECT_EQ(middle_of(whole("CTRIAX6"), 1, 3), 2);
}

TEST(NastranElements, blank_midside_fields_make_simpler_shapes) {
    const ElementCard& hexa = *find_element_card("CHEXA");
    EXPECT_EQ(arrange_nodes(hexa, numbered(8))->type, ElementType::Hex8);
    auto nodes = numbered(8);
    nodes.resize(20);
    nodes[12] = 99;
    const auto some = arrange_nodes(hexa, nodes);
    EXPECT_EQ(some->type, ElementType::Hex20);
    EXPECT_EQ(middle_of(*some, 1, 5), 99);
    EXPECT_EQ(middle_of(*some, 1, 2), 0);
    EXPECT_EQ(arrange_nodes(*find_element_card("CQUADX"), numbered(8))->type, ElementType::Quad8);
    EXPECT_EQ(arrange_nodes(hexa, numbered(7)), std::nullopt);
}

}  // namespace
}  // namespace feelem
