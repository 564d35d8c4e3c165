// SPDX-License-Identifier: Apache-2.0
// Small decks, each for one rule of the format.
#include "open_deck.hpp"
#include "read/read_format.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace feelem {
namespace {

using namespace tests;
using testing::ElementsAre;

constexpr const char* kSquare = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n6,2,1\n";

TEST(Deck, keywords_are_read_in_any_case_with_blanks_comments_and_continued_lines) {
    const Opened opened =
        open_deck("** made by hand\r\n * Node , NSET = \"All nodes\"\r\n 1 , 0. , 0.,\r\n"
                  "** between\r\n2,1.,+0.5E0,1.5D+02\r\n\r\n3,1,1\r\n*element,\r\n** more\r\n"
                  "Type=s3, \r\nelset=Shell\r\n7,1,2,3\r\n*Node Print\r\nU\r\n");
    EXPECT_THAT(node_ids(opened.mesh()), ElementsAre(1, 2, 3));
    EXPECT_EQ(place_of(opened.mesh(), 2), (Point3{1, 0.5, 150}));
    EXPECT_EQ(place_of(opened.mesh(), 3), (Point3{1, 1, 0}));
    ASSERT_EQ(opened.mesh().blocks.size(), 1U);
    EXPECT_EQ(opened.mesh().blocks[0].type, ElementType::Tri3);
    EXPECT_THAT(set_nodes(opened.mesh(), "All nodes"), ElementsAre(1, 2, 3));
    EXPECT_THAT(set_elements(opened.mesh(), "Shell"), ElementsAre(7));
    EXPECT_TRUE(opened.diagnostics->entries().empty());
}

TEST(Deck, element_row_goes_on_until_it_has_its_nodes) {
    std::string text = "*NODE\n";
    for (int i = 1; i <= 20; ++i) text += std::to_string(i) + "," + std::to_string(i) + "\n";
    text += "*ELEMENT,TYPE=C3D20R\n1,1,2,3,4,5,6,7,8,9,10,\n11,12,13,14,15\n16,17,18,19,20\n"
            "2,20,19,18,17,16,15,14,13,12,11,10,9,8,7,6,\n5,4,3,2,1,\n";
    const Opened opened = open_deck(text);
    ASSERT_EQ(opened.mesh().blocks.size(), 1U);
    const ElementBlock& block = opened.mesh().blocks[0];
    EXPECT_EQ(block.type, ElementType::Hex20);
    EXPECT_THAT(element_ids(opened.mesh()), ElementsAre(1, 2));
    EXPECT_EQ(raw(block.nodes[12]), 12U);
    EXPECT_EQ(raw(block.nodes[20]), 19U);
    EXPECT_EQ(raw(block.nodes[39]), 0U);
}

TEST(Deck, row_that_the_end_of_its_block_cuts_off_is_reported_not_shown) {
    const Opened opened = open_deck(std::string(kSquare) + "*ELEMENT,TYPE=S4\n1,1,2,3,4\n2,2,5,6\n");
    EXPECT_THAT(element_ids(opened.mesh()), ElementsAre(1));
    EXPECT_EQ(opened.diagnostics->count(Code::TruncatedInput), 1U);
}

TEST(Deck, families_of_element_names_give_the_shape_whatever_their_suffix) {
    const std::vector<std::pair<std::string, ElementType>> names{
        {"C3D4", ElementType::Tet4},     {"C3D10MH", ElementType::Tet10}, {"C3D10HS", ElementType::Tet10},
        {"C3D5", ElementType::Pyramid5}, {"C3D6", ElementType::Wedge6},   {"C3D15V", ElementType::Wedge15},
        {"C3D8RH", ElementType::Hex8},   {"C3D20RT", ElementType::Hex20}, {"SC6R", ElementType::Wedge6},
        {"SC8RT", ElementType::Hex8},    {"CSS8", ElementType::Hex8},     {"DC3D20", ElementType::Hex20},
        {"AC3D10", ElementType::Tet10},  {"S3R", ElementType::Tri3},      {"STRI3", ElementType::Tri3},
        {"STRI65", ElementType::Tri6},   {"S4R5", ElementType::Quad4},    {"S8R5", ElementType::Quad8},
        {"S9R5", ElementType::Quad9},    {"CPS8R", ElementType::Quad8},   {"CPE6MH", ElementType::Tri6},
        {"CPEG4", ElementType::Quad4},   {"CAX4RT", ElementType::Quad4},  {"DCAX8", ElementType::Quad8},
        {"DC2D3", ElementType::Tri3},    {"DS4", ElementType::Quad4},     {"M3D9R", ElementType::Quad9},
        {"SFM3D4", ElementType::Quad4},  {"R3D4", ElementType::Quad4},    {"R2D2", ElementType::Line2},
        {"B31H", ElementType::Line2},    {"B32R", ElementType::Line3},    {"B33", ElementType::Line2},
        {"B22", ElementType::Line3},     {"PIPE32", ElementType::Line3},  {"T3D2", ElementType::Line2},
        {"T2D3", ElementType::Line3},    {"DC1D2", ElementType::Line2},   {"SAX1", ElementType::Line2},
        {"SAX2T", ElementType::Line3},   {"RB3D2", ElementType::Line2},   {"FRAME3D", ElementType::Line2},
    };
    for (const auto& [name, type] : names) {
        std::string text = "*NODE\n", row = "1";
        for (std::size_t i = 1; i <= element_row(type).node_count; ++i) {
            text += std::to_string(i) + "," + std::to_string(i * i) + "\n";
            row += "," + std::to_string(i);
        }
        const Opened opened = open_deck(text + "*ELEMENT,TYPE=" + name + "\n" + row + "\n");
        ASSERT_EQ(opened.mesh().blocks.size(), 1U) << name;
        EXPECT_EQ(opened.mesh().blocks[0].type, type) << name;
        EXPECT_TRUE(opened.diagnostics->entries().empty()) << name;
    }
}

TEST(Deck, nodes_on_the_faces_of_a_27_node_brick_find_their_face) {
    // A brick from -1 to 1; Abaqus numbers the middles of faces z- z+ y- x+ y+ x- after the middle of the
    // body.
    std::string text = "*NODE\n";
    const int corners[8][3] = {
        {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    const int rest[19][3] = {
        {0, -1, -1},
        {1, 0, -1},
        {0, 1, -1},
        {-1, 0, -1},
        {0, -1, 1},
        {1, 0, 1},
        {0, 1, 1},
        {-1, 0, 1},
        {-1, -1, 0},
        {1, -1, 0},
        {1, 1, 0},
        {-1, 1, 0},
        {0, 0, 0},
        {0, 0, -1},
        {0, 0, 1},
        {0, -1, 0},
        {1, 0, 0},
        {0, 1, 0},
        {-1, 0, 0}};
    std::string row = "1";
    for (int i = 0; i < 27; ++i) {
        const int* at = i < 8 ? corners[i] : rest[i - 8];
        text += std::to_string(i + 1) + "," + std::to_string(at[0]) + "," + std::to_string(at[1]) + "," +
                std::to_string(at[2]) + "\n";
        row += "," + std::to_string(i + 1) + (i == 14 ? ",\n" : "");
        if (i == 14) row.erase(row.size() - 2, 1), row.insert(row.size() - 1, ",");
    }
    std::string clean;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] == ',' && i > 0 && row[i - 1] == '\n') continue;
        clean += row[i];
    }
    const Opened opened = open_deck(text + "*ELEMENT,TYPE=C3D27\n" + clean + "\n");
    ASSERT_EQ(opened.mesh().blocks.size(), 1U);
    const ElementBlock& block = opened.mesh().blocks[0];
    ASSERT_EQ(block.type, ElementType::Hex27);
    const ElementRow& reference = element_row(ElementType::Hex27);
    const double low = static_cast<double>(reference.reference[0][0]);
    for (std::size_t i = 0; i < 27; ++i) {
        const Point3& place = opened.mesh().coordinates[raw(block.nodes[i])];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double expected = static_cast<double>(reference.reference[i][axis]);
            EXPECT_EQ(place[axis], low < 0 ? expected : 2 * expected - 1) << i;
        }
    }
}

