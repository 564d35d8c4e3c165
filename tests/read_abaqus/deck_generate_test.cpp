// SPDX-License-Identifier: Apache-2.0
// Keywords that make nodes and elements out of others, with places and numbers worked out by hand.
#include "open_deck.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace feelem {
namespace {

using namespace tests;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kHalfRoot = 0.70710678118654752;

std::vector<std::int64_t> nodes_of(const Mesh& mesh, std::int64_t element) {
    std::vector<std::int64_t> ids;
    for (const ElementBlock& block : mesh.blocks) {
        const std::size_t width = element_row(block.type).node_count;
        for (std::size_t i = 0; i < block.ids.size(); ++i) {
            if (block.ids[i] != ElementId{element}) continue;
            for (std::size_t k = 0; k < width; ++k)
                ids.push_back(raw(mesh.node_ids[raw(block.nodes[i * width + k])]));
        }
    }
    return ids;
}

std::string message_of(const Opened& opened) {
    const auto entries = opened.diagnostics->entries();
    return entries.empty() ? "" : entries.front().where + ": " + entries.front().text;
}

void expect_too_large(const std::string& text) {
    try {
        open_deck(text);
        ADD_FAILURE() << "opened: " << text;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::TooLarge) << text;
        EXPECT_THAT(error.what(), HasSubstr("job.inp")) << text;
    }
}

TEST(Ngen, line_has_equal_intervals_and_its_set_holds_the_ends) {
    const Opened opened =
        open_deck("*NODE\n1,0,0,0\n11,10,5,-5\n12,0,0,1\n*NGEN,NSET=LINE\n1,11,2\n*NGEN\n12,12\n");
    EXPECT_THAT(node_ids(opened.mesh()), ElementsAre(1, 3, 5, 7, 9, 11, 12));
    expect_place(opened.mesh(), 5, {4, 2, -2});
    expect_place(opened.mesh(), 9, {8, 4, -4});
    EXPECT_THAT(set_nodes(opened.mesh(), "LINE"), ElementsAre(1, 3, 5, 7, 9, 11));
    EXPECT_THAT(message_of(opened), HasSubstr("job.inp:8")) << "from 12 to 12 there is nothing to make";
}

TEST(Ngen, descending_line_needs_a_descending_increment) {
    const Opened opened = open_deck("*NODE\n1,0\n5,8\n*NGEN\n5,1,-2\n*NGEN\n5,1\n*NGEN\n1,5,3\n*NGEN\n1,6\n");
    EXPECT_THAT(node_ids(opened.mesh()), ElementsAre(1, 3, 5));
    expect_place(opened.mesh(), 3, {4, 0, 0});
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownBlock), 3U);
}

TEST(Ngen, arc_goes_the_shorter_way_round_its_centre) {
    // The centre as coordinates, as a node, and by default the origin.
    for (const char* centre : {",,1,1,0", ",7", ",7,1,1,0"}) {
        const Opened opened =
            open_deck(std::string("*NODE\n1,3,1\n5,1,3\n7,1,1\n*NGEN,LINE=C\n1,5,1") + centre + "\n");
        expect_place(opened.mesh(), 3, {1 + 2 * kHalfRoot, 1 + 2 * kHalfRoot, 0});
        expect_place(
            opened.mesh(), 2, {1 + 2 * std::cos(std::acos(-1) / 8), 1 + 2 * std::sin(std::acos(-1) / 8), 0}
        );
    }
    const Opened about_origin = open_deck("*NODE\n1,0,2\n3,-2,0\n*NGEN, LINE=C\n1,3\n");
    expect_place(about_origin.mesh(), 2, {-2 * kHalfRoot, 2 * kHalfRoot, 0});
}

