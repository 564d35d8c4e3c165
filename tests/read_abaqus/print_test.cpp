// SPDX-License-Identifier: Apache-2.0
// Abaqus' printed tables: small ones in the forms that public excerpts of its .dat files show.
#include "open_deck.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace feelem {
namespace {

using namespace tests;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

constexpr const char* kPlate =
    "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n6,2,1\n*ELEMENT,TYPE=S4\n1,1,2,3,4\n2,2,5,6,3\n";
constexpr const char* kStart = R"(
   Abaqus 6.14-1                                  Date 12-Jan-2018   Time 10:00:00

                        S T E P       2     S T A T I C   A N A L Y S I S

                                INCREMENT     3 SUMMARY

 TIME INCREMENT COMPLETED  0.500    ,  FRACTION OF STEP COMPLETED   1.00
 STEP TIME COMPLETED       0.500    ,  TOTAL TIME COMPLETED         1.50

)";

Opened open_printed(const std::string& tables, const std::string& deck = kPlate) {
    return open_decks({{"job.dat", kStart + tables}, {"job.inp", deck}});
}

Result load(const Opened& opened, const std::string& name, Layer layer = Layer::No) {
    for (std::size_t i = 0; i < opened.model->results().size(); ++i) {
        const ResultInfo& info = opened.model->results()[i];
        if (info.name == name && info.layer == layer) return opened.model->load(i);
    }
    ADD_FAILURE() << "no " << name;
    return {};
}

/// Values of a solver's node or element number.
std::vector<float> values_at(const Opened& opened, const Result& result, std::int64_t id) {
    const std::size_t width = result.component_count();
    const bool nodal = result.info.location == Location::Nodal;
    const auto ids = nodal ? node_ids(opened.mesh()) : element_ids(opened.mesh());
    const auto at = static_cast<std::ptrdiff_t>(width) * (std::ranges::find(ids, id) - ids.begin());
    return {result.values.begin() + at, result.values.begin() + at + static_cast<std::ptrdiff_t>(width)};
}

std::string texts_of(const Opened& opened, Code code) {
    std::string all;
    for (const Diagnostic& entry : opened.diagnostics->entries())
        if (entry.code == code) all += entry.text + "\n";
    return all;
}

constexpr const char* kNodes = R"(
                                       N O D E   O U T P U T


   THE FOLLOWING TABLE IS PRINTED FOR NODES BELONGING TO NODE SET CONTACT_SIDE

       NODE FOOT-   U1          U2          UR3         NT11
            NOTE

          2      7.3531E-04 -4.6698E-03   0.000       3.5012E+02
          3      1.4706E-03   0.000      -1.0000E-03  3.5000E+02

 MAXIMUM         1.4706E-03   0.000       0.000       3.5012E+02
 AT NODE                 3           1           2           2

 MINIMUM          0.000     -4.6698E-03 -1.0000E-03   0.000
 AT NODE                 1           2           3           1


   THE FOLLOWING TABLE IS PRINTED FOR NODES BELONGING TO NODE SET OTHER

       NODE FOOT-   U1          U2          UR3
            NOTE

          5 T     1.0000E-03 -4.0000E-03   2.500

          THE ANALYSIS HAS BEEN COMPLETED
)";

TEST(PrintTables, tables_of_nodes_of_several_sets_are_one_result) {
    const Opened opened = open_printed(kNodes);
    ASSERT_EQ(opened.model->steps().size(), 1U);
    EXPECT_EQ(opened.model->steps()[0].step, 2);
    EXPECT_EQ(opened.model->steps()[0].substep, 3);
    EXPECT_EQ(opened.model->steps()[0].value, 1.5);
    EXPECT_EQ(opened.model->steps()[0].kind, StepKind::Static);
    EXPECT_EQ(opened.model->steps()[0].label, "static analysis");
    EXPECT_EQ(opened.model->solver().version, "6.14-1");
    const Result displacement = load(opened, "displacement");
    EXPECT_THAT(displacement.info.components, ElementsAre("x", "y"));
    EXPECT_THAT(values_at(opened, displacement, 2), ElementsAre(7.3531E-04F, -4.6698E-03F));
    EXPECT_THAT(values_at(opened, displacement, 5), ElementsAre(1e-3F, -4e-3F));
    EXPECT_THAT(values_at(opened, displacement, 1), ElementsAre(IsNan(), IsNan()));
    EXPECT_THAT(values_at(opened, load(opened, "rotation"), 5), ElementsAre(2.5F));
    EXPECT_THAT(values_at(opened, load(opened, "temperature"), 2), ElementsAre(350.12F));
    EXPECT_EQ(opened.model->results().size(), 3U);
    EXPECT_THAT(
        texts_of(opened, Code::ResultForPartOfModel), HasSubstr("3 of 6 nodes. Abaqus prints no row")
    );
    EXPECT_FALSE(opened.diagnostics->has(Code::ValuesDisagree)) << texts_of(opened, Code::ValuesDisagree);
    EXPECT_FALSE(opened.diagnostics->has(Code::UnknownBlock)) << texts_of(opened, Code::UnknownBlock);
}