TEST(Deck, elements_without_a_surface_are_counted_by_type_and_unknown_types_reported) {
    const Opened opened = open_deck(
        std::string(kSquare) +
        "*ELEMENT,TYPE=S4R\n1,1,2,3,4\n*ELEMENT,TYPE=SPRINGA\n2,1,2\n3,3,4\n"
        "*ELEMENT,TYPE=GK3D18\n4,1,2,3,4,5,6,1,2,3,4,5,6,1,2,3,\n4,5,6\n*ELEMENT,TYPE=MASS\n5,1\n"
        "*ELEMENT,TYPE=COH3D8\n6,1,2,3,4,5,6,1,2\n*ELEMENT,TYPE=XYZ99\n7,1\n8,2\n"
    );
    const std::map<std::string, std::uint64_t> expected{
        {"SPRINGA", 2}, {"GK3D18", 1}, {"MASS", 1}, {"COH3D8", 1}};
    EXPECT_EQ(opened.mesh().skipped_elements, expected);
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownElementType), 2U);
}

TEST(Deck, middle_node_of_a_line_comes_last) {
    const Opened opened = open_deck(std::string(kSquare) + "*ELEMENT,TYPE=B32\n1,1,2,5\n");
    const ElementBlock& block = opened.mesh().blocks.at(0);
    EXPECT_THAT(block.nodes, ElementsAre(NodeIndex{0}, NodeIndex{4}, NodeIndex{1}));
}

