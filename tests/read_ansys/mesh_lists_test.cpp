// SPDX-License-Identifier: Apache-2.0
// Node, element and type lists in all their forms. SYNTHETIC: the texts here were written by hand after real
// ones or after the documentation, not by Ansys.
#include "read_ansys/opened_lists.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace feelem {
namespace {

using test::all_texts;
using test::open_texts;
using test::text_of;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kNodeHead = "\n LIST ALL SELECTED NODES.   DSYS=      0\n\n   NODE        X                "
                              "   Y                   Z\n";
const std::string kElementHead =
    "\n LIST ALL SELECTED ELEMENTS.  (LIST NODES)\n \n    ELEM MAT TYP REL ESY SEC        NODES\n \n";

/// The corners of a unit brick, 1..8.
const std::string kBrickNodes = kNodeHead +
                                "       1     0.00000000000       0.00000000000       0.00000000000    \n"
                                "       2     1.00000000000       0.00000000000       0.00000000000    \n"
                                "       3     1.00000000000       1.00000000000       0.00000000000    \n"
                                "       4     0.00000000000       1.00000000000       0.00000000000    \n"
                                "       5     0.00000000000       0.00000000000       1.00000000000    \n"
                                "       6     1.00000000000       0.00000000000       1.00000000000    \n"
                                "       7     1.00000000000       1.00000000000       1.00000000000    \n"
                                "       8     0.00000000000       1.00000000000       1.00000000000    \n";

std::string element(const std::string& nodes, int type = 1, int id = 1, int material = 1) {
    std::string row(64, '\0');
    row.resize(static_cast<std::size_t>(
        std::snprintf(row.data(), row.size(), "%8d%4d%4d   1   0   1", id, material, type)
    ));
    return row + " " + nodes + "\n";
}

Code code_of(const std::vector<std::string>& texts, const std::string& types = "") {
    try {
        open_texts(texts, types);
    } catch (const Error& error) {
        return error.code();
    }
    ADD_FAILURE() << "no error";
    return Code::BadScene;
}

std::string with_line_ends(std::string text, const std::string& end) {
    std::string out;
    for (const char c : text) {
        if (c == '\n')
            out += end;
        else
            out += c;
    }
    return out;
}

TEST(NodeLists, line_ends_of_any_kind_read_alike) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const auto opened = open_texts({with_line_ends(kBrickNodes, end)});
        EXPECT_EQ(opened.model->mesh().node_count(), 8u);
        EXPECT_EQ(opened.model->mesh().coordinates.back(), (Point3{0, 1, 1}));
        EXPECT_TRUE(opened.diagnostics->entries().empty()) << all_texts(*opened.diagnostics);
    }
}

TEST(NodeLists, pages_prompts_banners_and_page_feeds_are_no_nodes) {
    const auto opened =
        open_texts({" LIST ALL SELECTED NODES.   DSYS=      0\n SORT TABLE ON  NODE  NODE  NODE\n\n"
                    "   NODE        X                   Y                   Z\n"
                    "       1    0.700000000000E-01  0.862435565298E-01 -0.250000000000E-01\n"
                    "\n MORE (YES,NO OR CONTINUOUS)=\n"
                    "1\n\n *** ANSYS - ENGINEERING ANALYSIS SYSTEM  RELEASE 2021 R2          21.2     ***\n"
                    " Ansys Mechanical Enterprise\n"
                    " 00000000  VERSION=LINUX x64     15:56:42  JAN 13, 2022 CP=      0.665\n"
                    " 2 boilers\n\n"
                    "   NODE        X                   Y                   Z\n"
                    "       6    0.350000000000E-01  0.121243556530     -0.250000000000E-01\n"});
    const Mesh& mesh = opened.model->mesh();
    EXPECT_THAT(mesh.node_ids, ElementsAre(NodeId{1}, NodeId{6}));
    EXPECT_EQ(mesh.coordinates[1], (Point3{0.035, 0.12124355653, -0.025}));
    EXPECT_TRUE(opened.diagnostics->entries().empty()) << all_texts(*opened.diagnostics);
}

