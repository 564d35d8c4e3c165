// SPDX-License-Identifier: Apache-2.0
// Bulk data in all the forms that people and programs write it in.
#include "base/input.hpp"
#include "derive/tensor.hpp"
#include "read/read_format.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"
#include "feelem/skin.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace feelem {
namespace {

struct Opened {
    Diagnostics diagnostics;
    std::unique_ptr<ModelSource> model;
    const Mesh& mesh() const { return model->mesh(); }
};

Opened open_decks(std::vector<NamedBytes> files) {
    Opened opened;
    opened.model = open_model(std::move(files), {}, opened.diagnostics);
    return opened;
}
Opened open_deck(const std::string& text) {
    return open_decks({{"deck.bdf", text}});
}

Point3 place_of(const Mesh& mesh, int node) {
    const NodeIndex index = find_node(mesh, NodeId{node});
    EXPECT_NE(index, kNoNode) << node;
    return index == kNoNode ? Point3{} : mesh.coordinates[raw(index)];
}

std::string refusal(const std::string& text) {
    try {
        open_deck(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "read without a word";
}

/// A unit brick of grids 1..8.
const char* const kBrick = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\n"
                           "GRID,5,,0.,0.,1.\nGRID,6,,1.,0.,1.\nGRID,7,,1.,1.,1.\nGRID,8,,0.,1.,1.\n"
                           "CHEXA,1,1,1,2,3,4,5,6\n,7,8\n";

void expect_brick(const Mesh& mesh) {
    ASSERT_EQ(mesh.node_count(), 8U);
    ASSERT_EQ(mesh.element_count(), 1U);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Hex8);
    EXPECT_EQ(place_of(mesh, 7), (Point3{1, 1, 1}));
    EXPECT_EQ(place_of(mesh, 4), (Point3{0, 1, 0}));
    Diagnostics diagnostics;
    EXPECT_DOUBLE_EQ(make_skin(mesh, {}, diagnostics).report.volume, 1);
    EXPECT_FALSE(diagnostics.has(Code::InvertedElement));
}

TEST(NastranBulk, a_deck_without_control_sections_is_read) {
    const Opened opened = open_deck(kBrick);
    expect_brick(opened.mesh());
    EXPECT_EQ(opened.model->inputs()[0].format, "nastran-bulk");
    EXPECT_TRUE(opened.model->results().empty());
}

TEST(NastranBulk, control_sections_and_what_follows_enddata_do_not_count) {
    const Opened opened = open_deck(
        std::string("SOL 101\nCEND\nTITLE = A brick $ of ours\nSET 5 = 1,2,3\n  GRID = 7\nBEGIN BULK\n") +
        kBrick + "ENDDATA\nGRID,99,,0.,0.,0.\n"
    );
    expect_brick(opened.mesh());
    EXPECT_EQ(opened.model->title(), "A brick");
}

TEST(NastranBulk, small_large_free_and_tabbed_lines_mean_the_same) {
    const Opened opened =
        open_deck("$ a comment\r\n"
                  "GRID           1              0.      0.      0.\r\n"
                  "GRID*                  2                              1.              0.\r\n"
                  "*                     0.\r\n"
                  "grid,3,,1.,1.$ the rest is blank: 0\r\n"
                  "GRID*,4,,0.,1.\r\n*,0.\r\n"
                  "GRID\t5\t\t0.\t0.\t1.\r\n"
                  "GRID    6       0       1.      0.      1.00+0\r\n"
                  "GRID           7              1.      1.10.0E-01\r\n"
                  "\r\n"
                  "GRID*                  8                              0.           1.D+0*A\r\n"
                  "$ between the lines of a card\r\n"
                  "*A                  .1+1\r\n"
                  "CHEXA   1       1       1       2       3       4       5       6       +B\r\n"
                  "+B      7       8\r\n");
    expect_brick(opened.mesh());
}

TEST(NastranBulk, continuations_are_known_by_a_blank_a_plus_a_star_or_a_comma) {
    const std::string grids(kBrick, std::string(kBrick).find("CHEXA"));
    for (const char* card :
         {"CHEXA   1       1       1       2       3       4       5       6\n        7       8\n",
          "CHEXA   1       1       1       2       3       4       5       6\n+       7       8\n",
          "CHEXA   1       1       1       2       3       4       5       6       CH1\n+H1     7       8\n",
          "CHEXA,1,1,1,2,3,4,5,6,+C1\n+C1,7,8\n",
          "CHEXA,1,1,1,2,3,4,5,6\n,7,8\n",
          "CHEXA,1,1,1,2,3,4,5,6\n+,7,8\n",
          "CHEXA,1,1,1,2,3,4,5,6,7,8\n",
          "CHEXA\t1\t1\t1\t2\t3\t4\t5\t6\n\t7\t8\n",
          "CHEXA,1,1,1,2,3,4,5,6\n        7       8\n",
          "CHEXA*                 1               1               1               2\n"
          "*                      3               4               5               6\n"
          "*                      7               8\n",
          "CHEXA*,1,1,1,2\n*,3,4,5,6\n*,7,8\n"}) {
        SCOPED_TRACE(card);
        expect_brick(open_deck(grids + card).mesh());
    }
}

TEST(NastranBulk, reals_may_lack_the_letter_of_their_exponent) {
    const Opened opened = open_deck(
        "GRID,1,,1.5+3,-2.-2,+.5\nGRID,2,,1.5D-3,7,-1.25E+2\nGRID,3,,1.-5,2.9+7,-1.714-9\nCTRIA3,1,1,1,2,3\n"
    );
    EXPECT_EQ(place_of(opened.mesh(), 1), (Point3{1500, -0.02, 0.5}));
    EXPECT_EQ(place_of(opened.mesh(), 2), (Point3{1.5e-3, 7, -125}));
    EXPECT_EQ(place_of(opened.mesh(), 3), (Point3{1e-5, 2.9e7, -1.714e-9}));
}

TEST(NastranBulk, grdset_fills_blank_fields_wherever_it_stands) {
    const Opened opened =
        open_deck("GRID,1,,2.,90.,0.\nGRID,2,0,2.,90.,0.,0\nGRID,3,,0.,0.,0.\nCTRIA3,1,1,1,2,3\n"
                  "CORD2C,4,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nGRDSET,,4,,,,4\n");
    EXPECT_NEAR(place_of(opened.mesh(), 1)[1], 2, 1e-15);
    EXPECT_EQ(place_of(opened.mesh(), 2), (Point3{2, 90, 0}));
    EXPECT_NEAR(opened.mesh().node_angles[0][0], 90, 1e-12);
    EXPECT_EQ(opened.mesh().node_angles[1], NodalAngles{});
}

TEST(NastranBulk, values_along_cd_systems_turn_with_the_place_of_the_grid) {
    const Opened opened =
        open_deck("CORD2C,7,0,1.,0.,0.,1.,0.,1.\n,2.,0.,0.\n"
                  "GRID,1,,1.,3.,0.,7\nGRID,2,,2.,0.,5.,7\nGRID,3,,0.,0.,0.\nCTRIA3,1,1,1,2,3\n");
    // Outward at grid 1 is along y.
    const auto out = to_global(nodal_axes(opened.mesh().node_angles[0]), Point3{1, 0, 0});
    EXPECT_NEAR(out[0], 0, 1e-15);
    EXPECT_NEAR(out[1], 1, 1e-15);
    EXPECT_EQ(opened.mesh().node_angles[1], NodalAngles{});
}

TEST(NastranBulk, a_missing_coordinate_system_leaves_places_missing_and_says_so) {
    const Opened opened =
        open_deck("GRID,1,5,1.,2.,3.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,0.,0.,6\nCTRIA3,1,1,1,2,3\n");
    EXPECT_TRUE(std::isnan(place_of(opened.mesh(), 1)[0]));
    EXPECT_EQ(opened.diagnostics.count(Code::CoordinateSystem), 2U);
}

TEST(NastranBulk, systems_in_a_loop_are_reported_where_they_stand) {
    const Opened opened =
        open_deck("GRID,1,,1.,2.,3.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,0.,0.\nCTRIA3,1,1,1,2,3\n"
                  "CORD2R,5,6,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nCORD2R,6,5,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n");
    ASSERT_EQ(opened.diagnostics.count(Code::CoordinateSystem), 2U);
    EXPECT_EQ(opened.diagnostics.entries()[0].where, "deck.bdf:7");
    EXPECT_EQ(opened.diagnostics.entries()[1].where, "deck.bdf:5");
}

TEST(NastranBulk, scalar_points_are_nodes_without_a_place) {
    const Opened opened = open_deck(std::string(kBrick) + "SPOINT,100,THRU,102\nSPOINT,7001,7003\n");
    EXPECT_EQ(opened.mesh().node_count(), 13U);
    EXPECT_TRUE(std::isnan(place_of(opened.mesh(), 101)[0]));
    EXPECT_NE(refusal(std::string(kBrick) + "SPOINT,1,THRU,2000000000\n").find("million"), std::string::npos);
}

TEST(NastranBulk, parts_are_properties_by_the_names_people_gave_them) {
    const Opened opened =
        open_deck("GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\n"
                  "CTRIA3,1,1,1,2,3\nCTRIA3,2,2,1,2,3\nCTRIA3,3,3,1,2,3\nCTRIA3,4,4,1,2,3\nCTRIA3,5,5,1,2,3\n"
                  "CTRIA3,6,6,1,2,3\nCONROD,7,1,2,9\nCTRIA3,8,8,1,2,3\n"
                  "$HMNAME COMP                   1\"Plate\"        1 \"skin\" 4\nPSHELL,1,1,.1\n"
                  "$ Pset: \"rib\" will be imported as: \"pshell.2\"\nPSHELL,2,1,.1\n"
                  "$ Femap with NX Nastran Property 3 : spar\nPSHELL,3,1,.1\n"
                  "$*  Property: Solid "
                  "Laminate1\nPCOMP,4\nPSHELL,5,1\n$ANSA_NAME_COMMENT;6;PSHELL;Door;;;\nPSHELL,6,1\n");
    std::vector<std::string> names;
    for (const Part& part : opened.mesh().parts) names.push_back(part.name);
    EXPECT_EQ(
        names,
        (std::vector<std::string>{
            "Plate (PSHELL 1)",
            "rib (PSHELL 2)",
            "spar (PSHELL 3)",
            "Solid Laminate1 (PCOMP 4)",
            "PSHELL 5",
            "Door (PSHELL 6)",
            "CONROD",
            "property 8"})
    );
}

TEST(NastranBulk, elements_without_surface_are_counted_by_card) {
    const Opened opened = open_deck(
        std::string(kBrick) + "CELAS1,10,1,1,1,2,1\nRBE2,11,1,123,2,3\nCONM2,12,1,,5.\nCHBDYE,1,1,1\nCHBDYE,"
                              "2,1,2\nPLOTEL,1,1,2,,20,2,3\n"
    );
    EXPECT_EQ(
        opened.mesh().skipped_elements,
        (std::map<std::string, std::uint64_t>{
            {"CELAS1", 1}, {"CHBDYE", 2}, {"CONM2", 1}, {"PLOTEL", 1}, {"RBE2", 1}})
    );
    // The second half of the PLOTEL has a number of its own.
    ASSERT_EQ(opened.mesh().element_count(), 2U);
    EXPECT_EQ(raw(opened.mesh().blocks[1].ids[0]), 20);
}

TEST(NastranBulk, unknown_element_cards_and_repeated_numbers_are_reported) {
    const Opened opened = open_deck(std::string(kBrick) + "CWHAT,5,1,1,2\nCSET1,5,1,1\nCQUAD4,1,1,1,2,3,4\n");
    EXPECT_EQ(opened.diagnostics.count(Code::UnknownElementType), 1U);
    EXPECT_EQ(opened.diagnostics.count(Code::DuplicateElement), 1U);
    EXPECT_EQ(opened.mesh().element_count(), 1U);
}

TEST(NastranBulk, what_cannot_be_read_is_refused_with_its_place_and_field) {
    EXPECT_EQ(
        refusal("GRID,1,,0.,0.,0.\nGRID,2,,1.,x,0.\n"),
        "deck.bdf:2: GRID: \"x\" stands in field 5 where a number must be"
    );
    EXPECT_EQ(
        refusal("GRID,1,,0.,0.,0.\nGRID,,,1.,0.,0.\n"),
        "deck.bdf:2: GRID: \"\" stands in field 2 where a positive number must be"
    );
    EXPECT_EQ(refusal("GRID,1,,0.,0.,0.\nCROD,3,1,1\n"), "deck.bdf:2: CROD 3 has a blank corner");
    EXPECT_EQ(refusal("GRID,1,,0.,0.,0.\nCROD,3,1,1,-1\n"), "deck.bdf:2: CROD 3: \"-1\" is no grid number");
    EXPECT_NE(refusal("GRID,1,,0.,0.,0.\n=,*(1),=,*(1.)\n").find("ECHO=PUNCH"), std::string::npos);
    EXPECT_NE(refusal("CQUAD4,1,1,1,2,3,4\n").find("no GRID"), std::string::npos);
}

TEST(NastranBulk, marks_that_do_not_match_are_reported) {
    const std::string grids(kBrick, std::string(kBrick).find("CHEXA"));
    EXPECT_FALSE(open_deck(grids + "CHEXA,1,1,1,2,3,4,5,6,+C1\n+C1,7,8\n").diagnostics.has(Code::BadStructure)
    );
    const Opened opened = open_deck(
        grids +
        "CHEXA   1       1       1       2       3       4       5       6       +C1\n+C2     7       8\n"
    );
    EXPECT_EQ(opened.diagnostics.count(Code::BadStructure), 1U);
}

TEST(NastranBulk, sets_of_grids_and_elements_keep_their_names) {
    const Opened opened = open_deck(
        std::string(kBrick) +
        "$HMSET        4        1 \"corner nodes\" 18\nSET,4,GRID,LIST,\n+,1,3,THRU,5,\n+,99\n"
        "SET3,7,ELEM,1,THRU,50\nSET3,8,PROP,1\n"
    );
    ASSERT_EQ(opened.mesh().node_sets.size(), 1U);
    EXPECT_EQ(opened.mesh().node_sets[0].name, "corner nodes");
    EXPECT_EQ(
        opened.mesh().node_sets[0].nodes,
        (std::vector<NodeIndex>{NodeIndex{0}, NodeIndex{2}, NodeIndex{3}, NodeIndex{4}})
    );
    ASSERT_EQ(opened.mesh().element_sets.size(), 1U);
    EXPECT_EQ(opened.mesh().element_sets[0].name, "set 7");
    EXPECT_EQ(opened.mesh().element_sets[0].elements, std::vector<ElementIndex>{ElementIndex{0}});
}

TEST(NastranBulk, superelement_sections_are_left_out_with_a_word) {
    const Opened opened = open_deck(
        std::string("SOL 101\nCEND\nBEGIN BULK\n") + kBrick + "BEGIN SUPER=1\nGRID,90,,0.,0.,0.\nENDDATA\n"
    );
    expect_brick(opened.mesh());
    EXPECT_TRUE(opened.diagnostics.has(Code::UnknownBlock));
}

TEST(NastranBulk, an_included_piece_is_found_among_the_inputs_whatever_its_folder) {
    const std::string text(kBrick);
    const std::size_t split = text.find("GRID,5");
    for (const char* line :
         {"INCLUDE 'grids.inc'\n",
          "include \"grids.inc\"\n",
          "INCLUDE grids.inc\n",
          "INCLUDE 'C:\\models\\grids.inc'\n",
          "INCLUDE '/a/very/\n    long/way/\n  grids.inc' $ there\n"}) {
        SCOPED_TRACE(line);
        const Opened opened = open_decks(
            {{"grids.inc", text.substr(0, split)},
             {"deck.bdf", "SOL 101\nCEND\nBEGIN BULK\n" + (line + text.substr(split)) + "ENDDATA\n"}}
        );
        expect_brick(opened.mesh());
        EXPECT_TRUE(opened.diagnostics.entries().empty());
        EXPECT_EQ(opened.model->inputs().size(), 2U);
    }
}

TEST(NastranBulk, pieces_given_together_are_one_model) {
    const std::string text(kBrick);
    const std::size_t split = text.find("GRID,5");
    expect_brick(open_decks({{"b.bdf", text.substr(split)}, {"a.bdf", text.substr(0, split)}}).mesh());
}

TEST(NastranBulk, a_missing_include_is_named) {
    const Opened opened = open_deck(std::string(kBrick) + "INCLUDE 'loads.inc'\n");
    expect_brick(opened.mesh());
    ASSERT_EQ(opened.diagnostics.count(Code::FileNotFound), 1U);
    EXPECT_NE(opened.diagnostics.entries()[0].text.find("loads.inc"), std::string::npos);
    EXPECT_EQ(opened.diagnostics.entries()[0].where, "deck.bdf:11");
}

TEST(NastranBulk, prose_is_no_piece_of_a_deck) {
    const Opened opened =
        open_decks({{"deck.bdf", kBrick}, {"readme.txt", "Include the loads.\nCases 1 and 2 are alike.\n"}});
    expect_brick(opened.mesh());
    EXPECT_EQ(opened.model->inputs().size(), 1U);
    EXPECT_FALSE(opened.diagnostics.has(Code::UnknownElementType));
}

TEST(NastranBulk, includes_that_name_each_other_end) {
    const Opened opened = open_decks(
        {{"deck.bdf", std::string("BEGIN BULK\nINCLUDE 'a.inc'\n") + kBrick},
         {"a.inc", "INCLUDE 'b.inc'\nMAT1,1,2.+5\n"},
         {"b.inc", "INCLUDE 'a.inc'\nMAT1,2,2.+5\n"}}
    );
    expect_brick(opened.mesh());
    EXPECT_TRUE(opened.diagnostics.has(Code::UnknownBlock));
}

TEST(NastranBulk, decks_of_two_models_are_not_mixed) {
    const std::string deck = std::string("BEGIN BULK\n") + kBrick + "ENDDATA\n";
    EXPECT_NO_THROW(open_decks({{"static.bdf", deck}, {"modes.bdf", "SOL 103\nCEND\n" + deck}}));
    EXPECT_THROW(open_decks({{"static.bdf", deck}, {"other.bdf", deck.substr(0, 60) + "ENDDATA\n"}}), Error);
}

/// Each file goes to the reader of its own solver, whatever its suffix (.dat is anybody's).
TEST(NastranBulk, files_of_other_solvers_are_left_to_their_readers) {
    const auto file = test::corpus_file("nastran/ORIGINS.md");
    if (!file) GTEST_SKIP() << "the corpus is not here";
    namespace fs = std::filesystem;
    const fs::path corpus = fs::path(*file).parent_path().parent_path();
    std::size_t others = 0, own = 0;
    for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
        if (!entry.is_regular_file()) continue;
        const std::string path = entry.path().string(), ending = entry.path().extension().string();
        const Input input = Input::from_file(path);
        const bool is_nastran = path.find("/nastran/models/") != std::string::npos || ending == ".bdf";
        const std::string expected = !is_nastran                            ? ""
                                     : ending == ".f06"                     ? "nastran-f06"
                                     : ending == ".op2" || ending == ".txt" ? ""
                                                                            : "nastran-bulk";
        (is_nastran ? own : others) += 1;
        for (const ReadFormat& format : read_format_list()) {
            const std::string id(format.info.id);
            if (id != "nastran-bulk" && id != "nastran-f06" && id != "nastran-punch") continue;
            EXPECT_EQ(format.recognise(input) == Likelihood::Sure, id == expected) << path << " by " << id;
        }
    }
    EXPECT_GT(others, 300U);
    EXPECT_GT(own, 130U);
}

TEST(NastranBulk, the_boiler_has_its_true_skin) {
    const auto file = test::corpus_file("converted/boiler_linear.bdf");
    if (!file) GTEST_SKIP() << "the corpus is not here";
    Diagnostics diagnostics;
    const auto model = open_model(std::vector<std::string>{*file}, {}, diagnostics);
    const auto same = open_model(
        std::vector<std::string>{test::corpus_file("boiler/hex_linear/static.frd").value()}, {}, diagnostics
    );
    const SkinReport skin = make_skin(model->mesh(), {}, diagnostics).report;
    const SkinReport expected = make_skin(same->mesh(), {}, diagnostics).report;
    EXPECT_EQ(skin.solid_facets_kept, 2568U);
    EXPECT_TRUE(skin.closed);
    EXPECT_NEAR(skin.area, expected.area, 1e-5 * expected.area);
    EXPECT_NEAR(skin.volume, expected.volume, 1e-5 * expected.volume);
}

}  // namespace
}  // namespace feelem