TEST(Deck, parts_that_no_instance_uses_are_the_model_as_in_calculix) {
    const Opened opened = open_deck(
        "*\n" + std::string("*PART,NAME=P\n*NODE\n1,0\n2,1\n3,0,1\n*ELEMENT,TYPE=US3,ELSET=E\n"
                            "1,1,2,3\n*ELEMENT,TYPE=SPRING1\n2,1\n*END PART\n")
    );
    EXPECT_THAT(element_ids(opened.mesh()), ElementsAre(1));
    EXPECT_THAT(set_elements(opened.mesh(), "E"), ElementsAre(1));
    EXPECT_EQ(opened.mesh().skipped_elements.at("SPRING1"), 1U);
}

TEST(Deck, direction_node_of_a_beam_is_no_node_of_its_line) {
    const Opened opened = open_deck(std::string(kSquare) + "*ELEMENT,TYPE=B31\n1,1,2,4\n2,2,5,4\n");
    EXPECT_THAT(element_ids(opened.mesh()), ElementsAre(1, 2));
    EXPECT_TRUE(opened.diagnostics->entries().empty());
}

TEST(Deck, sets_hold_ids_ranges_and_other_sets_even_in_a_circle) {
    const Opened opened = open_deck(
        std::string(kSquare) +
        "*ELEMENT,TYPE=S4,ELSET=EA\n1,1,2,3,4\n2,2,5,6,3\n*NSET,NSET=ODD,GENERATE\n1,5,2\n"
        "*NSET,NSET=both\nodd, 6,\n*NSET,NSET=RING1\nRING2,1\n*NSET,NSET=RING2\nRING1,2\n"
        "*ELSET,ELSET=EB,GENERATE\n2,999999999\n*ELSET,ELSET=EB\nEA\n"
    );
    EXPECT_THAT(set_nodes(opened.mesh(), "ODD"), ElementsAre(1, 3, 5));
    EXPECT_THAT(set_nodes(opened.mesh(), "both"), ElementsAre(1, 3, 5, 6));
    EXPECT_THAT(set_nodes(opened.mesh(), "RING1"), ElementsAre(1, 2));
    EXPECT_THAT(set_elements(opened.mesh(), "EB"), ElementsAre(1, 2));
}

TEST(Deck, parts_of_a_single_instance_are_the_sets_of_its_sections) {
    const Opened opened = open_deck(
        std::string(kSquare) + "*ELEMENT,TYPE=S4,ELSET=ALL\n1,1,2,3,4\n2,2,5,6,3\n*ELEMENT,TYPE=T3D2\n3,1,2\n"
                               "*ELSET,ELSET=Thick\n2\n*SHELL SECTION,ELSET=thick,MATERIAL=M\n0.1\n"
    );
    EXPECT_THAT(part_of_each_element(opened.mesh()), ElementsAre("ALL", "thick", "without section"));
}