TEST(Ngen, arc_of_180_degrees_and_more_turns_right_handed_about_its_normal) {
    const std::string nodes = "*NODE\n1,2,0\n4,0,-2\n5,-2,0\n*NGEN,LINE=C\n";
    const Opened three_quarters = open_deck(nodes + "1,4,1,,0,0,0,0,0,1\n");
    expect_place(three_quarters.mesh(), 2, {0, 2, 0});
    expect_place(three_quarters.mesh(), 3, {-2, 0, 0});
    const Opened other_way = open_deck(nodes + "1,4,1,,0,0,0,0,0,-1\n");
    expect_place(other_way.mesh(), 2, {2 * std::sqrt(0.75), -1, 0});
    const Opened half = open_deck(nodes + "1,5,2,,0,0,0,0,0,1\n");
    expect_place(half.mesh(), 3, {0, 2, 0});
    const Opened without = open_deck(nodes + "1,5,2\n");
    EXPECT_THAT(node_ids(without.mesh()), ElementsAre(1, 4, 5));
    EXPECT_THAT(message_of(without), HasSubstr("180 degrees"));
    const Opened circle = open_deck("*NODE\n1,2,0\n5,2,0\n*NGEN,LINE=C\n1,5,1,,,,,,,1\n");
    expect_place(circle.mesh(), 2, {0, 2, 0});
    expect_place(circle.mesh(), 4, {0, -2, 0});
}

TEST(Ngen, arc_whose_ends_are_not_equally_far_is_left_out) {
    const Opened opened = open_deck("*NODE\n1,2,0\n3,0,3\n*NGEN,LINE=C\n1,3\n");
    EXPECT_THAT(node_ids(opened.mesh()), ElementsAre(1, 3));
    EXPECT_THAT(message_of(opened), HasSubstr("job.inp:5"));
}

TEST(Ngen, centre_is_given_in_the_systems_that_the_deck_names) {
    // *SYSTEM moves by 10 along X; SYSTEM=C gives the centre as radius and angle.
    const Opened opened =
        open_deck("*SYSTEM\n10,0,0\n*NODE\n1,2,1\n3,0,3\n*NGEN,LINE=C,SYSTEM=C\n1,3,1,,1,90,0\n");
    expect_place(opened.mesh(), 1, {12, 1, 0});
    expect_place(opened.mesh(), 2, {10 + 2 * kHalfRoot, 1 + 2 * kHalfRoot, 0});
}

TEST(Ngen, parabola_goes_through_its_middle_and_says_how_it_is_spaced) {
    const Opened opened = open_deck("*NODE\n1,0,0\n5,4,0\n*NGEN,LINE=P\n1,5,1,,2,1,0\n");
    expect_place(opened.mesh(), 2, {1, 0.75, 0});
    expect_place(opened.mesh(), 3, {2, 1, 0});
    EXPECT_THAT(message_of(opened), HasSubstr("LINE=P"));
}

TEST(Nfill, pairs_nodes_in_ascending_order_and_its_set_holds_the_bounds) {
    const Opened opened =
        open_deck("*NODE\n1,0,0\n2,0,1\n31,3,0\n32,3,4\n*NSET,NSET=A\n2,1\n*NSET,NSET=B\n31,32\n"
                  "*NFILL,NSET=ALL\nA,B,3,10\n");
    EXPECT_THAT(node_ids(opened.mesh()), ElementsAre(1, 2, 11, 12, 21, 22, 31, 32));
    expect_place(opened.mesh(), 11, {1, 0, 0});
    expect_place(opened.mesh(), 22, {2, 3, 0});
    EXPECT_THAT(set_nodes(opened.mesh(), "ALL"), ElementsAre(1, 2, 11, 12, 21, 22, 31, 32));
    EXPECT_TRUE(opened.diagnostics->entries().empty());
}

TEST(Nfill, unsorted_sets_are_paired_as_they_are_given) {
    const Opened opened =
        open_deck("*NODE\n1,0,0\n2,0,1\n21,2,0\n22,2,1\n*NSET,NSET=TWO\n2\n*NSET,NSET=A,UNSORTED\nTWO,1\n"
                  "*NSET,NSET=B\n21,22\n*NFILL\nA,B,2,1\n");
    // 2 with 21 and 1 with 22.
    expect_place(opened.mesh(), 3, {1, 0.5, 0});
    EXPECT_THAT(node_ids(opened.mesh()), ElementsAre(1, 2, 3, 21, 22));
    // The second pair is made last, over the first's node 2... 1 + 1 = 2.
    expect_place(opened.mesh(), 2, {1, 0.5, 0});
}

