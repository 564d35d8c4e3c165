// SPDX-License-Identifier: Apache-2.0
// What stands round the blocks: types, parameters, single commands, comments, includes; and whose file it is.
#include "read/ansys/ansys_cdb.hpp"
#include "read/ansys/ansys_units.hpp"
#include "read/ansys/cdb_commands.hpp"
#include "read/ansys/cdb_remarks.hpp"
#include "read_ansys_cdb/opened_deck.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/skin.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace feelem {
namespace {

using test::element_counts;
using test::nodes_of;
using test::open_deck;
using test::position_of;
using testing::ElementsAre;
using testing::HasSubstr;
using Counts = std::map<std::string, std::size_t>;

/// Eight corners of a unit cube by command.
const std::string kCube = "/prep7\nn,1\nN,2,1\nn,3,1,1\nN,4,0,1\nn,5,0,0,1\nn,6,1,0,1\nn,7,1,1,1\nn,8,,1,1\n";

std::string text_of(const Diagnostics& diagnostics, Code code) {
    for (const Diagnostic& entry : diagnostics.entries()) {
        if (entry.code == code) return entry.text;
    }
    return {};
}

TEST(CdbCommand, four_letters_tell_a_command) {
    const auto is = [](const char* text, const char* name) { return ansys::cdb::Command(text).is(name); };
    EXPECT_TRUE(is("keyo,1,2,1", "KEYOPT"));
    EXPECT_TRUE(is("KEYOP,        2, 4,        1", "KEYOPT"));
    EXPECT_TRUE(is("  nblock,3", "NBLOCK"));
    EXPECT_TRUE(is("MAT ,        5", "MAT"));
    EXPECT_TRUE(is("/UNITS,MPA", "/UNITS"));
    EXPECT_FALSE(is("MATX,1", "MAT"));
    EXPECT_FALSE(is("ENORM,1", "EN"));
    EXPECT_FALSE(is("NROTAT,ALL", "N"));
    EXPECT_FALSE(is("KEY,1", "KEYOPT"));
    EXPECT_FALSE(is("", "N"));
    EXPECT_EQ(ansys::cdb::Command("MAT ,        5")[1], "5");
    EXPECT_EQ(ansys::cdb::Command("CMBLOCK,NAME    ,NODE,  42")[1], "NAME");
    EXPECT_EQ(ansys::cdb::Command("N,1")[7], "");
}

TEST(CdbCommand, parameters_hold_numbers_only) {
    ansys::cdb::Parameters parameters;
    EXPECT_TRUE(parameters.take_assignment(" cid = 3 "));
    EXPECT_TRUE(parameters.take_assignment("_npilot95=CID"));
    EXPECT_TRUE(parameters.take_assignment("word='TEMP'"));
    EXPECT_FALSE(parameters.take_assignment("MP,EX,1,A=2"));
    EXPECT_FALSE(parameters.take_assignment("_load(1,0,1) = 0.1"));
    EXPECT_EQ(parameters.integer("CID"), 3);
    EXPECT_EQ(parameters.real("_NPILOT95"), 3.0);
    EXPECT_EQ(parameters.integer(" 11.00000000000    "), 11);
    EXPECT_EQ(parameters.integer(""), 0);
    EXPECT_FALSE(parameters.integer("WORD"));
    EXPECT_FALSE(parameters.integer("1e300"));
    EXPECT_FALSE(parameters.real("cid+1"));
    parameters.set("CID", "unknown");
    EXPECT_FALSE(parameters.integer("cid"));
}

TEST(CdbCommand, remarks_name_release_units_and_bodies) {
    using namespace ansys::cdb;
    EXPECT_EQ(
        release_in(",ANSYS RELEASE 2019 R2           BUILD 19.4      UP20190416       13:35:55"), "2019 R2"
    );
    EXPECT_EQ(release_in(",ANSYS RELEASE                   BUILD 19.5      UP20190805"), "19.5");
    EXPECT_EQ(release_in(",ANSYS RELEASE Release 19.1      BUILD 19.1      UP20180418"), "19.1");
    EXPECT_EQ(release_in(",ANSYS RELEASE 11.0    UP20070125       16:39:41    03/10/2009"), "11.0");
    EXPECT_EQ(release_in(" ANSYS input file written by Workbench version 2021 R2"), "2021 R2");
    EXPECT_FALSE(release_in("anything"));
    EXPECT_EQ(unit_system_in("--- Data in consistent NMM units. See Solving Units"), "NMM");
    EXPECT_EQ(
        body_in("*** Elements for Body 1 \"ACP-Pre\\Surface(ACP \"x\")\" ***"), "ACP-Pre\\Surface(ACP \"x\")"
    );
    EXPECT_EQ(body_in("*** Elements for Body 1 ***"), "");
}

TEST(CdbCommand, systems_of_units_name_their_length) {
    EXPECT_EQ(ansys::length_unit_of_system("mks")->name, "m");
    EXPECT_EQ(ansys::length_unit_of_system("NMM")->metres, 0.001);
    EXPECT_EQ(ansys::length_unit_of_system("BIN")->name, "in");
    EXPECT_EQ(ansys::length_unit_of_system("uMKS")->name, "um");
    EXPECT_FALSE(ansys::length_unit_of_system("USER"));
    EXPECT_EQ(open_deck(kCube + "/UNITS,CGS\n").mesh().length_unit->name, "cm");
    EXPECT_FALSE(open_deck(kCube).mesh().length_unit);
}

TEST(CdbTypes, names_numbers_and_parameters_define_types) {
    for (const char* types :
         {"ET,1,185\n",
          "et,1,SOLID185\n",
          "*SET,tid,1\nET,TID,185\n",
          "tid = 1 ! a comment\net,tid,solid185\n",
          "ETBLOCK,1,1\n(2i9,19a9)\n        1      185        0\n       -1\n",
          "ET,,42\nET,1,185\n"}) {
        const auto opened = open_deck(kCube + types + "TYPE,1\nEN,9,1,2,3,4,5,6,7,8\n");
        EXPECT_EQ(element_counts(opened.mesh()), (Counts{{"hex8", 1}})) << types;
    }
}

TEST(CdbTypes, key_option_one_shapes_mesh200) {
    const std::string element = "E,1,2,3,4,5,6,7,8\n";
    EXPECT_EQ(element_counts(open_deck(kCube + "ET,1,200,10\n" + element).mesh()), (Counts{{"hex8", 1}}));
    EXPECT_EQ(
        element_counts(open_deck(kCube + "ET,1,200\nKEYOPT,1,1,6\nE,1,2,3,4\n").mesh()),
        (Counts{{"quad4", 1}})
    );
    EXPECT_EQ(
        element_counts(open_deck(kCube + "ET,1,200\nKEYOP,1, 2, 11\n" + element).mesh()),
        (Counts{{"line2", 1}})
    );
    const auto block =
        open_deck(kCube + "ETBLOCK,1,1\n(2i9,19a9)\n        1      200       10\n       -1\n" + element);
    EXPECT_EQ(element_counts(block.mesh()), (Counts{{"hex8", 1}}));
}

TEST(CdbTypes, a_type_that_nothing_names_is_left_out_and_named) {
    const auto opened = open_deck(kCube + "TYPE,7\nE,1,2,3,4,5,6,7,8\n");
    EXPECT_EQ(opened.mesh().element_count(), 0u);
    EXPECT_THAT(text_of(*opened.diagnostics, Code::UnknownElementType), HasSubstr("--types 7=NAME"));
    EXPECT_EQ(
        element_counts(open_deck(kCube + "TYPE,7\nE,1,2,3,4,5,6,7,8\n", "7=SOLID185").mesh()),
        (Counts{{"hex8", 1}})
    );
    const auto unknown = open_deck(kCube + "ET,7,999\nTYPE,7\nE,1,2,3,4,5,6,7,8\n");
    EXPECT_EQ(unknown.mesh().skipped_elements.at("999"), 1u);
}

TEST(CdbSingles, elements_by_command_have_the_current_attributes) {
    const auto opened = open_deck(
        kCube + "ET,1,185\nET,2,181\nMAT,3\nE,1,2,3,4,5,6,7,8\ntype,2 $ mat,5\nEN,40,1,2,3,4\nE,5,6,7,8\n"
    );
    EXPECT_THAT(nodes_of(opened.mesh(), 1), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
    EXPECT_THAT(nodes_of(opened.mesh(), 40), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(nodes_of(opened.mesh(), 41), ElementsAre(5, 6, 7, 8));
    EXPECT_EQ(test::part_of(opened.mesh(), 1), "material 3");
    EXPECT_EQ(test::part_of(opened.mesh(), 41), "material 5");
}

TEST(CdbSingles, emore_goes_on_with_the_last_element) {
    std::string deck = "/PREP7\nET,1,186\n";
    for (int i = 1; i <= 20; ++i) deck += "N,," + std::to_string(i) + ".5\n";
    const auto opened =
        open_deck(deck + "E,1,2,3,4,5,6,7,8\nEMORE,9,10,11,12,13,14,15,16\nEMORE,17,18,19,20\n");
    EXPECT_EQ(nodes_of(opened.mesh(), 1).size(), 20u);
    EXPECT_EQ(nodes_of(opened.mesh(), 1).back(), 20);
    EXPECT_EQ(position_of(opened.mesh(), 20)[0], 20.5);
}

// Synthetic: no real archive that was written unblocked has been found.
TEST(CdbSingles, unblocked_archives_are_read) {
    const auto opened =
        open_deck("/PREP7\nET,1,181\n"
                  "N,R5.3,LOC,       1,       0,       0,  0.00000000    ,  0.00000000    ,  0.00000000    \n"
                  "N,R5.3,LOC,       2,       0,       0,  1.00000000    ,  0.00000000    ,  0.00000000    \n"
                  "N,R5.3,ANG,       2,  90.0000000    ,  0.00000000    ,  0.00000000    \n"
                  "N,R5.3,LOC,       3,  1.00000000    ,  1.00000000    ,  0.00000000    \n"
                  "N,R5.3,LOC,       4,       0,       0,  0.00000000    ,  1.00000000    \n"
                  "N,R5.3,LOC,       -1,\n"
                  "EN,R5.5,ATTR,      4,      6,      1,      1,      1,      0,     77,      0, 0, 0\n"
                  "EN,R5.5,NODE,      1,      2,      3,      4,\n"
                  "EN,R5.5,ATTR,       -1,\n");
    EXPECT_THAT(nodes_of(opened.mesh(), 77), ElementsAre(1, 2, 3, 4));
    EXPECT_EQ(test::part_of(opened.mesh(), 77), "material 6");
    EXPECT_THAT(position_of(opened.mesh(), 3), ElementsAre(1, 1, 0));
    EXPECT_THAT(position_of(opened.mesh(), 4), ElementsAre(0, 1, 0));
    EXPECT_THAT(opened.mesh().node_angles.at(1), ElementsAre(90, 0, 0));
    EXPECT_TRUE(opened.diagnostics->entries().empty()) << test::all_texts(*opened.diagnostics);
}

TEST(CdbSingles, what_cannot_be_evaluated_is_left_out_and_said) {
    const auto opened = open_deck(
        kCube + "ET,1,185\nEN,1,1,2,3,4,5,6,7,NMAX\n*do,i,1,3\nE,1,2,3,4,5,6,7,8\n*enddo\nN,100,sqrt(2)\n"
    );
    EXPECT_EQ(opened.mesh().element_count(), 0u);
    EXPECT_EQ(opened.mesh().node_count(), 8u);
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownBlock), 3u) << test::all_texts(*opened.diagnostics);
}

TEST(CdbSingles, rules_that_make_meshes_are_named) {
    const auto opened =
        open_deck(kCube + "ET,1,185\nE,1,2,3,4,5,6,7,8\nEGEN,3,8,1\nemodif,all,secn,2\nEMODIF,1,MAT,2\n");
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownBlock), 2u) << test::all_texts(*opened.diagnostics);
    EXPECT_THAT(text_of(*opened.diagnostics, Code::UnknownBlock), HasSubstr("EGEN is not followed"));
}