TEST(Deck, nodes_are_placed_in_the_system_of_their_keyword) {
    const Opened opened = open_deck(
        "*SYSTEM\n10,0,0, 10,1,0\n-1,0,0\n*NODE\n1,1,0,0\n2,0,1,0\n*NODE,SYSTEM=C\n3,2,90,5\n*SYSTEM\n"
        "*NODE,SYSTEM=S\n4,1,90,0\n5,3,0,90\n*ELEMENT,TYPE=S3\n1,1,2,3\n"
    );
    expect_place(opened.mesh(), 1, {10, 1, 0});
    expect_place(opened.mesh(), 2, {9, 0, 0});
    expect_place(opened.mesh(), 3, {8, 0, 5});
    expect_place(opened.mesh(), 4, {0, 1, 0});
    expect_place(opened.mesh(), 5, {0, 0, 3});
}

constexpr const char* kPart =
    "*PART,NAME=P\n*NODE\n1,1,0,0\n2,2,0,0\n3,1,1,0\n*ELEMENT,TYPE=S3,ELSET=E\n1,1,2,3\n"
    "*NSET,NSET=TIP\n2\n*ELEMENT,TYPE=MASS\n9,1\n*END PART\n";

TEST(Deck, instance_is_moved_then_turned) {
    const Opened opened = open_deck(
        std::string(kPart) +
        "*ASSEMBLY,NAME=A\n*INSTANCE,NAME=P-1,PART=p\n1,0,0\n0,0,0,0,0,1,90\n*END INSTANCE\n"
        "*NSET,NSET=END,INSTANCE=P-1\n3\n*END ASSEMBLY\n"
    );
    // (2,0,0) is moved to (3,0,0) and turned about z to (0,3,0).
    expect_place(opened.mesh(), 2, {0, 3, 0});
    expect_place(opened.mesh(), 3, {-1, 2, 0});
    EXPECT_THAT(set_nodes(opened.mesh(), "END"), ElementsAre(3));
    EXPECT_THAT(set_nodes(opened.mesh(), "TIP"), ElementsAre(2));
    EXPECT_EQ(opened.mesh().skipped_elements.at("MASS"), 1U);
    EXPECT_FALSE(opened.diagnostics->has(Code::IdsOffset));
}

TEST(Deck, ids_that_instances_repeat_are_offset_by_a_round_number_that_is_stated) {
    const Opened opened = open_deck(
        std::string(kPart) +
        "*ASSEMBLY,NAME=A\n*INSTANCE,NAME=P-1,PART=P\n*END INSTANCE\n"
        "*INSTANCE,NAME=\"P 2.b\",PART=P\n0,0,10\n*END INSTANCE\n*NODE\n1,5,5,5\n"
        "*NSET,NSET=MIX\nP-1.1, \"P 2.b.2\"\n*NSET,NSET=MIX\n\"P 2.b.TIP\",1\n*END ASSEMBLY\n"
    );
    EXPECT_THAT(node_ids(opened.mesh()), ElementsAre(1, 2, 3, 1000001, 1000002, 1000003, 2000001));
    EXPECT_THAT(element_ids(opened.mesh()), ElementsAre(1, 1000001));
    EXPECT_THAT(part_of_each_element(opened.mesh()), ElementsAre("P-1", "P 2.b"));
    expect_place(opened.mesh(), 1000002, {2, 0, 10});
    EXPECT_THAT(set_nodes(opened.mesh(), "P 2.b.TIP"), ElementsAre(1000002));
    EXPECT_THAT(set_elements(opened.mesh(), "P 2.b.E"), ElementsAre(1000001));
    EXPECT_THAT(set_nodes(opened.mesh(), "MIX"), ElementsAre(1, 1000002, 2000001));
    EXPECT_EQ(opened.mesh().skipped_elements.at("MASS"), 2U);
    ASSERT_EQ(opened.diagnostics->count(Code::IdsOffset), 1U);
    EXPECT_THAT(
        opened.diagnostics->entries()[0].text, testing::HasSubstr("P 2.b +1000000, assembly +2000000")
    );
}

