// SPDX-License-Identifier: Apache-2.0
// Lists of values in all their forms. SYNTHETIC: the texts here were written by hand after real ones or after
// the documentation, not by Ansys.
#include "read_ansys/opened_lists.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace feelem {
namespace {

using test::all_texts;
using test::load_only;
using test::open_texts;
using test::text_of;
using test::value_at;
using testing::ElementsAre;
using testing::HasSubstr;

std::string page(
    const std::string& notes,
    const std::string& listing = "NODAL DEGREE OF FREEDOM",
    int substep = 1,
    const std::string& time = "TIME=    1.0000"
) {
    return " \n  ***** POST1 " + listing +
           " LISTING *****                            \n \n  LOAD STEP=     1  SUBSTEP=     " +
           std::to_string(substep) + "                                             \n   " + time +
           "      LOAD CASE=   0                                         \n \n" + notes;
}

const std::string kGlobal =
    "  THE FOLLOWING DEGREE OF FREEDOM RESULTS ARE IN THE GLOBAL COORDINATE SYSTEM  \n \n";

TEST(ValueLists, pages_footers_and_banners_are_no_values) {
    auto opened = open_texts(
        {"\n PRINT U    NODAL SOLUTION PER NODE\n\n *** ANSYS - ENGINEERING ANALYSIS SYSTEM  RELEASE 2021 R2 "
         "         21.2     ***\n"
         " 00000000  VERSION=LINUX x64     15:56:42  JAN 13, 2022 CP=      0.665\n" +
         page(kGlobal) +
         "    NODE      UX          UY          UZ          USUM  \n"
         "       1   0.0000      0.0000      0.0000      0.0000    \n" +
         page(kGlobal) +
         "    NODE      UX          UY          UZ          USUM  \n"
         "      30 -0.10000    -0.10000    -0.45981     0.48106    \n"
         "\n MAXIMUM ABSOLUTE VALUES\n NODE         30          30          30          30\n"
         " VALUE  -0.10000    -0.10000    -0.45981     0.48106    \n"}
    );
    EXPECT_THAT(opened.model->mesh().node_ids, ElementsAre(NodeId{1}, NodeId{30}));
    ASSERT_EQ(opened.model->results().size(), 1u);
    const Result u = load_only(opened, "displacement");
    EXPECT_THAT(u.values, ElementsAre(0, 0, 0, 0, -0.1F, -0.1F, -0.45981F, 0.48106F));
    EXPECT_TRUE(opened.diagnostics->entries().empty()) << all_texts(*opened.diagnostics);
}

TEST(ValueLists, temperature_and_rotation_have_their_names) {
    auto opened = open_texts(
        {"\n PRINT TEMP NODAL SOLUTION PER NODE\n" + page("") +
             "    NODE      TEMP  \n       1   118.33    \n       2 -0.78939E-01\n",
         "\n PRINT ROT  NODAL SOLUTION PER NODE\n" + page("") +
             "    NODE     ROTX         ROTY         ROTZ         RSUM\n"
             "       1  0.10000E-002-0.20000E-002  0.0000      0.22361E-002\n"}
    );
    EXPECT_THAT(load_only(opened, "temperature").values, ElementsAre(118.33F, -0.078939F));
    const Result rotation = load_only(opened, "rotation");
    EXPECT_EQ(rotation.info.components, (std::vector<std::string>{"x", "y", "z", "magnitude"}));
    EXPECT_EQ(value_at(opened.model->mesh(), rotation, "y", 1), -0.002F);
    EXPECT_TRUE(std::isnan(value_at(opened.model->mesh(), rotation, "y", 2)));
}

TEST(ValueLists, degrees_of_freedom_in_one_table_become_results) {
    auto opened = open_texts(
        {"\n PRINT DOF  NODAL SOLUTION PER NODE\n" + page("") +
         "    NODE      UX          UY          UZ          TEMP        VOLT\n"
         "       1  0.10000     0.20000     0.30000      20.000      12.000    \n"}
    );
    EXPECT_THAT(load_only(opened, "displacement").values, ElementsAre(0.1F, 0.2F, 0.3F));
    EXPECT_THAT(load_only(opened, "temperature").values, ElementsAre(20));
    EXPECT_THAT(load_only(opened, "electric_potential").values, ElementsAre(12));
}

TEST(ValueLists, sorted_by_value_they_still_go_to_their_nodes) {
    auto opened = open_texts(
        {page("") +
         "    NODE      TEMP  \n       7   300.00    \n       2   200.00    \n       5   100.00    \n"}
    );
    EXPECT_THAT(load_only(opened, "temperature").values, ElementsAre(200, 100, 300));
}

TEST(ValueLists, overflowed_and_blank_columns_are_missing) {
    auto opened = open_texts(
        {page(kGlobal) + "    NODE      UX          UY          UZ          USUM  \n"
                         "       1 ************ 0.20000     0.30000     0.40000    \n"
                         "       2  0.10000     NaN         0.30000    Infinity    \n"
                         "       3  0.10000                 0.30000     0.40000    \n"
                         "       4  0.10000E+40 0.20000     0.30000     0.40000    \n"}
    );
    const Result u = load_only(opened, "displacement");
    const Mesh& mesh = opened.model->mesh();
    EXPECT_TRUE(std::isnan(value_at(mesh, u, "x", 1)));
    EXPECT_EQ(value_at(mesh, u, "y", 1), 0.2F);
    EXPECT_TRUE(std::isnan(value_at(mesh, u, "y", 2)));
    EXPECT_EQ(value_at(mesh, u, "z", 2), 0.3F);
    EXPECT_TRUE(std::isnan(value_at(mesh, u, "magnitude", 2)));
    EXPECT_TRUE(std::isnan(value_at(mesh, u, "y", 3)));
    EXPECT_EQ(value_at(mesh, u, "z", 3), 0.3F);
    EXPECT_TRUE(std::isnan(value_at(mesh, u, "x", 4)));
    EXPECT_EQ(opened.diagnostics->count(Code::NonFiniteValue), 3u);
}

TEST(ValueLists, a_damaged_value_is_an_error_with_its_line) {
    try {
        auto opened =
            open_texts({page("") + "    NODE      TEMP  \n       7   300.00    \n       2   2x0.00    \n"});
        load_only(opened, "temperature");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::BadNumber);
        EXPECT_EQ(error.where(), "a.lis:9");
    }
}

