// SPDX-License-Identifier: Apache-2.0
// Stresses of small .op2 files of our own making.
#include "read_nastran_op2/op2_models.hpp"
#include "support/exercise.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace feelem {
namespace {

using namespace test;
using testing::ElementsAre;

TEST(Op2, stresses_of_solids_stand_at_their_corners) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OES1X1");
    const Op2Ident ident{.table_code = 5, .element_type = 39, .row_words = 109, .stress_bits = 1};
    writer.block(ident, solid_element(0));
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    ASSERT_THAT(names_of(*model), ElementsAre("stress"));
    EXPECT_THAT(model->results()[0].components, ElementsAre("xx", "yy", "zz", "xy", "yz", "zx", "von_mises"));
    const Result stress = model->load(0);
    EXPECT_EQ(stress.info.location, Location::ElementNodal);
    ASSERT_EQ(stress.row_count(), 4U);
    EXPECT_EQ(raw(stress.row_node[1]), 1U);
    const auto second = std::vector<float>(stress.values.begin() + 7, stress.values.begin() + 14);
    EXPECT_THAT(second, ElementsAre(21, 22, 23, 24, 25, 26, 27));
}

TEST(Op2, a_tensor_in_another_system_keeps_its_invariant_only) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OES1X1");
    const Op2Ident ident{.table_code = 5, .element_type = 39, .row_words = 109, .stress_bits = 1};
    writer.block(ident, solid_element(12));
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    const Result stress = model->load(0);
    EXPECT_TRUE(std::isnan(stress.values[0]));
    EXPECT_EQ(stress.values[6], 17);
    EXPECT_TRUE(diagnostics.has(Code::CoordinateSystem));
}

/// A shell row: number, centre, then grid and two fibres with distance, three stresses, angle, major, minor,
/// von Mises for the centre and each corner.
Op2Words shell_element() {
    Op2Words words{whole(91), std::string("CEN/")};
    for (const std::int64_t node : {3, 1, 2, 3}) {
        words.push_back(whole(node));
        for (const double side : {0.5, -0.5}) {  // The upper fibre first.
            for (const double value : {side, 0., 0., 0., 0., side * 10, side * 20, 40 + side})
                words.emplace_back(value);
        }
    }
    return words;
}

void write_shell(Op2Writer& writer) {
    writer.begin_table("GEOM1S");
    writer.record(joined(
        {{whole(4501), whole(45), whole(1)},
         grid(1, 0, 0, 0),
         grid(2, 1, 0, 0),
         grid(3, 0, 1, 0),
         grid(4, 1, 1, 0)}
    ));
    writer.end_table();
    writer.begin_table("GEOM2S");
    writer.record(
        {whole(4801),
         whole(48),
         whole(327),
         whole(9),
         whole(3),
         whole(1),
         whole(2),
         whole(3),
         whole(0),
         whole(0),
         whole(0),
         0.,
         0.,
         0.,
         0.,
         0.,
         whole(0)}
    );
    writer.record(
        {whole(5959),
         whole(59),
         whole(282),
         whole(10),
         whole(3),
         whole(2),
         whole(4),
         whole(3),
         0.,
         0.,
         whole(0),
         whole(0),
         whole(0),
         0.,
         0.,
         0.}
    );
    writer.record({whole(3001), whole(30), whole(48), whole(11), whole(4), whole(1), whole(4)});
    writer.record({whole(5201), whole(52), whole(11), whole(11), whole(1), whole(2)});
    writer.end_table();
}

TEST(Op2, layers_of_shells_go_by_the_fibres_distance) {
    Op2Writer writer;
    write_shell(writer);
    writer.begin_table("OES1X1");
    writer.block({.table_code = 5, .element_type = 75, .row_words = 70, .stress_bits = 1}, shell_element());
    Op2Words centre{whole(101)};
    for (const double side : {-1., 1.}) {
        for (const double value : {side, 0., 0., 0., 0., side * 3, side * 4, 7 + side})
            centre.emplace_back(value);
    }
    writer.block({.table_code = 5, .element_type = 74, .row_words = 17, .stress_bits = 1}, centre);
    writer.block(
        {.table_code = 5, .element_type = 1, .row_words = 5, .stress_bits = 1},
        {whole(111), 77., whole(1), 0., whole(1)}
    );
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    EXPECT_EQ(test::exercise(*model), "");
    EXPECT_EQ(model->mesh().skipped_elements.at("PLOTEL"), 1U);
    ASSERT_THAT(names_of(*model), ElementsAre("stress", "stress", "axial_stress"));
    EXPECT_EQ(model->results()[0].layer, Layer::Bottom);
    const Result bottom = model->load(0);
    // Three corners of the six-node triangle, and the other one's centre at each of its own.
    ASSERT_EQ(bottom.row_count(), 6U);
    for (std::size_t row = 0; row < 6; ++row) {
        const bool is_linear = raw(element_at(model->mesh(), ElementIndex{bottom.row_owner[row]}).id()) == 10;
        EXPECT_EQ(bottom.values[row * 3], is_linear ? 6.F : 39.5F);
        EXPECT_EQ(bottom.values[row * 3 + 1], is_linear ? -3.F : -5.F);
        EXPECT_EQ(bottom.values[row * 3 + 2], is_linear ? -4.F : -10.F);
    }
    EXPECT_EQ(model->load(1).values[0], 40.5F);
    const Result axial = model->load(2);
    EXPECT_EQ(std::ranges::count(axial.values, 77.F), 1);
}

}  // namespace
}  // namespace feelem