TEST(Nfill, what_cannot_be_done_is_named_with_its_line) {
    const std::string nodes =
        "*NODE\n1,0\n2,1\n21,2\n22,2,1\n23,2,2\n*NSET,NSET=A\n1,2\n*NSET,NSET=B\n21,22,23\n"
        "*NSET,NSET=C\n1,99\n";
    EXPECT_THAT(message_of(open_deck(nodes + "*NFILL,BIAS=0.5\nA,B,2,10\n")), HasSubstr("BIAS"));
    EXPECT_THAT(message_of(open_deck(nodes + "*NFILL,SINGULAR=1\nA,B,2,10\n")), HasSubstr("SINGULAR"));
    EXPECT_THAT(message_of(open_deck(nodes + "*NFILL\nA,B,2,10\n")), HasSubstr("2 nodes of \"A\" with 3"));
    EXPECT_THAT(message_of(open_deck(nodes + "*NFILL\nC,B,2,10\n")), HasSubstr("1 nodes that are not"));
    EXPECT_THAT(message_of(open_deck(nodes + "*NFILL\nA,D,2,10\n")), HasSubstr("2 and 0 nodes"));
    EXPECT_THAT(message_of(open_deck(nodes + "*NFILL\nA,B,2,3\n")), HasSubstr("1 and 21"));
    EXPECT_THAT(message_of(open_deck(nodes + "*NFILL\nA,B,2,0\n")), HasSubstr("job.inp:14"));
    for (const char* option : {"*NFILL,BIAS=0.5\nA,B,2,10\n", "*NFILL\nC,B,2,10\n", "*NFILL\nA,B,2,3\n"})
        EXPECT_EQ(open_deck(nodes + option).mesh().node_count(), 5U) << option;
}

TEST(Ncopy, shift_moves_once_and_turns_as_often_as_multiple_says) {
    const std::string nodes = "*NODE,NSET=OLD\n1,1,0\n2,2,0\n";
    const Opened moved =
        open_deck(nodes + "*NCOPY,CHANGE NUMBER=100,OLD SET=OLD,NEW SET=NEW,SHIFT\n0,0,5\n0.0,\n");
    EXPECT_THAT(set_nodes(moved.mesh(), "NEW"), ElementsAre(101, 102));
    expect_place(moved.mesh(), 102, {2, 0, 5});
    const Opened turned =
        open_deck(nodes + "*NCOPY,CHANGE NUMBER=10,OLD SET=OLD,SHIFT\n1,,\n0,0,0,0,0,1,90\n");
    expect_place(turned.mesh(), 12, {0, 3, 0});
    const Opened twice =
        open_deck(nodes + "*NCOPY,CHANGE NUMBER=10,OLD SET=OLD,SHIFT,MULTIPLE=2\n1,,\n0,0,0,0,0,1,90\n");
    expect_place(twice.mesh(), 12, {-3, 0, 0});
    EXPECT_TRUE(twice.diagnostics->entries().empty());
}

TEST(Ncopy, reflections_and_poles_put_the_copy_on_the_other_side) {
    const std::string nodes = "*NODE,NSET=OLD\n1,1,2,3\n*NODE\n9,0,0,1\n*NCOPY,CHANGE NUMBER=1,OLD SET=OLD,";
    expect_place(open_deck(nodes + "REFLECT=POINT\n1,1,1\n").mesh(), 2, {1, 0, -1});
    // About the line through (0, 0, 1) along Z.
    expect_place(open_deck(nodes + "REFLECT=LINE\n0,0,1,0,0,4\n").mesh(), 2, {-1, -2, 3});
    // In the plane x = 4.
    expect_place(open_deck(nodes + "REFLECT=MIRROR\n4,0,0,4,1,0\n4,0,1\n").mesh(), 2, {7, 2, 3});
    // The old node is halfway between the pole and the new one.
    expect_place(open_deck(nodes + "POLE\n9\n").mesh(), 2, {2, 4, 5});
    for (const char* bad :
         {"REFLECT=MIRROR\n4,0,0,4,1,0\n4,2,0\n",
          "POLE\n8\n",
          "POLE\n,0,0,0\n",
          "REFLECT=X\n0,0,0\n",
          "\n"}) {
        const Opened opened = open_deck(nodes + bad);
        EXPECT_EQ(opened.mesh().node_count(), 2U) << bad;
        EXPECT_THAT(message_of(opened), HasSubstr("job.inp:5")) << bad;
    }
}

