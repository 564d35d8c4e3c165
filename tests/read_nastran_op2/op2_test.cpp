// SPDX-License-Identifier: Apache-2.0
// Steps and results at nodes of small .op2 files of our own making.
#include "read_nastran_op2/op2_models.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace feelem {
namespace {

using namespace test;
using testing::ElementsAre;

TEST(Op2, rows_sorted_by_node_are_found_by_their_step) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OUGV2");
    for (std::int64_t id = 1; id <= 4; ++id) {
        Op2Words data;
        for (const double time : {0.5, 1.5}) {
            // Nodes may lack steps, the first one, too.
            if ((id == 3 && time == 0.5) || (id == 1 && time == 1.5)) continue;
            Op2Words one = row(id, time);
            one[0] = time;
            data = joined({data, one});
        }
        writer.block({.approach = 6, .table_code = 2001, .word5 = whole(id * 10 + 1)}, data);
    }
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    ASSERT_EQ(model->steps().size(), 2U);
    EXPECT_EQ(model->steps()[1].value, 1.5);
    EXPECT_EQ(model->steps()[1].substep, 2);
    EXPECT_EQ(model->steps()[1].kind, StepKind::Time);
    ASSERT_THAT(names_of(*model), ElementsAre("displacement", "rotation", "displacement", "rotation"));
    const Result first = model->load(0);
    EXPECT_EQ(first.values[3], static_cast<float>(2.1 * 0.5));
    EXPECT_TRUE(std::isnan(first.values[6]));
    EXPECT_EQ(model->load(2).values[8], static_cast<float>(3.3 * 1.5));
}

TEST(Op2, complex_rows_are_two_results) {
    for (const int format : {2, 3}) {
        Op2Writer writer;
        write_geometry(writer);
        writer.begin_table("OUGV1");
        const Op2Ident ident{
            .approach = 5, .table_code = 1010, .word5 = 20.0, .format = format, .row_words = 14};
        writer.block(ident, complex_row(2));
        writer.end_table();
        Diagnostics diagnostics;
        const auto model = open(writer.finish(), diagnostics);
        ASSERT_THAT(
            names_of(*model), ElementsAre("velocity", "velocity", "angular_velocity", "angular_velocity")
        );
        const auto infos = model->results();
        EXPECT_EQ(infos[0].complex, format == 2 ? Complex::Real : Complex::Amplitude);
        EXPECT_EQ(infos[1].complex, format == 2 ? Complex::Imaginary : Complex::Phase);
        EXPECT_EQ(model->steps()[0].kind, StepKind::Frequency);
        EXPECT_EQ(model->steps()[0].value, 20);
        EXPECT_EQ(model->load(0).values[3], 1);
        EXPECT_EQ(model->load(1).values[5], 9);
        EXPECT_EQ(model->load(2).values[3], 4);
        EXPECT_EQ(model->load(3).values[5], 12);
        EXPECT_TRUE(diagnostics.has(Code::ResultForPartOfModel));
    }
}

TEST(Op2, motion_systems_turn_displacements_but_not_those_of_basic_tables) {
    Op2Writer writer;
    write_geometry(writer, 5);
    for (const char* table : {"OUGV1", "BOUGV1"}) {
        writer.begin_table(table);
        writer.block({}, rows(1));
        writer.end_table();
    }
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    // At (0, 1, 0) the radial axis is the basic y: turned by 90 degrees about z.
    ASSERT_EQ(model->mesh().node_angles.size(), 4U);
    EXPECT_NEAR(model->mesh().node_angles[2][0], 90, 1e-12);
    ASSERT_THAT(
        names_of(*model), ElementsAre("displacement", "rotation", "displacement_bougv1", "rotation_bougv1")
    );
    EXPECT_TRUE(model->results()[0].nodal_system);
    EXPECT_FALSE(model->results()[2].nodal_system);
}

TEST(Op2, modes_carry_their_number_and_frequency_and_the_preload_is_substep_0) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OUGV1");
    writer.block({.subcase = 2, .label = "PRELOAD"}, rows(1));
    const double omega = 2 * 3.14159265358979 * 50;
    for (std::int64_t mode = 1; mode <= 2; ++mode) {
        const double eigenvalue = omega * omega * static_cast<double>(mode * mode);
        writer.block(
            {.approach = 2, .table_code = 7, .subcase = 2, .word5 = whole(mode), .word6 = eigenvalue}, rows(1)
        );
    }
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    const auto steps = model->steps();
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps[0].step, 2);
    EXPECT_EQ(steps[0].substep, 0);
    EXPECT_EQ(steps[0].label, "PRELOAD");
    EXPECT_EQ(steps[1].substep, 1);
    EXPECT_EQ(steps[2].kind, StepKind::Mode);
    EXPECT_NEAR(steps[2].value, 100, 1e-4);
    EXPECT_EQ(steps[2].label, "mode 2");
}

TEST(Op2, what_stands_by_step_and_by_node_is_listed_once) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OUGV2");
    for (std::int64_t id = 1; id <= 4; ++id) {
        Op2Words data = row(id, 1);
        data[0] = 2.5;
        writer.block({.approach = 6, .table_code = 2001, .word5 = whole(id * 10 + 1)}, data);
    }
    writer.end_table();
    writer.begin_table("OUGV1");
    writer.block({.approach = 6, .word5 = 2.5}, rows(1));
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    ASSERT_THAT(names_of(*model), ElementsAre("displacement", "rotation"));
    EXPECT_EQ(model->results()[0].solver_name, "OUGV1");
    EXPECT_TRUE(diagnostics.has(Code::UnknownBlock));
}

TEST(Op2, frequencies_of_modes_sorted_by_node_are_those_of_the_table_of_eigenvalues) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("LAMA");
    writer.block(
        {.approach = 2, .table_code = 6, .subcase = 0, .format = 0, .row_words = 7},
        {whole(1), whole(1), 4., 2., 0.318, 1., 4., whole(2), whole(2), 9., 3., 0.477, 1., 9.}
    );
    writer.end_table();
    writer.begin_table("OUGV2");
    Op2Words data = joined({row(1, 1), row(1, 2)});
    data[0] = whole(1);
    data[8] = whole(2);
    writer.block({.approach = 2, .table_code = 2007, .word5 = whole(11)}, data);
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    ASSERT_EQ(model->steps().size(), 2U);
    EXPECT_FLOAT_EQ(static_cast<float>(model->steps()[1].value), 0.477F);
    EXPECT_EQ(model->load(2).values[0], static_cast<float>(1.1 * 2));
}

TEST(Op2, heat_transfer_gives_temperatures) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OUGV1");
    writer.block({.thermal = 1}, rows(1));
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    ASSERT_THAT(names_of(*model), ElementsAre("temperature"));
    EXPECT_EQ(model->results()[0].shape, Shape::Scalar);
    EXPECT_THAT(model->load(0).values, ElementsAre(1.1F, 2.1F, 3.1F, 4.1F));
}

TEST(Op2, rows_that_do_not_fill_the_record_are_an_error_when_loaded) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OUGV1");
    writer.block({}, joined({rows(1), {whole(1)}}));
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    EXPECT_THROW(model->load(0), Error);
}

}  // namespace
}  // namespace feelem
