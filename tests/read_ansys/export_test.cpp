// SPDX-License-Identifier: Apache-2.0
// Tables exported by Workbench Mechanical. SYNTHETIC: written by hand after real ones; the decimal commas,
// the UTF-16 text and the other languages after the documentation.
#include "read_ansys/opened_lists.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace feelem {
namespace {

using namespace std::string_literals;
using test::all_texts;
using test::load_only;
using test::open_texts;
using test::value_at;
using testing::ElementsAre;

const std::string kHead = "Node Number\tX Location (mm)\tY Location (mm)\tZ Location (mm)\t";

TEST(MechanicalExport, unit_is_in_the_last_brackets) {
    auto opened = open_texts(
        {kHead + "Equivalent (von-Mises) Stress "
                 "(MPa)\r\n7\t6.6667\t3.3333\t0.\t1.0597e-003\r\n9\t1.\t2.\t3.\t-3.576e-002\r\n"}
    );
    const Mesh& mesh = opened.model->mesh();
    EXPECT_THAT(mesh.node_ids, ElementsAre(NodeId{7}, NodeId{9}));
    EXPECT_EQ(mesh.coordinates[0], (Point3{6.6667, 3.3333, 0}));
    ASSERT_TRUE(mesh.length_unit);
    EXPECT_EQ(mesh.length_unit->name, "mm");
    const Result stress = load_only(opened, "stress", "von_mises");
    EXPECT_EQ(stress.info.unit, "MPa");
    EXPECT_EQ(stress.info.solver_name, "Equivalent (von-Mises) Stress");
    EXPECT_EQ(stress.info.averaging, Averaging::Solver);
    EXPECT_THAT(stress.values, ElementsAre(1.0597e-3F, -3.576e-2F));
    EXPECT_TRUE(opened.diagnostics->has(Code::LowPrecision));
}

TEST(MechanicalExport, commas_and_no_places) {
    auto opened = open_texts({"Node Number,Total Deformation (m)\n3,1.5e-006\n4,2.5e-006\n"});
    EXPECT_THAT(load_only(opened, "displacement", "magnitude").values, ElementsAre(1.5e-6F, 2.5e-6F));
    EXPECT_TRUE(std::isnan(opened.model->mesh().coordinates[0][0]));
    EXPECT_FALSE(opened.model->mesh().length_unit);
}

TEST(MechanicalExport, decimal_commas_with_tabs_and_semicolons) {
    for (const std::string s : {"\t", ";"}) {
        auto opened = open_texts(
            {"Knotennummer" + s + "X-Koordinate (mm)" + s + "Y-Koordinate (mm)" + s + "Z-Koordinate (mm)" +
             s +
             "Temperatur (\xC2\xB0"
             "C)\n" +
             "1" + s + "1,5" + s + "0," + s + "-2,5e-003" + s + "1,1959e+002\n"}
        );
        const Result temperature = load_only(opened, "temperatur");
        EXPECT_THAT(temperature.values, ElementsAre(119.59F));
        EXPECT_EQ(
            temperature.info.unit,
            "\xC2\xB0"
            "C"
        );
        EXPECT_EQ(opened.model->mesh().coordinates[0], (Point3{1.5, 0, -2.5e-3}));
    }
}

TEST(MechanicalExport, latin_1_and_utf_16_give_the_same_unit) {
    const std::string plain = "Node Number\tTemperature (\xB0"
                              "C)\n1\t22.\n2\t23.\n";
    std::string wide = "\xFF\xFE";
    for (const char c : plain) {
        wide += c;
        wide += '\0';
    }
    for (const std::string& text : {plain, wide}) {
        auto opened = open_texts({text});
        const Result temperature = load_only(opened, "temperature");
        EXPECT_EQ(
            temperature.info.unit,
            "\xC2\xB0"
            "C"
        );
        EXPECT_THAT(temperature.values, ElementsAre(22, 23));
    }
}

TEST(MechanicalExport, a_node_once_a_body_keeps_all_values_by_body) {
    auto opened = open_texts(
        {kHead + "Normal Stress "
                 "(MPa)\n2\t1.\t0.\t0.\t10.\n5\t2.\t0.\t0.\t11.\n1\t0.\t0.\t0.\t20.\n2\t1.\t0.\t0.\t21.\n"}
    );
    const Result stress = load_only(opened, "normal_stress");
    EXPECT_EQ(stress.info.location, Location::PartNodal);
    EXPECT_THAT(stress.values, ElementsAre(10, 11, 20, 21));
    EXPECT_THAT(stress.row_owner, ElementsAre(0u, 0u, 1u, 1u));
    EXPECT_EQ(opened.model->mesh().node_count(), 3u);
    EXPECT_FALSE(opened.diagnostics->has(Code::SeveralValuesAtNode));
}

const std::string kTwoTrusses = "   NODE        X                   Y                   Z\n"
                                "       1     0.00000000000       0.00000000000       0.00000000000    \n"
                                "       2     1.00000000000       0.00000000000       0.00000000000    \n"
                                "       5     2.00000000000       0.00000000000       0.00000000000    \n\n"
                                "    ELEM MAT TYP REL ESY SEC        NODES\n"
                                "       1   1   1   1   0   1      1     2\n"
                                "       2   2   1   1   0   1      2     5\n";

TEST(MechanicalExport, bodies_are_found_among_the_materials_of_a_mesh) {
    auto opened = open_texts(
        {kTwoTrusses,
         kHead + "Normal Stress "
                 "(MPa)\n2\t1.\t0.\t0.\t10.\n5\t2.\t0.\t0.\t11.\n1\t0.\t0.\t0.\t20.\n2\t1.\t0.\t0.\t21.\n"},
        "1=LINK180"
    );
    const Result stress = load_only(opened, "normal_stress");
    ASSERT_EQ(stress.info.location, Location::PartNodal) << all_texts(*opened.diagnostics);
    EXPECT_THAT(stress.row_owner, ElementsAre(0u, 0u, 1u, 1u));
    EXPECT_THAT(stress.values, ElementsAre(20, 21, 10, 11));
    EXPECT_FALSE(opened.model->mesh().length_unit)
        << "the node list's unit is unknown, whatever the export's is";
}

TEST(MechanicalExport, bodies_that_fit_no_material_leave_the_interface_missing) {
    auto opened = open_texts(
        {kTwoTrusses,
         kHead + "Normal Stress "
                 "(MPa)\n1\t1.\t0.\t0.\t10.\n2\t2.\t0.\t0.\t11.\n5\t0.\t0.\t0.\t12.\n2\t1.\t0.\t0.\t21.\n"},
        "1=LINK180"
    );
    const Result stress = load_only(opened, "normal_stress");
    EXPECT_EQ(stress.info.location, Location::Nodal);
    EXPECT_EQ(value_at(opened.model->mesh(), stress, "value", 1), 10);
    EXPECT_TRUE(std::isnan(value_at(opened.model->mesh(), stress, "value", 2)));
    EXPECT_EQ(opened.diagnostics->count(Code::SeveralValuesAtNode), 1u);
}

TEST(MechanicalExport, values_of_elements_need_the_elements) {
    const std::string table = "Element Number\tNormal Stress (MPa)\n1\t2.5437\n2\t-0.35216\n";
    auto opened = open_texts({kTwoTrusses, table}, "1=LINK180");
    const Result stress = load_only(opened, "normal_stress");
    EXPECT_EQ(stress.info.location, Location::Elemental);
    EXPECT_THAT(stress.values, ElementsAre(2.5437F, -0.35216F));
    try {
        open_texts({table});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::NoElements);
    }
}

TEST(MechanicalExport, deformation_components_are_no_places) {
    auto opened = open_texts({"Node Number\tX Deformation (m)\tY Deformation (m)\tZ Deformation (m)\tTotal "
                              "Deformation (m)\n1\t1.\t2.\t3.\t4.\n"});
    EXPECT_EQ(opened.model->results().size(), 4u);
    EXPECT_TRUE(std::isnan(opened.model->mesh().coordinates[0][0]));
}

TEST(MechanicalExport, an_unfinished_last_row_is_left_out) {
    auto opened = open_texts({"Node Number\tTemperature (C)\n1\t22.5\n2\t23."});
    EXPECT_EQ(opened.model->mesh().node_count(), 1u);
    load_only(opened, "temperature");
    EXPECT_TRUE(opened.diagnostics->has(Code::TruncatedInput));
}

TEST(MechanicalExport, tables_of_other_things_are_not_taken) {
    try {
        open_texts({"Steps\tTime [s]\n1\t1.\n2\t2.\n"});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::UnknownFormat);
    }
}

}  // namespace
}  // namespace feelem