TEST(NodeLists, angles_are_read_and_zero_angles_are_none) {
    const std::string head = "   NODE        X           Y           Z         THXY    THYZ    THZX\n";
    const auto rotated =
        open_texts({head + "       7    2.8453    -0.66331E-02  0.0000       90.00   -5.50    0.00\n"});
    ASSERT_EQ(rotated.model->mesh().node_angles.size(), 1u);
    EXPECT_EQ(rotated.model->mesh().node_angles[0], (NodalAngles{90, -5.5, 0}));
    EXPECT_TRUE(rotated.diagnostics->has(Code::LowPrecision));

    const auto straight =
        open_texts({head + "       7    2.8453    -0.66331E-02  0.0000        0.00    0.00    0.00\n"});
    EXPECT_TRUE(straight.model->mesh().node_angles.empty());
}

TEST(NodeLists, touching_columns_and_exponents_without_a_letter_come_apart) {
    const auto opened =
        open_texts({kNodeHead + "       1   -0.700000000000E-01-0.862435565298E-01-0.250000000000-101\n"});
    EXPECT_EQ(opened.model->mesh().coordinates[0], (Point3{-0.07, -0.0862435565298, -0.25e-101}));
}

TEST(NodeLists, commas_between_columns_are_read) {
    const auto opened = open_texts({"  NODE, X, Y, Z\n 1, 0.5, 1.5, 2.5\n 20, -0.5, 0.0, 1.0E+02\n"});
    EXPECT_EQ(opened.model->mesh().coordinates[1], (Point3{-0.5, 0, 100}));
}

TEST(NodeLists, another_display_system_is_warned_of) {
    const auto opened =
        open_texts({" LIST ALL SELECTED NODES.   DSYS=      1\n\n   NODE        X                   Y        "
                    "           Z\n"
                    "       1     10.0000000000       90.0000000000       0.00000000000    \n"});
    EXPECT_THAT(text_of(*opened.diagnostics, Code::CoordinateSystem), HasSubstr("DSYS=1"));
}

TEST(NodeLists, rows_without_any_title_are_nodes) {
    const auto opened =
        open_texts({"       1    0.700000000000E-01  0.862435565298E-01 -0.250000000000E-01\n"
                    "       2    0.700000000000E-01  0.962435565298E-01   0.00000000000    \n"});
    EXPECT_EQ(opened.model->mesh().node_count(), 2u);
    EXPECT_TRUE(opened.model->results().empty());
}

TEST(NodeLists, a_row_that_the_file_cuts_is_left_out) {
    const auto opened =
        open_texts({kBrickNodes + "       9     0.50000000000       0.50000000000       0.5000"});
    EXPECT_EQ(opened.model->mesh().node_count(), 8u);
    EXPECT_EQ(opened.diagnostics->count(Code::TruncatedInput), 1u);

    const auto whole =
        open_texts({kBrickNodes + "       9     0.50000000000       0.50000000000       0.50000000000    "});
    EXPECT_EQ(whole.model->mesh().node_count(), 9u);
    EXPECT_FALSE(whole.diagnostics->has(Code::TruncatedInput));
}

TEST(NodeLists, a_damaged_number_is_an_error_with_its_line) {
    try {
        open_texts({kBrickNodes + "       9     0.5x000000000       0.50000000000       0.50000000000    \n"}
        );
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::BadNumber);
        EXPECT_EQ(error.where(), "a.lis:13");
    }
}

TEST(NodeLists, a_node_listed_twice_with_other_coordinates_is_reported) {
    const auto opened = open_texts(
        {kBrickNodes, kNodeHead + "       1     9.00000000000       0.00000000000       0.00000000000    \n"}
    );
    EXPECT_EQ(opened.diagnostics->count(Code::DuplicateNode), 1u);
    EXPECT_EQ(opened.model->mesh().coordinates[0], (Point3{9, 0, 0}));
}

TEST(ElementLists, continuation_lines_and_page_heads_belong_to_one_list) {
    const auto opened = open_texts(
        {kBrickNodes,
         kElementHead + element("    2     1     4     3     6     5     8     7") +
             " \n    ELEM MAT TYP REL ESY SEC        NODES\n \n" +
             element("    1     2     3     4     5     6     7     8", 1, 2) +
             "                                  0     0     0     0     0     0     0     0\n"
             "                                  0     0     0     0\n",
         " ELEMENT TYPE          1 IS SOLID186     3-D 20-NODE STRUCTURAL SOLID\n  KEYOPT( 1- 6)=        0   "
         "   0      0\n"}
    );
    const Mesh& mesh = opened.model->mesh();
    ASSERT_EQ(mesh.blocks.size(), 1u) << all_texts(*opened.diagnostics);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Hex8);  // No mid-side node is there.
    EXPECT_EQ(mesh.blocks[0].ids.size(), 2u);
}