TEST(CdbSingles, a_node_in_a_local_system_is_reported) {
    const auto opened = open_deck(kCube + "csys,1\nN,9,1,90\n");
    EXPECT_EQ(opened.diagnostics->count(Code::CoordinateSystem), 1u);
}

TEST(CdbDeck, offsets_conditions_and_tables_change_nothing) {
    const auto opened = open_deck(
        "*IF,_CDRDOFF,EQ,1,THEN\n_CDRDOFF=\n*ELSE\nNUMOFF,NODE,8\n*ENDIF\n*if,ANSINTER_,ne,0,then\n/"
        "eof\n*endif\n"
        "*DIM,T,ARRAY,3\n*PREAD,T,3\n 1.0 2.0 3.0\n" +
        kCube + "ET,1,185\nE,1,2,3,4,5,6,7,8\nMPTEMP,R5.0, 1, 1,  0.0    ,\n/eof\nE,1,2,3,4,5,6,7,8\n"
    );
    EXPECT_EQ(opened.mesh().node_count(), 8u);
    EXPECT_EQ(opened.mesh().element_count(), 1u);
    EXPECT_TRUE(opened.diagnostics->entries().empty()) << test::all_texts(*opened.diagnostics);
}

TEST(CdbDeck, other_files_are_read_where_they_are_named) {
    const std::string folder = test::scratch_folder("cdb_includes");
    test::write_file(
        folder + "/run.inp",
        "/PREP7\nCDREAD,DB,'mesh','cdb'\nET,1,185\n/INPUT,elements,inp\n/INPUT,gone,inp\n"
    );
    test::write_file(folder + "/mesh.cdb", kCube);
    test::write_file(folder + "/elements.inp", "E,1,2,3,4,5,6,7,8\n/INPUT,elements,inp\n");
    const auto opened = test::open_deck_file(folder + "/run.inp");
    EXPECT_GE(opened.mesh().element_count(), 1u);
    EXPECT_GE(opened.model->inputs().size(), 3u);
    EXPECT_THAT(test::all_texts(*opened.diagnostics), HasSubstr("gone.inp is named here, but not found"));
}