TEST(ValueLists, exponents_without_a_letter_are_not_two_columns) {
    auto opened = open_texts(
        {page("", "NODAL STRESS") +
         "    NODE    SX          SY          SZ          SXY         SYZ         SXZ\n"
         "       1  0.12340-101 0.22242E+07-0.33333E-02 0.44444D+03 0.10000+003 0.20000E+01\n"}
    );
    const Result stress = load_only(opened, "stress");
    EXPECT_THAT(stress.values, ElementsAre(0, 0.22242E7F, -0.33333E-2F, 444.44F, 100, 2));
    EXPECT_EQ(stress.info.averaging, Averaging::Solver);
}

TEST(ValueLists, substeps_in_one_file_are_steps) {
    auto opened = open_texts(
        {"\n PRINT TEMP NODAL SOLUTION PER NODE\n" +
         page("", "NODAL DEGREE OF FREEDOM", 1, "TIME=    90.000") +
         "    NODE      TEMP  \n       1   10.000    \n" +
         page("", "NODAL DEGREE OF FREEDOM", 1, "TIME=    90.000") +
         "    NODE      TEMP  \n       2   11.000    \n" +
         page("", "NODAL DEGREE OF FREEDOM", 2, "TIME=    180.00") +
         "    NODE      TEMP  \n       1   20.000    \n       2   21.000    \n"}
    );
    ASSERT_EQ(opened.model->steps().size(), 2u);
    EXPECT_EQ(opened.model->steps()[1].substep, 2);
    EXPECT_EQ(opened.model->steps()[1].value, 180);
    EXPECT_EQ(opened.model->steps()[1].kind, StepKind::Time);
    ASSERT_EQ(opened.model->results().size(), 2u);
    EXPECT_THAT(opened.model->load(0).values, ElementsAre(10, 11));
    EXPECT_THAT(opened.model->load(1).values, ElementsAre(20, 21));
}