TEST(ElementLists, abbreviated_head_of_the_paper_is_read) {
    const auto opened = open_texts(
        {kBrickNodes, "  EL MAT TYP REL ESY SEC    NODES\n" + element("    1     2     3     5")},
        "1=SOLID285"
    );
    EXPECT_EQ(opened.model->mesh().blocks.at(0).type, ElementType::Tet4);
}

TEST(ElementLists, six_digit_ids_that_touch_are_cut_by_width) {
    std::string nodes = kNodeHead;
    for (const char* row :
         {"  100001     0.00000000000       0.00000000000       0.00000000000    \n",
          "  100002     1.00000000000       0.00000000000       0.00000000000    \n",
          "  100003     1.00000000000       1.00000000000       0.00000000000    \n",
          "     999     0.00000000000       1.00000000000       0.00000000000    \n"}) {
        nodes += row;
    }
    const auto opened = open_texts(
        {nodes, kElementHead + "       1   1   1   1   0   1 100001100002100003   999\n"}, "1=SHELL181"
    );
    ASSERT_EQ(opened.model->mesh().element_count(), 1u) << all_texts(*opened.diagnostics);
    EXPECT_EQ(opened.model->mesh().blocks[0].type, ElementType::Quad4);
}

TEST(ElementLists, wide_ids_of_newer_releases_are_not_cut) {
    const auto opened = open_texts(
        {kNodeHead + "  1000001     0.00000000000       0.00000000000       0.00000000000    \n"
                     "  1000002     1.00000000000       0.00000000000       0.00000000000    \n",
         "    ELEM MAT TYP REL ESY SEC        NODES\n 100000001    1    1    1    0    1   1000001   "
         "1000002\n"},
        "1=LINK180"
    );
    ASSERT_EQ(opened.model->mesh().element_count(), 1u) << all_texts(*opened.diagnostics);
    EXPECT_EQ(opened.model->mesh().blocks[0].ids[0], ElementId{100000001});
}

TEST(ElementLists, attributes_of_four_digits_that_touch_are_cut_by_width) {
    const auto opened =
        open_texts({kBrickNodes, kElementHead + "       11234   11000   0   1     1     2\n"}, "1=LINK180");
    ASSERT_EQ(opened.model->mesh().parts.size(), 1u) << all_texts(*opened.diagnostics);
    EXPECT_EQ(opened.model->mesh().parts[0].name, "material 1234");
}

TEST(ElementLists, short_rows_leave_out_midside_nodes) {
    const auto opened = open_texts(
        {kBrickNodes, kElementHead + element("    1     2     3     5     4     0     7")}, "1=SOLID92"
    );
    ASSERT_EQ(opened.model->mesh().blocks.size(), 1u);
    EXPECT_EQ(opened.model->mesh().blocks[0].type, ElementType::Tet10);
    EXPECT_EQ(opened.diagnostics->count(Code::MissingMidside), 4u);
}

TEST(ElementLists, degenerate_rows_become_what_they_are) {
    const auto opened = open_texts(
        {kBrickNodes,
         kElementHead + element("    1     2     3     3     5     6     7     7") +
             element("    1     2     3     3     5     5     5     5", 1, 2) +
             element("    1     2     3     4     5     5     5     5", 1, 3) +
             element("    1     2     3     3", 2, 4)},
        "1=185,2=shell63"
    );
    const Mesh& mesh = opened.model->mesh();
    ASSERT_EQ(mesh.blocks.size(), 4u);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Wedge6);
    EXPECT_EQ(mesh.blocks[1].type, ElementType::Tet4);
    EXPECT_EQ(mesh.blocks[2].type, ElementType::Pyramid5);
    EXPECT_EQ(mesh.blocks[3].type, ElementType::Tri3);
}

TEST(ElementLists, orientation_and_extra_nodes_are_no_geometry) {
    const auto opened = open_texts({kBrickNodes, kElementHead + element("    1     2     5")}, "1=BEAM188");
    ASSERT_EQ(opened.model->mesh().blocks.size(), 1u);
    EXPECT_EQ(opened.model->mesh().blocks[0].type, ElementType::Line2);
}