TEST(PrintTables, extremes_that_are_not_those_of_the_rows_are_reported) {
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string text = kNodes;
        text.replace(text.find(from), from.size(), to);
        const Opened opened = open_printed(text);
        load(opened, "displacement");
        load(opened, "displacement");
        return texts_of(opened, Code::ValuesDisagree);
    };
    // A row beyond the maximum; the maximum at another node than it says; at a node that is not listed.
    EXPECT_THAT(changed("  2      7.3531E-04", "  2      7.3531E-03"), HasSubstr("the maximum of U1"));
    EXPECT_THAT(changed("  2      7.3531E-04", "  2      7.3531E-03"), HasSubstr("2 has 7.3531E-03"));
    EXPECT_THAT(
        changed("  3      1.4706E-03", "  3      1.4606E-03"), HasSubstr("its row has another value")
    );
    EXPECT_THAT(
        changed("3           1           2 ", "9           1           2 "), HasSubstr("no such row")
    );
    EXPECT_THAT(
        changed("  2      7.3531E-04 -4.6698E-03", "  2      7.3531E-04 -4.7698E-03"),
        HasSubstr("the minimum of U2")
    );
    EXPECT_EQ(changed("7.3531E-04", "7.3530E-04"), "") << "no extreme";
}

TEST(PrintTables, extremes_with_fewer_digits_than_their_rows_agree) {
    const Opened opened = open_printed(R"(
   THE FOLLOWING TABLE IS PRINTED FOR ALL NODES

       NODE FOOT-   COOR1          COOR2          COOR3
            NOTE

          1     -5.0000000E+00 -5.0000000E+00 -5.0000000E+00
          2      6.5331234E+00 -1.1555553E+00 -4.9999999E+00

 MAXIMUM          6.533      -1.156      -5.000
 AT NODE                 2           2           2

 MINIMUM         -5.000      -5.000      -5.000
 AT NODE                 1           1           1
)");
    EXPECT_EQ(values_at(opened, load(opened, "coordinates"), 2)[0], 6.5331234F);
    EXPECT_EQ(texts_of(opened, Code::ValuesDisagree), "");
}

TEST(PrintTables, elements_show_the_mean_of_their_integration_points_for_each_section_point) {
    const Opened opened = open_printed(R"(
                             E L E M E N T   O U T P U T

   THE FOLLOWING TABLE IS PRINTED AT THE INTEGRATION POINTS FOR ELEMENT TYPE S4 AND ELEMENT
   SET PLATE

    ELEMENT  PT SEC FOOT-   S11         S22         S12         MISES
                PT  NOTE

          1   1   1 OR  10.00       2.000       3.000       12.00
          1   1   5 OR  20.00       2.000       3.000       22.00
          1   2   1 OR  13.00       2.000       4.000       15.00
          1   2   5 OR  24.00       2.000       4.000       26.00
OR: *ORIENTATION USED FOR THIS ELEMENT

 MAXIMUM            24.00       2.000       4.000       26.00
 ELEMENT                 1           1           1           1

 MINIMUM            10.00       2.000       3.000       12.00
 ELEMENT                 1           1           1           1
)");
    const Result bottom = load(opened, "stress", Layer::Bottom), top = load(opened, "stress", Layer::Top);
    EXPECT_EQ(bottom.info.location, Location::Elemental);
    EXPECT_EQ(bottom.info.shape, Shape::SymmetricTensor);
    EXPECT_EQ(bottom.info.solver_name, "S (mean of integration points)");
    EXPECT_THAT(values_at(opened, bottom, 1), ElementsAre(11.5F, 2, IsNan(), 3.5F, IsNan(), IsNan()));
    EXPECT_THAT(values_at(opened, top, 1), ElementsAre(22, 2, IsNan(), 3.5F, IsNan(), IsNan()));
    EXPECT_THAT(values_at(opened, top, 2), testing::Each(IsNan()));
    EXPECT_THAT(values_at(opened, load(opened, "mises", Layer::Top), 1), ElementsAre(24));
    EXPECT_THAT(texts_of(opened, Code::UnknownBlock), HasSubstr("mean of its points"));
    EXPECT_THAT(texts_of(opened, Code::CoordinateSystem), HasSubstr("OR"));
    EXPECT_EQ(texts_of(opened, Code::ValuesDisagree), "");
}