TEST(CdbDeck, shipped_archive_is_read_whole) {
    const auto opened = test::open_deck_file(test::project_file("tests/data/ansys/beam.cdb"));
    const Mesh& mesh = opened.mesh();
    EXPECT_EQ(mesh.node_count(), 39u);
    EXPECT_EQ(element_counts(mesh), (Counts{{"hex20", 2}, {"wedge15", 1}}));
    EXPECT_EQ(mesh.skipped_elements.at("SURF154"), 1u);
    EXPECT_EQ(mesh.length_unit->name, "mm");
    EXPECT_EQ(opened.model->title(), "Beam of two materials with a wedge at its end");
    EXPECT_EQ(opened.model->solver().version, "2025 R1");
    EXPECT_EQ(test::part_of(mesh, 1), "material 1");
    EXPECT_EQ(test::part_of(mesh, 3), "material 2");
    EXPECT_THAT(position_of(mesh, 21), ElementsAre(20, 0, 0));
    ASSERT_EQ(mesh.node_angles.size(), 39u);
    EXPECT_THAT(mesh.node_angles[20], ElementsAre(30, 0, 0));
    EXPECT_EQ(mesh.node_sets.at(0).nodes.size(), 8u);
    EXPECT_THAT(mesh.element_sets.at(0).elements, ElementsAre(ElementIndex{1}, ElementIndex{2}));
    Diagnostics of_skin;
    const SkinReport report = make_skin(mesh, {}, of_skin).report;
    EXPECT_EQ(report.solid_quad_kept, 11u);
    EXPECT_EQ(report.solid_tri_kept, 2u);
    EXPECT_TRUE(report.closed);
    EXPECT_NEAR(report.volume, 2500, 1e-9);
}