TEST(Nmap, maps_the_nodes_that_are_in_the_set_by_then) {
    const std::string nodes = "*NODE,NSET=N\n1,2,90,3\n";
    const auto mapped = [&](const std::string& type, const std::string& lines) {
        const Opened opened =
            open_deck(nodes + "*NMAP,NSET=N,TYPE=" + type + "\n" + lines + "*NODE,NSET=N\n2,7,7,7\n");
        EXPECT_EQ(place_of(opened.mesh(), 2), (Point3{7, 7, 7})) << type;
        EXPECT_TRUE(opened.diagnostics->entries().empty()) << type;
        return place_of(opened.mesh(), 1);
    };
    const auto expect = [](const Point3& found, const Point3& expected) {
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
    };
    expect(mapped("RECTANGULAR", "1,1,1\n"), {3, 91, 4});
    // The second line is empty, the third scales before the shift.
    expect(mapped("RECTANGULAR", "1,1,1\n\n,0.1,2\n"), {3, 10, 7});
    // Local X is global Y, local Y is global Z.
    expect(mapped("RECTANGULAR", "1,0,0,1,5,0\n1,0,7\n"), {4, 2, 90});
    // Axis along global X at y = 1, angle 0 towards global Y: at 90 degrees it points along Z.
    expect(mapped("CYLINDRICAL", "0,1,0,4,1,0\n0,3,0\n"), {3, 1, 2});
    // The polar axis is Z: longitude 90 degrees, latitude 3 scaled by 10.
    expect(mapped("SPHERICAL", "0,0,0,0,0,1\n1,0,0\n1,1,10\n"), {0, 2 * std::sqrt(0.75), 1});
    expect(mapped("DIAMOND", "0,0,0,3,3,0\n0,5,0,0,0,9\n"), {2 * kHalfRoot, 2 * kHalfRoot + 90, 3});
    expect(mapped("SCALE", "1,0,0\n2,0.5,\n"), {3, 45, 3});
    expect(mapped("TRANSLATION", "0,0,0,0,0,5\n-4\n"), {2, 90, -1});
    // About a line along Z through (2, 80, 0).
    expect(mapped("ROTATION", "0,0,0,0,0,5\n2,80,0\n90\n"), {-8, 80, 3});
}

TEST(Nmap, types_without_a_documented_form_leave_the_nodes_and_say_so) {
    for (const char* type : {"TOROIDAL", "BLENDED", "RECTANGULAR,DEFINITION=NODES", "CYLINDRICAL"}) {
        const Opened opened = open_deck(
            std::string("*NODE,NSET=N\n1,2,3,4\n*NMAP,NSET=N,TYPE=") + type + "\n1,0,0,1,0,0\n2,0,0\n"
        );
        EXPECT_EQ(place_of(opened.mesh(), 1), (Point3{2, 3, 4})) << type;
        EXPECT_THAT(message_of(opened), HasSubstr("job.inp:3")) << type;
        EXPECT_THAT(message_of(opened), HasSubstr("stay as they were")) << type;
    }
}

/// Nodes 1 to 48: 4 in X, then 4 rows of them in Y (+10), then 3 layers in Z (+100).
std::string grid_of_nodes() {
    return "*NODE\n1,0,0,0\n4,3,0,0\n*NGEN,NSET=ROW\n1,4\n"
           "*NCOPY,CHANGE NUMBER=30,OLD SET=ROW,SHIFT,NEW SET=BACK\n0,3,0\n0,\n"
           "*NFILL,NSET=FLOOR\nROW,BACK,3,10\n"
           "*NCOPY,CHANGE NUMBER=200,OLD SET=FLOOR,SHIFT,NEW SET=TOP\n0,0,2\n\n"
           "*NFILL,NSET=ALL\nFLOOR,TOP,2,100\n";
}