TEST(PrintTables, values_at_nodes_of_elements_stay_unaveraged_and_centroids_are_elements) {
    const Opened opened = open_printed(R"(
   THE FOLLOWING TABLE IS PRINTED FOR ALL ELEMENTS WITH TYPE S4 AT THE NODES

    ELEMENT  ND FOOT-       E11         E12
                NOTE

          2   5             1.000       0.5000
          2   2             2.000       0.2500
          1   2             4.000       0.000

   THE FOLLOWING TABLE IS PRINTED AT THE CENTROID OF THE ELEMENT FOR ELEMENT TYPE S4 AND ELEMENT SET
   PLATE

    ELEMENT  FOOT-  LE11        PEEQ
             NOTE

          2         3.000       4.000

   THE FOLLOWING TABLE IS PRINTED FOR ALL ELEMENTS WITH TYPE S4 AVERAGED AT THE NODES

       NODE FOOT-   S11
            NOTE

          6        -7.000
)");
    const Result strain = load(opened, "strain");
    EXPECT_EQ(strain.info.location, Location::ElementNodal);
    EXPECT_EQ(strain.info.shear, Shear::Engineering);
    EXPECT_THAT(strain.row_owner, ElementsAre(0, 1, 1));
    EXPECT_THAT(strain.row_node, ElementsAre(NodeIndex{1}, NodeIndex{1}, NodeIndex{4}));
    EXPECT_EQ(strain.values[0], 4);
    EXPECT_EQ(strain.values[6 + 3], 0.25F);
    EXPECT_EQ(values_at(opened, load(opened, "logarithmic_strain"), 2)[0], 3);
    EXPECT_THAT(values_at(opened, load(opened, "peeq"), 2), ElementsAre(4));
    const Result stress = load(opened, "stress");
    EXPECT_EQ(stress.info.averaging, Averaging::Solver);
    EXPECT_EQ(values_at(opened, stress, 6)[0], -7);
}

TEST(PrintTables, modes_have_their_frequency_and_buckling_its_factor) {
    const std::string table = R"(
   THE FOLLOWING TABLE IS PRINTED FOR ALL NODES

       NODE FOOT-   U1
            NOTE

          1        1.000
)";
    const std::string number = "\n                    E I G E N V A L U E    N U M B E R     ";
    const Opened modes = open_printed(
        "                        S T E P       3     C A L C U L A T I O N   O F   E I G E N V A L U E S\n\n"
        "                              E I G E N V A L U E    O U T P U T\n\n"
        " MODE NO      EIGENVALUE              FREQUENCY         GENERALIZED MASS   COMPOSITE MODAL DAMPING\n"
        "                             (RAD/TIME)   (CYCLES/TIME)\n\n"
        "       1       7827.2         88.471         14.081         47.597         0.0000\n"
        "       2      6.97066E+06     2640.2         420.20         1.0000         0.0000\n\n" +
        number + "1\n" + table + number + "2\n" + table
    );
    ASSERT_EQ(modes.model->steps().size(), 2U);
    EXPECT_EQ(modes.model->steps()[1].kind, StepKind::Mode);
    EXPECT_EQ(modes.model->steps()[1].substep, 2);
    EXPECT_EQ(modes.model->steps()[1].value, 420.2);
    const Opened buckling = open_printed(
        "                        S T E P       1     E I G E N V A L U E   B U C K L I N G\n\n"
        " MODE NO      EIGENVALUE\n\n       1      -12.5\n" +
        number + "1\n" + table
    );
    ASSERT_EQ(buckling.model->steps().size(), 1U);
    EXPECT_EQ(buckling.model->steps()[0].kind, StepKind::Buckling);
    EXPECT_EQ(buckling.model->steps()[0].value, -12.5);
}