TEST(CdbDeck, shipped_deck_of_workbench_is_read_whole) {
    const auto opened = test::open_deck_file(test::project_file("tests/data/ansys/ds.dat"));
    const Mesh& mesh = opened.mesh();
    EXPECT_EQ(mesh.node_count(), 13u);
    EXPECT_EQ(element_counts(mesh), (Counts{{"hex8", 1}, {"quad4", 1}}));
    EXPECT_EQ(
        mesh.skipped_elements,
        (std::map<std::string, std::uint64_t>{{"CONTA174", 1}, {"SURF154", 1}, {"TARGE170", 1}})
    );
    EXPECT_EQ(mesh.length_unit->name, "mm");
    EXPECT_EQ(opened.model->solver().version, "2024 R2");
    EXPECT_EQ(test::part_of(mesh, 1), "Block (material 1)");
    EXPECT_EQ(test::part_of(mesh, 2), "Plate (material 2)");
    EXPECT_EQ(mesh.node_sets.at(0).name, "TOP");
    EXPECT_FALSE(opened.diagnostics->has(Code::UnknownBlock)) << test::all_texts(*opened.diagnostics);
}

TEST(CdbDeck, lists_by_material_find_the_body_of_their_material) {
    const std::string list =
        "\n PRINT S    NODAL SOLUTION PER NODE\n\n  ***** POST1 NODAL STRESS LISTING *****\n\n"
        "  LOAD STEP=     1  SUBSTEP=     1\n   TIME=    1.0000      LOAD CASE=   0\n"
        " NODAL RESULTS ARE FOR MATERIAL   1\n\n"
        "  THE FOLLOWING X,Y,Z VALUES ARE IN GLOBAL COORDINATES\n\n"
        "    NODE     SX          SY          SZ          SXY         SYZ         SXZ\n"
        "       1   1.0000      0.0000      0.0000      0.0000      0.0000      0.0000    \n";
    auto opened = test::open_decks(
        {{"ds.dat", test::read_file(test::project_file("tests/data/ansys/ds.dat"))}, {"PRNSOL.lis", list}}
    );
    ASSERT_EQ(opened.model->results().size(), 1u) << test::all_texts(*opened.diagnostics);
    const Result result = opened.model->load(0);
    const ResultInfo& info = result.info;
    EXPECT_EQ(info.name, "stress");
    ASSERT_FALSE(result.row_owner.empty());
    EXPECT_EQ(opened.mesh().parts.at(result.row_owner[0]).name, "Block (material 1)");
}