TEST(ValueLists, frequencies_make_frequency_steps) {
    auto opened = open_texts(
        {page(kGlobal, "NODAL DEGREE OF FREEDOM", 3, "FREQ=    47.852") +
         "    NODE       UY    \n       1  0.50000     \n"}
    );
    EXPECT_EQ(opened.model->steps()[0].kind, StepKind::Frequency);
    EXPECT_EQ(opened.model->steps()[0].substep, 3);
    EXPECT_EQ(opened.model->steps()[0].value, 47.852);
    EXPECT_EQ(opened.model->results()[0].components, (std::vector<std::string>{"y"}));
}

TEST(ValueLists, one_table_a_material_is_one_result_by_part) {
    const auto table = [](int material, const std::string& rows) {
        return page(
                   "  NODAL RESULTS ARE FOR MATERIAL   " + std::to_string(material) + "\n \n", "NODAL STRESS"
               ) +
               "    NODE     SX\n" + rows;
    };
    auto opened = open_texts(
        {"\n PRINT S    NODAL SOLUTION PER NODE\n" + table(2, "       1  10.000\n       5  11.000\n") +
         table(7, "       5  20.000\n       9  21.000\n") + table(8, "")}
    );
    ASSERT_EQ(opened.model->results().size(), 1u);
    const Result stress = opened.model->load(0);
    EXPECT_EQ(stress.info.location, Location::PartNodal);
    EXPECT_THAT(stress.values, ElementsAre(10, 11, 20, 21));
    EXPECT_THAT(stress.row_owner, ElementsAre(0u, 0u, 1u, 1u));
    EXPECT_THAT(stress.row_node, ElementsAre(NodeIndex{0}, NodeIndex{1}, NodeIndex{1}, NodeIndex{2}));
    EXPECT_EQ(opened.model->mesh().parts[1].name, "material 7");
}