TEST(Elgen, makes_rows_and_layers_from_a_master) {
    const Opened opened = open_deck(
        grid_of_nodes() +
        "*ELEMENT,TYPE=C3D8\n1,1,2,12,11,101,102,112,111\n*ELGEN,ELSET=BLOCK\n1,3,1,1,3,10,10,2,100,100\n"
        "*SOLID SECTION,ELSET=BLOCK\n"
    );
    EXPECT_EQ(opened.mesh().node_count(), 48U);
    EXPECT_THAT(
        element_ids(opened.mesh()),
        ElementsAre(1, 2, 3, 11, 12, 13, 21, 22, 23, 101, 102, 103, 111, 112, 113, 121, 122, 123)
    );
    EXPECT_THAT(nodes_of(opened.mesh(), 123), ElementsAre(123, 124, 134, 133, 223, 224, 234, 233));
    expect_place(opened.mesh(), 234, {3, 3, 2});
    EXPECT_EQ(set_elements(opened.mesh(), "BLOCK").size(), 18U);
    EXPECT_THAT(part_of_each_element(opened.mesh()), testing::Each("BLOCK"));
    EXPECT_TRUE(opened.diagnostics->entries().empty()) << message_of(opened);
}

TEST(Elgen, counts_elements_without_a_surface_and_reports_what_it_cannot_make) {
    const Opened opened = open_deck(
        grid_of_nodes() +
        "*ELEMENT,TYPE=MASS\n900,1\n*ELEMENT,TYPE=S4\n1,1,2,12,11\n*ELGEN\n900,4\n1,2.0,1\n2,2,10,5\n"
        "*ELGEN\n77,3\n*ELGEN\n1,1,1,1,3,10\n"
    );
    EXPECT_EQ(opened.mesh().skipped_elements.at("MASS"), 4U);
    EXPECT_THAT(element_ids(opened.mesh()), ElementsAre(1, 2, 7));
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownBlock), 2U);
}

TEST(Elcopy, copies_what_is_in_the_set_by_then_and_turns_it_round_where_asked) {
    const std::string deck = grid_of_nodes() +
                             "*ELEMENT,TYPE=S4,ELSET=S\n1,1,2,12,11\n*ELEMENT,TYPE=C3D8,ELSET=S\n"
                             "2,1,2,12,11,101,102,112,111\n*ELEMENT,TYPE=SPRINGA,ELSET=S\n3,1,2\n";
    const Opened plain = open_deck(deck + "*ELCOPY,ELEMENT SHIFT=50,OLD SET=S,SHIFT NODES=1,NEW SET=T\n");
    EXPECT_THAT(element_ids(plain.mesh()), ElementsAre(1, 51, 2, 52));
    EXPECT_THAT(nodes_of(plain.mesh(), 51), ElementsAre(2, 3, 13, 12));
    EXPECT_THAT(set_elements(plain.mesh(), "T"), ElementsAre(51, 52));
    EXPECT_EQ(plain.mesh().skipped_elements.at("SPRINGA"), 2U);
    const Opened turned = open_deck(deck + "*ELCOPY,ELEMENT SHIFT=50,OLD SET=S,SHIFT NODES=1,REFLECT\n");
    EXPECT_THAT(nodes_of(turned.mesh(), 51), ElementsAre(2, 12, 13, 3));
    EXPECT_THAT(nodes_of(turned.mesh(), 52), ElementsAre(2, 12, 13, 3, 102, 112, 113, 103));
    EXPECT_THAT(
        message_of(open_deck(deck + "*ELCOPY,ELEMENT SHIFT=50,OLD SET=U,SHIFT NODES=1\n")), HasSubstr("\"U\"")
    );
}