TEST(Deck, ids_that_no_two_instances_share_stay_as_they_are) {
    const Opened opened = open_deck(
        std::string(kPart) +
        "*PART,NAME=Q\n*NODE\n11,0\n12,1\n13,0,1\n*ELEMENT,TYPE=S3\n11,11,12,13\n*END PART\n"
        "*ASSEMBLY\n*INSTANCE,NAME=P-1,PART=P\n*END INSTANCE\n*INSTANCE,NAME=Q-1,PART=Q\n"
        "*END INSTANCE\n*END ASSEMBLY\n"
    );
    EXPECT_THAT(node_ids(opened.mesh()), ElementsAre(1, 2, 3, 11, 12, 13));
    EXPECT_FALSE(opened.diagnostics->has(Code::IdsOffset));
}

TEST(Deck, mesh_inside_an_instance_is_read) {
    const Opened opened = open_deck(
        "*PART,NAME=P\n*END PART\n*ASSEMBLY\n*INSTANCE,NAME=P-1,PART=P\n0,0,7\n*NODE\n1,0\n2,1\n3,0,1\n"
        "*ELEMENT,TYPE=S3\n1,1,2,3\n*ELSET,ELSET=_I,INTERNAL\n1\n*SHELL SECTION,ELSET=_I\n1.\n*END "
        "INSTANCE\n*END ASSEMBLY\n"
    );
    expect_place(opened.mesh(), 1, {0, 0, 7});
    EXPECT_THAT(part_of_each_element(opened.mesh()), ElementsAre("_I"));
    EXPECT_TRUE(opened.mesh().element_sets.empty()) << "internal sets are the pre-processor's own";
}