TEST(ElementLists, a_type_with_fewer_nodes_than_listed_is_warned_of) {
    const auto shells = open_texts({kBrickNodes, kElementHead + element("1 2 3 4 5 6 7 8")}, "1=SHELL63");
    EXPECT_THAT(
        text_of(*shells.diagnostics, Code::GuessedElementType), HasSubstr("list 8 nodes, but SHELL63 has 4")
    );
    const auto bricks = open_texts({kBrickNodes, kElementHead + element("1 2 3 4 5 6 7 8")}, "1=SOLID185");
    EXPECT_EQ(text_of(*bricks.diagnostics, Code::GuessedElementType), "");
}

TEST(ElementLists, contact_and_surface_effect_are_counted_by_name) {
    const auto opened = open_texts(
        {kBrickNodes,
         kElementHead + element("    1     2     3     4", 2) + element("    1     2     3     4", 3, 2) +
             element("    1     2     3     4     5     6     7     8", 1, 3)},
        "1=SOLID45,2=CONTA173,3=SURF154"
    );
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.element_count(), 1u);
    EXPECT_EQ(mesh.skipped_elements, (std::map<std::string, std::uint64_t>{{"CONTA173", 1}, {"SURF154", 1}}));
    EXPECT_FALSE(opened.diagnostics->has(Code::UnknownElementType));
}

TEST(ElementLists, unknown_types_are_left_out_and_named) {
    const auto opened = open_texts(
        {kBrickNodes,
         kElementHead + element("    1     2     3     4     5     6     7     8"),
         " ELEMENT TYPE        1 IS FANCY999\n"}
    );
    EXPECT_EQ(opened.model->mesh().element_count(), 0u);
    EXPECT_THAT(text_of(*opened.diagnostics, Code::UnknownElementType), HasSubstr("FANCY999"));
}

TEST(ElementLists, mesh200_takes_its_shape_from_keyopt_1) {
    const auto opened = open_texts(
        {kBrickNodes,
         kElementHead + element("    1     2     3     4     5     6     7     8"),
         " ELEMENT TYPE        1 IS MESH200\n  KEYOPT( 1- 6)=       10      0      0        0      0      "
         "0\n"}
    );
    EXPECT_EQ(opened.model->mesh().blocks.at(0).type, ElementType::Hex8);
}

TEST(ElementLists, eight_nodes_without_a_type_are_told_apart_by_geometry) {
    const auto brick =
        open_texts({kBrickNodes, kElementHead + element("    1     2     3     4     5     6     7     8")});
    EXPECT_EQ(brick.model->mesh().blocks.at(0).type, ElementType::Hex8);
    EXPECT_THAT(text_of(*brick.diagnostics, Code::GuessedElementType), HasSubstr("--types 1=NAME"));

    const auto shell = open_texts(
        {kNodeHead + "       1     0.00000000000       0.00000000000       0.00000000000    \n"
                     "       2     2.00000000000       0.00000000000       0.00000000000    \n"
                     "       3     2.00000000000       2.00000000000       0.00000000000    \n"
                     "       4     0.00000000000       2.00000000000       0.00000000000    \n"
                     "       5     1.00000000000       0.00000000000      0.100000000000    \n"
                     "       6     2.00000000000       1.00000000000       0.00000000000    \n"
                     "       7     1.00000000000       2.00000000000      0.100000000000    \n"
                     "       8     0.00000000000       1.00000000000       0.00000000000    \n",
         kElementHead + element("    1     2     3     4     5     6     7     8")}
    );
    EXPECT_EQ(shell.model->mesh().blocks.at(0).type, ElementType::Quad8);
}

TEST(ElementLists, four_nodes_without_a_type_are_a_shell_when_flat) {
    const auto flat = open_texts({kBrickNodes, kElementHead + element("    1     2     3     4")});
    EXPECT_EQ(flat.model->mesh().blocks.at(0).type, ElementType::Quad4);
    const auto tet = open_texts({kBrickNodes, kElementHead + element("    1     2     3     5")});
    EXPECT_EQ(tet.model->mesh().blocks.at(0).type, ElementType::Tet4);
}