TEST(ValueLists, shells_have_a_top_and_a_bottom_result) {
    auto opened = open_texts(
        {page("  SHELL NODAL RESULTS ARE AT TOP/BOTTOM FOR MATERIAL   1\n \n", "NODAL STRESS") +
         "    NODE    SX          SY\n"
         "       1  1.0000      2.0000    \n       1 -1.0000     -2.0000    \n"
         "       2  3.0000      4.0000    \n       2 -3.0000     -4.0000    \n"}
    );
    EXPECT_THAT(load_only(opened, "stress", "", Layer::Top).values, ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(load_only(opened, "stress", "", Layer::Bottom).values, ElementsAre(-1, -2, -3, -4));
}

TEST(ValueLists, a_node_with_two_values_and_no_reason_is_missing_and_reported) {
    auto opened = open_texts(
        {page("") + "    NODE      TEMP  \n       1   10.000    \n       2   11.000    \n       1   12.000   "
                    " \n       2   11.000    \n"}
    );
    const Result temperature = load_only(opened, "temperature");
    EXPECT_TRUE(std::isnan(temperature.values.at(0)));
    EXPECT_EQ(temperature.values.at(1), 11);
    EXPECT_EQ(opened.diagnostics->count(Code::SeveralValuesAtNode), 1u);
}

TEST(ValueLists, two_commands_in_one_file_are_two_results) {
    auto opened = open_texts(
        {" PRINT S    NODAL SOLUTION PER NODE\n" + page("", "NODAL STRESS") +
         "    NODE     S1           S2           S3           SINT         SEQV\n"
         "       1  3.0000       2.0000       1.0000       2.0000       1.7321    \n"
         " MINIMUM VALUES\n NODE          1            1            1            1            1\n"
         " VALUE   3.0000       2.0000       1.0000       2.0000       1.7321    \n"
         "\n PRINT EPEL NODAL SOLUTION PER NODE\n" +
         page("", "NODAL ELASTIC STRAIN") +
         "    NODE    EPELX       EPELY       EPELZ       EPELXY      EPELYZ      EPELXZ\n"
         "       1  1.0000      2.0000      3.0000      4.0000      5.0000      6.0000    \n"}
    );
    const Result stress = load_only(opened, "stress");
    EXPECT_EQ(
        stress.info.components,
        (std::vector<std::string>{"principal_1", "principal_2", "principal_3", "tresca", "von_mises"})
    );
    EXPECT_THAT(stress.values, ElementsAre(3, 2, 1, 2, 1.7321F));
    const Result strain = load_only(opened, "elastic_strain");
    EXPECT_EQ(strain.info.shear, Shear::Engineering);
    EXPECT_EQ(strain.info.shape, Shape::SymmetricTensor);
    EXPECT_EQ(strain.info.components, (std::vector<std::string>{"xx", "yy", "zz", "xy", "yz", "zx"}));
}

TEST(ValueLists, invariants_listed_apart_join_their_tensor) {
    auto opened = open_texts(
        {page("", "NODAL STRESS") +
             "    NODE     S1           S2           S3           SINT         SEQV\n"
             "       2  30.000       20.000       10.000       20.000       17.321    \n"
             "       1  3.0000       2.0000       1.0000       2.0000       1.7321    \n",
         page("", "NODAL STRESS") +
             "    NODE    SX          SY          SZ          SXY         SYZ         SXZ\n"
             "       1  1.0000      2.0000      3.0000      4.0000      5.0000      6.0000    \n"
             "       2  10.000      20.000      30.000      40.000      50.000      60.000    \n",
         page("", "NODAL STRESS", 2) +
             "    NODE     S1           S2           S3           SINT         SEQV\n"
             "       1  9.0000       8.0000       7.0000       6.0000       5.0000    \n"}
    );
    ASSERT_EQ(opened.model->results().size(), 2u);
    EXPECT_EQ(opened.model->steps().size(), 2u);
    const Result joined = load_only(opened, "stress", "xx");
    EXPECT_EQ(joined.info.shape, Shape::SymmetricTensor);
    ASSERT_EQ(joined.info.components.size(), 11u);
    EXPECT_EQ(joined.info.components[10], "von_mises");
    EXPECT_EQ(opened.model->steps()[joined.info.step].substep, 1);
    EXPECT_THAT(
        joined.values,
        ElementsAre(1, 2, 3, 4, 5, 6, 3, 2, 1, 2, 1.7321F, 10, 20, 30, 40, 50, 60, 30, 20, 10, 20, 17.321F)
    );
}

TEST(ValueLists, titles_alone_name_the_columns) {
    auto opened = open_texts(
        {"\n PRINT U    NODAL SOLUTION PER NODE\n       1    0.2896239142E+02  -0.2824804886E+02  "
         "-0.3092266922E+00   0.4045822539E+02\n",
         "\n PRINT S    NODAL SOLUTION PER NODE\n       1    0.1E+01   0.2E+01   0.3E+01   0.4E+01   0.5E+01 "
         "  0.6E+01\n"}
    );
    EXPECT_EQ(load_only(opened, "displacement").info.shape, Shape::Vector);
    EXPECT_EQ(load_only(opened, "stress").info.shape, Shape::SymmetricTensor);
    EXPECT_EQ(opened.model->steps()[0].kind, StepKind::Other);
}

TEST(ValueLists, columns_without_any_name_keep_their_numbers) {
    auto opened = open_texts({"       1   118.33    \n       2  0.19236    \n"});
    const Result values = load_only(opened, "values");
    EXPECT_EQ(values.info.components, (std::vector<std::string>{"column_1"}));
    EXPECT_THAT(values.values, ElementsAre(118.33F, 0.19236F));
}

TEST(ValueLists, other_axes_keep_the_solvers_names_and_are_warned_of) {
    auto opened = open_texts(
        {page("  THE FOLLOWING X,Y,Z VALUES ARE IN COORDINATE SYSTEM         1\n \n", "NODAL STRESS") +
         "    NODE    SX          SY          SZ          SXY         SYZ         SXZ\n"
         "       1  1.0000      2.0000      3.0000      4.0000      5.0000      6.0000    \n"}
    );
    const Result stress = load_only(opened, "stress");
    EXPECT_EQ(stress.info.shape, Shape::Other);
    EXPECT_EQ(stress.info.components[0], "sx");
    EXPECT_THAT(text_of(*opened.diagnostics, Code::CoordinateSystem), HasSubstr("RSYS,0"));
}

TEST(ValueLists, nodal_systems_need_the_angles_of_the_node_list) {
    const std::string list =
        page("  THE FOLLOWING DEGREE OF FREEDOM RESULTS ARE IN THE NODAL COORDINATE SYSTEMS  \n \n") +
        "    NODE      UX          UY          UZ          USUM  \n"
        "       7  1.0000      0.0000      0.0000      1.0000    \n";
    const std::string head = "   NODE        X           Y           Z         THXY    THYZ    THZX\n";
    auto rotated =
        open_texts({list, head + "       7    2.0000     0.0000      0.0000       90.00    0.00    0.00\n"});
    EXPECT_TRUE(load_only(rotated, "displacement").info.nodal_system);
    EXPECT_FALSE(rotated.diagnostics->has(Code::CoordinateSystem));
    auto straight =
        open_texts({list, head + "       7    2.0000     0.0000      0.0000        0.00    0.00    0.00\n"});
    EXPECT_FALSE(load_only(straight, "displacement").info.nodal_system);
    auto unknown = open_texts({list});
    EXPECT_TRUE(unknown.diagnostics->has(Code::CoordinateSystem));
}

TEST(ValueLists, presol_is_kept_by_element) {
    const std::string nodes = "   NODE        X                   Y                   Z\n"
                              "       1     0.00000000000       0.00000000000       0.00000000000    \n"
                              "       2     1.00000000000       0.00000000000       0.00000000000    \n"
                              "       3     2.00000000000       0.00000000000       0.00000000000    \n";
    const std::string elements = "    ELEM MAT TYP REL ESY SEC        NODES\n       5   1   1   1   0   1    "
                                 "  1     2\n       4   1   1   1   0   1      2     3\n";
    const std::string values = "\n PRINT S    ELEMENT SOLUTION PER ELEMENT\n" +
                               page("", "ELEMENT NODAL STRESS") +
                               "  ELEMENT=       4        LINK180 \n    NODE    SX          SY\n"
                               "       2  1.0000      2.0000    \n       3  3.0000      4.0000    \n" +
                               page("", "ELEMENT NODAL STRESS") +
                               "  ELEMENT=       5        LINK180 \n    NODE    SX          SY\n"
                               "       2  5.0000      6.0000    \n       1  7.0000      8.0000    \n"
                               "  ELEMENT=      99        LINK180 \n    NODE    SX          SY\n"
                               "       2  0.0000      0.0000    \n";
    auto opened = open_texts({nodes, elements, values}, "1=LINK180");
    const Result stress = load_only(opened, "stress");
    EXPECT_EQ(stress.info.location, Location::ElementNodal);
    EXPECT_EQ(stress.info.averaging, Averaging::None);
    EXPECT_THAT(stress.row_owner, ElementsAre(0u, 0u, 1u, 1u));
    EXPECT_THAT(stress.row_node, ElementsAre(NodeIndex{0}, NodeIndex{1}, NodeIndex{1}, NodeIndex{2}));
    EXPECT_THAT(stress.values, ElementsAre(7, 8, 5, 6, 1, 2, 3, 4));
    EXPECT_EQ(opened.diagnostics->count(Code::ResultWithoutNode), 1u);
}

TEST(ValueLists, pretab_gives_values_of_elements) {
    auto opened = open_texts(
        {"   NODE        X                   Y                   Z\n"
         "       1     0.00000000000       0.00000000000       0.00000000000    \n"
         "       2     1.00000000000       0.00000000000       0.00000000000    \n",
         "    ELEM MAT TYP REL ESY SEC        NODES\n       5   1   1   1   0   1      1     2\n",
         " PRINT ELEMENT TABLE ITEMS PER ELEMENT\n   *****ANSYS VERIFICATION RUN ONLY*****\n     DO NOT USE "
         "RESULTS FOR PRODUCTION\n"
         "  ***** POST1 ELEMENT TABLE LISTING *****\n    STAT     CURRENT\n    ELEM     SEQV\n       5  "
         "0.59135E-001\n"},
        "1=LINK180"
    );
    const Result table = load_only(opened, "seqv");
    EXPECT_EQ(table.info.location, Location::Elemental);
    EXPECT_THAT(table.values, ElementsAre(0.059135F));
}

TEST(ValueLists, reactions_are_forces_with_holes) {
    auto opened = open_texts({"PRINT F    REACTION SOLUTIONS PER NODE\n\n  ***** POST1 TOTAL REACTION "
                              "SOLUTION LISTING *****\n\n  LOAD STEP=     1  SUBSTEP=     1\n"
                              "   TIME=    1.0000      LOAD CASE=   0\n\n  THE FOLLOWING X,Y,Z SOLUTIONS ARE "
                              "IN THE GLOBAL COORDINATE SYSTEM\n\n"
                              "    NODE       FX           FY\n       1  0.12875E+008 0.42667E+007\n       2 "
                              "             0.22476E+007\n"
                              "\n TOTAL VALUES\n VALUE  -0.37253E-008 0.46566E-009\n"});
    const Result force = load_only(opened, "reaction_force");
    EXPECT_EQ(value_at(opened.model->mesh(), force, "x", 1), 0.12875E8F);
    EXPECT_TRUE(std::isnan(value_at(opened.model->mesh(), force, "x", 2)));
    EXPECT_EQ(value_at(opened.model->mesh(), force, "y", 2), 0.22476E7F);
}

TEST(ValueLists, nodes_that_the_mesh_lacks_are_counted) {
    auto opened = open_texts(
        {"   NODE        X                   Y                   Z\n       1     0.00000000000       "
         "0.00000000000       0.00000000000    \n"
         "       2     1.00000000000       0.00000000000       0.00000000000    \n",
         page("") + "    NODE      TEMP  \n       1   10.000    \n       3   11.000    \n"}
    );
    const Result temperature = load_only(opened, "temperature");
    EXPECT_EQ(temperature.values.at(0), 10);
    EXPECT_TRUE(std::isnan(temperature.values.at(1)));
    EXPECT_EQ(opened.diagnostics->count(Code::ResultWithoutNode), 1u);
    EXPECT_EQ(opened.diagnostics->count(Code::ResultForPartOfModel), 1u);
}

TEST(ValueLists, a_table_without_rows_is_left_out) {
    auto opened = open_texts(
        {page("") + "    NODE      TEMP  \n\n" + "       1   10.000    \n" + page("", "NODAL STRESS") +
         "    NODE      SX  \n\n MINIMUM VALUES\n"}
    );
    EXPECT_EQ(opened.model->results().size(), 1u);
    EXPECT_EQ(opened.diagnostics->count(Code::EmptyResult), 1u);
}

TEST(ValueLists, text_among_rows_is_counted) {
    auto opened = open_texts(
        {page("") +
         "    NODE      TEMP  \n       1   10.000    \n see me about this one\n       2   11.000    \n"}
    );
    EXPECT_THAT(load_only(opened, "temperature").values, ElementsAre(10, 11));
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownBlock), 1u);
}

TEST(ValueLists, temperatures_of_thermal_shells_have_their_layer) {
    auto opened =
        open_texts({page("") + "    NODE      TTOP        TBOT\n       1   10.000      20.000    \n"});
    EXPECT_THAT(load_only(opened, "temperature", "", Layer::Top).values, ElementsAre(10));
    EXPECT_THAT(load_only(opened, "temperature", "", Layer::Bottom).values, ElementsAre(20));
}

}  // namespace
}  // namespace feelem