TEST(Elcopy, reflected_elements_of_every_shape_keep_their_middle_nodes_between_their_corners) {
    for (const auto& [name, type] : std::vector<std::pair<const char*, ElementType>>{
             {"C3D10", ElementType::Tet10},
             {"C3D15", ElementType::Wedge15},
             {"C3D20", ElementType::Hex20},
             {"S6", ElementType::Tri6},
             {"S8R", ElementType::Quad8},
             {"S9R5", ElementType::Quad9},
             {"C3D6", ElementType::Wedge6}}) {
        const ElementRow& row = element_row(type);
        std::string text = "*NODE\n", nodes = "1";
        for (std::size_t i = 0; i < row.node_count; ++i) {
            const auto& at = row.reference[i];
            text += std::to_string(i + 1) + "," + std::to_string(at[0]) + "," + std::to_string(at[1]) + "," +
                    std::to_string(at[2]) + "\n";
            nodes += "," + std::to_string(i + 1) + (i == 14 ? ",\n" : "");
        }
        if (const std::size_t twice = nodes.find(",\n,"); twice != std::string::npos)
            nodes.erase(twice + 2, 1);
        const Opened opened = open_deck(
            text +
            "*NSET,NSET=N,GENERATE\n1,20\n*NCOPY,CHANGE NUMBER=100,OLD "
            "SET=N,REFLECT=MIRROR\n0,0,0,1,0,0\n0,0,1\n"
            "*ELEMENT,ELSET=E,TYPE=" +
            name + "\n" + nodes + "\n*ELCOPY,ELEMENT SHIFT=1,OLD SET=E,SHIFT NODES=100,REFLECT\n"
        );
        const auto found = nodes_of(opened.mesh(), 2);
        ASSERT_EQ(found.size(), row.node_count) << name;
        for (std::size_t e = 0; e < row.edge_count; ++e) {
            const EdgeRow& edge = row.edges[e];
            if (edge.middle == kNoLocalNode) continue;
            const Point3 a = place_of(opened.mesh(), found[edge.first]),
                         b = place_of(opened.mesh(), found[edge.second]);
            const Point3 middle = place_of(opened.mesh(), found[edge.middle]);
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(middle[i], (a[i] + b[i]) / 2, 1e-6) << name << " edge " << e;
        }
        EXPECT_NE(found[1], 102) << name << ": the order is turned round";
        EXPECT_TRUE(opened.diagnostics->entries().empty()) << name << message_of(opened);
    }
}

TEST(Nset, takes_the_nodes_of_the_elements_of_a_set) {
    const Opened opened = open_deck(
        grid_of_nodes() + "*ELEMENT,TYPE=S4,ELSET=E\n1,1,2,12,11\n2,2,3,13,12\n*NSET,NSET=OF E,ELSET=E\n"
                          "*ELEMENT,TYPE=S4,ELSET=E\n3,3,4,14,13\n*NSET,NSET=NONE,ELSET=F\n"
    );
    EXPECT_THAT(set_nodes(opened.mesh(), "OF E"), ElementsAre(1, 2, 3, 11, 12, 13));
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownBlock), 1U);
}

TEST(Generate, works_within_a_part_and_moves_with_its_instances) {
    const Opened opened =
        open_deck("*PART,NAME=P\n*NODE\n1,0\n3,2\n*NGEN,NSET=N\n1,3\n*ELEMENT,TYPE=T3D2\n1,1,2\n*ELGEN,ELSET="
                  "E\n1,2\n*END PART\n"
                  "*ASSEMBLY,NAME=A\n*INSTANCE,NAME=I,PART=P\n0,5,0\n*END INSTANCE\n*END ASSEMBLY\n");
    EXPECT_THAT(element_ids(opened.mesh()), ElementsAre(1, 2));
    expect_place(opened.mesh(), 2, {1, 5, 0});
}

TEST(Generate, few_lines_cannot_ask_for_more_than_the_limit) {
    const std::string two = "*NODE,NSET=A\n1,0\n*NODE,NSET=B\n2000000000,1\n*ELEMENT,TYPE=MASS\n1,1\n";
    expect_too_large(two + "*NGEN\n1,2000000000,1\n");
    expect_too_large(two + "*NFILL\nA,B,2000000000,1\n");
    expect_too_large(two + "*NFILL\nA,B,9000000000000000,1999999999\n");
    expect_too_large(two + "*ELGEN\n1,1000000000,1,1,1000000000,1,1,1000000000,1,1\n");
    expect_too_large(two + "*NCOPY,CHANGE NUMBER=2000000000,OLD SET=B,SHIFT\n0\n");
    expect_too_large(two + "*NCOPY,CHANGE NUMBER=-1,OLD SET=A,SHIFT\n0\n");
}

TEST(Generate, work_on_wide_sets_is_limited_too) {
    std::string text = "*NODE\n1,0\n1000001,1\n*NGEN\n1,1000001\n*NSET,NSET=A,GENERATE\n1,1000001\n";
    for (int i = 0; i < 60; ++i) text += "*NMAP,NSET=A,TYPE=RECTANGULAR\n0.0\n";
    expect_too_large(text);
}

}  // namespace
}  // namespace feelem