TEST(ElementLists, given_types_win_over_listed_ones) {
    const std::vector<std::string> texts{
        kBrickNodes,
        kElementHead + element("    1     2     3     4"),
        " ELEMENT TYPE        1 IS SURF154\n"};
    EXPECT_EQ(open_texts(texts).model->mesh().element_count(), 0u);
    EXPECT_EQ(open_texts(texts, "1=SHELL63").model->mesh().element_count(), 1u);
    EXPECT_EQ(code_of(texts, "1=SOLID9999"), Code::BadOption);
    EXPECT_EQ(code_of(texts, "one=SHELL63"), Code::BadOption);
    EXPECT_EQ(code_of(texts, "/nowhere/ETLIST.lis"), Code::FileNotFound);
    EXPECT_EQ(
        open_texts({texts[0], texts[1]}, test::project_file("examples/boiler/hex_linear/ETLIST.lis"))
            .model->mesh()
            .element_count(),
        0u
    ) << "four nodes make no SOLID185";
}

TEST(ElementLists, nodes_that_nobody_lists_leave_their_elements_out) {
    const auto opened =
        open_texts({kBrickNodes, kElementHead + element("    1     2     3    77")}, "1=SHELL63");
    EXPECT_EQ(opened.model->mesh().element_count(), 0u);
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownNode), 1u);
}

TEST(ElementLists, an_element_listed_twice_counts_once) {
    const std::string list = kElementHead + element("    1     2     3     4");
    const auto opened = open_texts({kBrickNodes, list, list}, "1=SHELL63");
    EXPECT_EQ(opened.model->mesh().element_count(), 1u);
    EXPECT_EQ(opened.diagnostics->count(Code::DuplicateElement), 1u);
}

TEST(ElementLists, without_their_nodes_are_refused_as_a_mesh) {
    const std::string list =
        " LIST ALL SELECTED ELEMENTS IN RANGE         1  TO         1  STEP       1\n DO NOT LIST NODES\n\n"
        "    ELEM MAT TYP REL ESY SEC\n\n       1   1   1   1  13   3\n";
    EXPECT_EQ(code_of({list}), Code::NotAMesh);
    const auto opened = open_texts({kBrickNodes, list});
    EXPECT_EQ(opened.model->mesh().element_count(), 0u);
    EXPECT_TRUE(opened.diagnostics->has(Code::NotAMesh));
}

TEST(ElementLists, elements_without_a_node_list_say_so) {
    const auto opened = open_texts({kElementHead + element("    1     2     3     4")}, "1=SHELL63");
    EXPECT_EQ(opened.model->mesh().element_count(), 1u);
    EXPECT_TRUE(std::isnan(opened.model->mesh().coordinates.at(0)[0]));
    EXPECT_TRUE(opened.diagnostics->has(Code::NotAMesh));
}

TEST(ElementLists, an_element_that_the_file_cuts_is_left_out) {
    const std::string second =
        "       2   1   1   1   0   1      1     2     3     4     5     6     7     8\n";
    const std::string rest = "                                  0     0\n";
    const std::string first = element("    1     2     3     5     4     6     7     8") + rest;
    const auto whole_line = open_texts({kBrickNodes, kElementHead + first + second}, "1=SOLID92");
    EXPECT_EQ(whole_line.model->mesh().element_count(), 1u);
    EXPECT_EQ(whole_line.diagnostics->count(Code::TruncatedInput), 1u);
    const auto half_line =
        open_texts({kBrickNodes, kElementHead + first + second.substr(0, 60)}, "1=SOLID92");
    EXPECT_EQ(half_line.model->mesh().element_count(), 1u);
    EXPECT_EQ(half_line.diagnostics->count(Code::TruncatedInput), 1u);
}

TEST(ElementLists, other_lists_in_the_file_are_counted) {
    const auto opened = open_texts(
        {kBrickNodes + kElementHead + element("    1     2     3     4") +
         "\n LIST MATERIALS       1 TO       3 BY       1\n  PROPERTY= ALL \n\n MATERIAL NUMBER       1\n\n  "
         "    TEMP        RSVX\n"
         "                0.000000    \n"},
        "1=SHELL63"
    );
    EXPECT_EQ(opened.model->mesh().element_count(), 1u);
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownBlock), 1u);
    EXPECT_THAT(text_of(*opened.diagnostics, Code::UnknownBlock), HasSubstr("LIST MATERIALS"));
}

TEST(ElementLists, rows_without_a_title_are_elements) {
    const auto opened = open_texts({kBrickNodes, element("    1     2     3     4")}, "1=SHELL63");
    EXPECT_EQ(opened.model->mesh().element_count(), 1u);
}

}  // namespace
}  // namespace feelem