TEST(CdbRecognition, decks_of_other_programs_are_not_ours) {
    const ReadFormat format = ansys_cdb_format();
    const auto likelihood = [&](const std::string& text) {
        return format.recognise(Input::from_memory("x", text));
    };
    EXPECT_EQ(likelihood("!! HyperMesh\r\nNBLOCK,6,SOLID,105\r\n"), Likelihood::Sure);
    EXPECT_EQ(likelihood("/batch\n/prep7\n"), Likelihood::Sure);
    EXPECT_EQ(likelihood("/COM,ANSYS RELEASE 2019 R2\n"), Likelihood::Sure);
    EXPECT_EQ(likelihood("N,1,0,0,0\nN,2,1\nE,1,2\n"), Likelihood::Maybe);
    EXPECT_EQ(likelihood("*HEADING\n a deck\n*NODE\n1, 0., 0., 0.\nNBLOCK,\n"), Likelihood::No);
    EXPECT_EQ(likelihood("** comment\n*Node\n1, 0., 0., 0.\n"), Likelihood::No);
    EXPECT_EQ(likelihood("SOL 101\nCEND\nBEGIN BULK\nGRID,1,,0.,0.,0.\n"), Likelihood::No);
    EXPECT_EQ(likelihood("GRID           1              0.      0.      0.\nE,1,2\nN,1\n"), Likelihood::No);
    EXPECT_EQ(likelihood("just words\n"), Likelihood::No);
    EXPECT_EQ(likelihood(""), Likelihood::No);
}

}  // namespace
}  // namespace feelem