TEST(PrintTables, what_is_not_read_is_named_by_its_title) {
    const Opened opened = open_printed(R"(
   THE FOLLOWING TABLE IS PRINTED FOR SLAVE SURFACE A AND MASTER SURFACE B

       NODE FOOT-   CPRESS
            NOTE

          1        1.000

   THE FOLLOWING TABLE IS PRINTED FOR NODES BELONGING TO NODE SET FIXED

       NODE FOOT-   U1          U2
            NOTE

         ALL VALUES IN THIS TABLE ARE ZERO

                        S T E P       4     S T E A D Y   S T A T E   A N A L Y S I S

   THE FOLLOWING TABLE IS PRINTED FOR ALL NODES

       NODE FOOT-   U1
            NOTE

          1   SSD  1.000
)");
    EXPECT_TRUE(opened.model->results().empty());
    const std::string texts = texts_of(opened, Code::UnknownBlock);
    EXPECT_THAT(texts, HasSubstr("SLAVE SURFACE A"));
    EXPECT_THAT(texts, HasSubstr("NODE SET FIXED\" (U1 U2) says that all its values are zero"));
    EXPECT_THAT(texts, HasSubstr("complex"));
    EXPECT_TRUE(opened.diagnostics->has(Code::EmptyResult));
}

TEST(PrintTables, need_a_mesh_whose_numbers_are_those_of_the_tables) {
    Diagnostics diagnostics;
    try {
        open_model(std::vector<NamedBytes>{{"job.dat", kStart + std::string(kNodes)}}, {}, diagnostics);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::NoNodes);
        EXPECT_THAT(error.what(), HasSubstr(".inp"));
    }
    const std::string part = std::string("*PART,NAME=P\n") + kPlate +
                             "*END PART\n*ASSEMBLY,NAME=A\n*INSTANCE,NAME=I,PART=P\n*END INSTANCE\n"
                             "*INSTANCE,NAME=J,PART=P\n5,0,0\n*END INSTANCE\n*END ASSEMBLY\n";
    try {
        open_printed(kNodes, part);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::MeshesDiffer);
    }
    const Opened other = open_printed("   THE FOLLOWING TABLE IS PRINTED FOR ALL NODES\n\n       NODE FOOT-  "
                                      " NT11\n            NOTE\n\n        77    1.0\n");
    load(other, "temperature");
    EXPECT_EQ(other.diagnostics->count(Code::ResultWithoutNode), 1U);
}

TEST(PrintTables, shipped_example_agrees_with_its_own_extremes) {
    Opened opened;
    const std::string job = test::project_file("tests/data/abaqus/column");
    opened.model = open_model(std::vector<std::string>{job + ".inp", job + ".dat"}, {}, *opened.diagnostics);
    ASSERT_EQ(opened.mesh().node_count(), 12U);
    EXPECT_EQ(opened.mesh().element_count(), 2U);
    EXPECT_EQ(opened.model->results().size(), 5U);
    for (std::size_t i = 0; i < opened.model->results().size(); ++i) opened.model->load(i);
    EXPECT_EQ(texts_of(opened, Code::ValuesDisagree), "");
    EXPECT_EQ(values_at(opened, load(opened, "displacement"), 23)[2], -0.08F);
    EXPECT_EQ(values_at(opened, load(opened, "reaction_force"), 4)[2], 0.5F);
    EXPECT_EQ(values_at(opened, load(opened, "mises"), 2)[0], 2);
}

TEST(PrintTables, any_damage_ends_in_a_model_or_an_error) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 500; ++i) {
        std::string bytes = kNodes;
        for (int flips = 0; flips < 4; ++flips)
            bytes[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
        if (i % 3 == 0) bytes.resize(random() % bytes.size());
        try {
            const Opened opened = open_printed(bytes);
            for (std::size_t r = 0; r < opened.model->results().size(); ++r) opened.model->load(r);
        } catch (const Error& error) {
            EXPECT_GT(std::string(error.what()).size(), 10U);
        }
    }
}

}  // namespace
}  // namespace feelem