TEST(Deck, includes_are_read_in_place_and_may_hold_data_lines_only) {
    const Opened opened = open_decks(
        {{"job.inp",
          "*HEADING\nA plate\n*NODE\n*INCLUDE, INPUT=sub/nodes.txt\n4,0,1\n*INCLUDE,INPUT=mesh.inc\n"
          "*INCLUDE,INPUT=loads.inc\n*STEP\n"},
         {"nodes.txt", "1,0,0\n2,1,0\n3,1,1\n"},
         {"mesh.inc", "*ELEMENT,TYPE=S4\n*INCLUDE,INPUT=mesh.inc\n1,1,2,3,4\n"}}
    );
    EXPECT_THAT(node_ids(opened.mesh()), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(element_ids(opened.mesh()), ElementsAre(1));
    EXPECT_EQ(opened.model->title(), "A plate");
    const auto entries = opened.diagnostics->entries();
    const auto says = [&](const char* text) {
        return std::ranges::any_of(entries, [&](const Diagnostic& entry) {
            return entry.code == Code::UnknownBlock && entry.text.find(text) != std::string::npos;
        });
    };
    EXPECT_TRUE(says("\"loads.inc\" is left out: there is no such file"));
    EXPECT_TRUE(says("\"mesh.inc\" is left out"));
}

TEST(Deck, nodes_in_one_file_and_elements_in_another_are_one_deck) {
    const Opened opened =
        open_decks({{"elements.inp", "*ELEMENT,TYPE=S4\n1,1,2,3,4\n"}, {"nodes.inp", kSquare}});
    EXPECT_THAT(element_ids(opened.mesh()), ElementsAre(1));
}

TEST(Deck, transform_gives_nodes_their_directions) {
    const Opened opened = open_deck(
        "*NODE\n1,0,2,0\n2,1,0,0\n3,0,0,0\n4,5,0,0\n*NSET,NSET=C\n1,2\n*NSET,NSET=R\n4\n"
        "*TRANSFORM,NSET=C,TYPE=C\n0,0,0,0,0,1\n*TRANSFORM,NSET=R\n0,0,1,1,0,0\n*ELEMENT,TYPE=S3\n1,1,2,3\n"
    );
    const auto& angles = opened.mesh().node_angles;
    ASSERT_EQ(angles.size(), 4U);
    EXPECT_NEAR(angles[0][0], 90, 1e-12);  // radial is y, tangential -x
    EXPECT_EQ(angles[1], NodalAngles{});
    EXPECT_EQ(angles[2], NodalAngles{});
    // x' = z, y' = x, z' = y
    EXPECT_NEAR(angles[3][0], -90, 1e-9);
    EXPECT_NEAR(angles[3][1], 0, 1e-9);
    EXPECT_NEAR(angles[3][2], -90, 1e-9);
}

TEST(Deck, ids_defined_twice_keep_the_later_definition) {
    const Opened opened = open_deck(
        std::string(kSquare) + "*NODE\n6,9,9\n*ELEMENT,TYPE=S3\n1,1,2,3\n*ELEMENT,TYPE=S4\n1,2,5,6,3\n"
    );
    expect_place(opened.mesh(), 6, {9, 9, 0});
    ASSERT_EQ(opened.mesh().element_count(), 1U);
    EXPECT_EQ(opened.mesh().blocks[0].type, ElementType::Quad4);
    EXPECT_EQ(opened.diagnostics->count(Code::DuplicateNode), 1U);
    EXPECT_EQ(opened.diagnostics->count(Code::DuplicateElement), 1U);
}

TEST(Deck, shipped_example_is_read_whole) {
    const Opened opened = open_deck(test::read_file(test::project_file("tests/data/abaqus/two_plates.inp")));
    EXPECT_THAT(
        node_ids(opened.mesh()),
        ElementsAre(
            1,
            2,
            3,
            4,
            5,
            6,
            7,
            8,
            1000001,
            1000002,
            1000003,
            1000004,
            2000001,
            2000002,
            2000003,
            2000004,
            3000001
        )
    );
    EXPECT_THAT(part_of_each_element(opened.mesh()), ElementsAre("Brick-1", "Plate-1", "Plate 2"));
    // Lifted by 1, then turned about the line y = 0, z = 1: up instead of back.
    expect_place(opened.mesh(), 2000003, {1, 0, 2});
    EXPECT_THAT(set_nodes(opened.mesh(), "Corners"), ElementsAre(1, 1000001, 1000002, 2000001));
    EXPECT_THAT(set_nodes(opened.mesh(), "Brick-1.Foot"), ElementsAre(1, 2, 3, 4));
    EXPECT_EQ(opened.mesh().node_angles.size(), 17U);
    EXPECT_EQ(opened.model->title(), "Two plates on a brick");
    EXPECT_FALSE(opened.diagnostics->has(Code::UnknownBlock));
}

TEST(Deck, something_else_than_a_number_is_an_error_with_its_line) {
    try {
        open_deck("*PARAMETER\na=1\n*NODE\n1,0,0\n2,<a>,0\n*ELEMENT,TYPE=T3D2\n1,1,2\n");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::BadNumber);
        EXPECT_EQ(error.where(), "job.inp:5");
        EXPECT_THAT(error.what(), testing::HasSubstr("*PARAMETER"));
    }
}

TEST(Deck, instances_cannot_multiply_a_part_without_end) {
    std::string text = "*PART,NAME=P\n*NODE\n";
    for (int i = 1; i <= 20000; ++i) text += std::to_string(i) + "\n";
    text += "*END PART\n*ASSEMBLY\n";
    for (int i = 0; i < 2000; ++i) text += "*INSTANCE,NAME=I,PART=P\n*END INSTANCE\n";
    try {
        open_deck(text);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::TooLarge);
    }
}

TEST(Deck, content_of_other_programs_is_not_taken_for_a_deck) {
    for (const char* text :
         {"*KEYWORD\n*NODE\n       1             0.0             0.0\n",
          "/PREP7\n*SET,A,1\nN,1,0,0\n",
          "*DIM,a,array,3\n*VREAD\n",
          "$ NASTRAN\nGRID,1,,0.,0.,0.\n",
          "**only a comment\n",
          "*\n*\n"}) {
        const Input input = Input::from_memory("other", text);
        for (const ReadFormat& format : read_format_list()) {
            if (format.info.id == "abaqus-inp") {
                EXPECT_EQ(format.recognise(input), Likelihood::No) << text;
            }
        }
    }
}

}  // namespace
}  // namespace feelem
