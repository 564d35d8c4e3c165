// SPDX-License-Identifier: Apache-2.0
// Small .op2 files of our own making, in every form that the format has.
#include "read_nastran_op2/op2_writer.hpp"
#include "support/exercise.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace feelem {
namespace {

using test::joined;
using test::Op2Form;
using test::Op2Ident;
using test::Op2Word;
using test::Op2Words;
using test::Op2Writer;
using test::WideReal;
using testing::ElementsAre;
using testing::HasSubstr;

Op2Word whole(std::int64_t value) {
    return value;
}

/// A GRID of eight words.
Op2Words grid(std::int64_t id, double x, double y, double z, std::int64_t motion = 0) {
    return {whole(id), whole(0), x, y, z, whole(motion), whole(0), whole(0)};
}

/// A tetrahedron 7 of grids 1 to 4 with unit edges, property 3; grid 4 moves in cylindrical system 5.
void write_geometry(Op2Writer& writer, std::int64_t motion = 0) {
    writer.begin_table("GEOM1S");
    if (motion != 0) {
        writer.record(
            {whole(2001),
             whole(20),
             whole(9),
             whole(motion),
             whole(2),
             whole(2),
             whole(0),
             0.,
             0.,
             0.,
             0.,
             0.,
             1.,
             1.,
             0.,
             0.}
        );
    }
    writer.record(joined(
        {{whole(4501), whole(45), whole(1)},
         grid(1, 0, 0, 0),
         grid(2, 1, 0, 0),
         grid(3, 0, 1, 0, motion),
         grid(4, 0, 0, 1)}
    ));
    writer.record({whole(65535), whole(65535), whole(65535)});
    writer.end_table();
    writer.begin_table("GEOM2S");
    writer.record(
        {whole(5508),
         whole(55),
         whole(217),
         whole(7),
         whole(3),
         whole(1),
         whole(2),
         whole(3),
         whole(4),
         whole(0),
         whole(0),
         whole(0),
         whole(0),
         whole(0),
         whole(0)}
    );
    writer.record(joined(
        {{whole(601), whole(6), whole(73)}, {whole(8), whole(1), whole(1), whole(2), whole(1), whole(1)}}
    ));
    writer.end_table();
}

/// A row of a nodal table: translations id + 0.1, 0.2, 0.3 times scale, rotations the same negated.
Op2Words row(std::int64_t id, double scale) {
    const double base = static_cast<double>(id);
    return {
        whole(id * 10 + 1),
        whole(1),
        (base + 0.1) * scale,
        (base + 0.2) * scale,
        (base + 0.3) * scale,
        -(base + 0.1) * scale,
        -(base + 0.2) * scale,
        -(base + 0.3) * scale};
}
Op2Words rows(double scale) {
    return joined({row(1, scale), row(2, scale), row(3, scale), row(4, scale)});
}

std::unique_ptr<ModelSource> open(std::string bytes, Diagnostics& diagnostics) {
    std::vector<NamedBytes> files{{"model.op2", std::move(bytes)}};
    return open_model(std::move(files), {}, diagnostics);
}

std::vector<std::string> names_of(const ModelSource& model) {
    std::vector<std::string> names;
    for (const ResultInfo& info : model.results()) names.push_back(info.name);
    return names;
}

std::string static_file(Op2Form form) {
    Op2Writer writer(form);
    writer.head("NX12");
    write_geometry(writer);
    writer.begin_table("OUGV1");
    writer.block({}, rows(1));
    writer.end_table();
    return writer.finish();
}

TEST(Op2, every_word_size_and_byte_order_gives_the_same_model) {
    for (const Op2Form form : {Op2Form{4, false}, Op2Form{4, true}, Op2Form{8, false}, Op2Form{8, true}}) {
        SCOPED_TRACE(std::to_string(form.word) + (form.big_endian ? " big" : " little"));
        Diagnostics diagnostics;
        const auto model = open(static_file(form), diagnostics);
        EXPECT_EQ(test::exercise(*model), "");
        EXPECT_EQ(model->solver().name, "NX Nastran");
        EXPECT_EQ(model->solver().version, "12");
        EXPECT_EQ(model->title(), "A TITLE");
        const Mesh& mesh = model->mesh();
        ASSERT_EQ(mesh.node_count(), 4U);
        EXPECT_THAT(mesh.coordinates[2], ElementsAre(0, 1, 0));
        ASSERT_EQ(mesh.blocks.size(), 1U);
        EXPECT_EQ(mesh.blocks[0].type, ElementType::Tet4);
        EXPECT_EQ(mesh.parts[0].name, "property 3");
        EXPECT_EQ(mesh.skipped_elements.at("CELAS1"), 1U);
        ASSERT_THAT(names_of(*model), ElementsAre("displacement", "rotation"));
        EXPECT_THAT(
            model->load(0).values,
            ElementsAre(1.1F, 1.2F, 1.3F, 2.1F, 2.2F, 2.3F, 3.1F, 3.2F, 3.3F, 4.1F, 4.2F, 4.3F)
        );
        EXPECT_EQ(model->load(1).values[11], -4.3F);
        EXPECT_FALSE(model->results()[0].nodal_system);
    }
}

TEST(Op2, rows_sorted_by_node_are_found_by_their_step) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OUGV2");
    for (std::int64_t id = 1; id <= 4; ++id) {
        Op2Words data;
        for (const double time : {0.5, 1.5}) {
            if (id == 3 && time == 0.5) continue;  // A node may lack a step.
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

/// Two halves of six numbers after the id.
Op2Words complex_row(std::int64_t id) {
    Op2Words out{whole(id * 10), whole(1)};
    for (int i = 1; i <= 12; ++i) out.emplace_back(static_cast<double>(i));
    return out;
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

TEST(Op2, a_record_in_pieces_is_put_together_even_within_a_row) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OUGV1");
    writer.block({}, rows(2), 5);
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    EXPECT_EQ(model->load(0).values[11], static_cast<float>(4.3 * 2));
}

TEST(Op2, grids_in_double_precision_keep_all_digits) {
    Op2Writer writer;
    writer.begin_table("GEOM1");
    writer.record(
        {whole(4501),
         whole(45),
         whole(1120001),
         whole(9),
         whole(0),
         WideReal{0.1},
         WideReal{1e-30},
         WideReal{123456.789012345},
         whole(0),
         whole(0),
         whole(0)}
    );
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    EXPECT_THAT(model->mesh().coordinates[0], ElementsAre(0.1, 1e-30, 123456.789012345));
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

TEST(Op2, without_geometry_the_nodes_of_the_results_have_no_place) {
    Op2Writer writer;
    writer.begin_table("OUGV1");
    writer.block({}, rows(1));
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    ASSERT_EQ(model->mesh().node_count(), 4U);
    EXPECT_TRUE(std::isnan(model->mesh().coordinates[0][0]));
    EXPECT_EQ(model->load(0).values[11], 4.3F);
}

TEST(Op2, results_alone_take_the_mesh_of_the_file_before_them) {
    Op2Writer alone;
    alone.begin_table("OUGV1");
    alone.block({}, joined({row(4, 1), row(99, 1)}));
    alone.end_table();
    Diagnostics diagnostics;
    std::vector<NamedBytes> files{{"a.op2", static_file({})}, {"b.op2", alone.finish()}};
    const auto model = open_model(std::move(files), {}, diagnostics);
    ASSERT_EQ(model->results().size(), 4U);
    EXPECT_EQ(model->load(2).values[11], 4.3F);
    EXPECT_TRUE(std::isnan(model->load(2).values[0]));
    EXPECT_EQ(diagnostics.count(Code::ResultWithoutNode), 1U);
}

TEST(Op2, a_grid_that_stands_elsewhere_than_in_the_file_before_is_an_error) {
    Op2Writer other;
    other.begin_table("GEOM1");
    other.record(joined({{whole(4501), whole(45), whole(1)}, grid(2, 1.5, 0, 0)}));
    other.end_table();
    Diagnostics diagnostics;
    std::vector<NamedBytes> files{{"a.op2", static_file({})}, {"b.op2", other.finish()}};
    try {
        open_model(std::move(files), {}, diagnostics);
        FAIL() << "was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::MeshesDiffer);
        EXPECT_THAT(error.what(), HasSubstr("grid 2"));
    }
}

TEST(Op2, an_element_of_other_nodes_than_in_the_file_before_is_an_error) {
    Op2Writer changed;
    changed.begin_table("GEOM1");
    changed.record(joined(
        {{whole(4501), whole(45), whole(1)},
         grid(1, 0, 0, 0),
         grid(2, 1, 0, 0),
         grid(3, 0, 1, 0),
         grid(4, 0, 0, 1)}
    ));
    changed.end_table();
    changed.begin_table("GEOM2");
    changed.record(
        {whole(5508),
         whole(55),
         whole(217),
         whole(7),
         whole(3),
         whole(2),
         whole(1),
         whole(4),
         whole(3),
         whole(0),
         whole(0),
         whole(0),
         whole(0),
         whole(0),
         whole(0)}
    );
    changed.end_table();
    Diagnostics diagnostics;
    std::vector<NamedBytes> files{{"a.op2", static_file({})}, {"b.op2", changed.finish()}};
    EXPECT_THROW(open_model(std::move(files), {}, diagnostics), Error);
}

TEST(Op2, a_cut_file_gives_the_tables_before_the_cut) {
    const std::string whole_file = static_file({});
    Op2Writer shorter;
    shorter.head("NX12");
    write_geometry(shorter);
    const std::size_t geometry = shorter.finish().size();
    Diagnostics diagnostics;
    const auto model = open(whole_file.substr(0, geometry + 400), diagnostics);
    EXPECT_EQ(model->mesh().element_count(), 1U);
    EXPECT_TRUE(model->results().empty());
    EXPECT_TRUE(diagnostics.has(Code::TruncatedInput));
}

TEST(Op2, a_matrix_is_stepped_over) {
    Op2Writer writer;
    writer.begin_table("KGG");
    writer.matrix_column({1.0, 2.0});
    writer.matrix_column({3.0, 4.0});
    writer.end_table();
    write_geometry(writer);
    Diagnostics diagnostics;
    EXPECT_EQ(open(writer.finish(), diagnostics)->mesh().node_count(), 4U);
    EXPECT_FALSE(diagnostics.has(Code::TruncatedInput));
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

/// A point of a solid: xx yy zz are base + 1, 2, 3, shears base + 4, 5, 6, von Mises base + 7.
Op2Words solid_point(std::int64_t node, double base) {
    return {whole(node), base + 1, base + 4, 0., 0.,       0.,       0., 0., base + 7, base + 2, base + 5,
            0.,          0.,       0.,       0., base + 3, base + 6, 0., 0., 0.,       0.};
}

Op2Words solid_element(std::int64_t system) {
    Op2Words words = joined({{whole(71), whole(system), std::string("GRID"), whole(4)}, solid_point(0, 0)});
    for (const std::int64_t node : {4, 3, 2, 1})
        words = joined({words, solid_point(node, static_cast<double>(10 * node))});
    return words;
}

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
                words.push_back(value);
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
            centre.push_back(value);
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

/// A bit of everything: for other tests that need a file without the corpus.
std::string shipped_file() {
    Op2Writer writer;
    writer.head("XXXXXXXX");
    write_geometry(writer, 5);
    writer.begin_table("OUGV1");
    writer.block({.label = "STATIC"}, rows(1));
    writer.block({.approach = 2, .table_code = 7, .word5 = whole(1), .word6 = 4000.}, rows(0.5), 7);
    writer.end_table();
    writer.begin_table("OES1X1");
    writer.block({.table_code = 5, .element_type = 39, .row_words = 109, .stress_bits = 1}, solid_element(0));
    writer.end_table();
    writer.begin_table("OUGV2");
    for (std::int64_t id = 1; id <= 2; ++id) {
        const Op2Ident ident{
            .approach = 5,
            .table_code = 3001,
            .subcase = 2,
            .word5 = whole(id * 10 + 1),
            .format = 2,
            .row_words = 14};
        Op2Words first = complex_row(id), second = complex_row(id);
        first[0] = 10.;
        second[0] = 20.;
        writer.block(ident, joined({first, second}));
    }
    writer.end_table();
    return writer.finish();
}

TEST(Op2, shipped_file_is_whole_and_of_our_own_making) {
    const std::string path = test::project_file("tests/data/nastran/tetrahedron.op2");
    if (std::getenv("FEELEM_UPDATE_GOLDEN") != nullptr) test::write_file(path, shipped_file());
    const std::string bytes = test::read_file(path);
    EXPECT_EQ(bytes, shipped_file());
    Diagnostics diagnostics;
    const auto model = open(bytes, diagnostics);
    EXPECT_EQ(test::exercise(*model), "");
    EXPECT_EQ(model->steps().size(), 4U);
    EXPECT_EQ(model->results().size(), 2U + 2U + 1U + 8U);
}

TEST(Op2, a_file_may_end_at_every_byte) {
    const std::string bytes = shipped_file();
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        Diagnostics diagnostics;
        try {
            EXPECT_EQ(test::exercise(*open(bytes.substr(0, length), diagnostics)), "") << length;
        } catch (const Error& error) {
            EXPECT_STRNE(error.what(), "") << length;
        }
    }
}

TEST(Op2, blocks_that_are_not_used_are_counted) {
    Op2Writer writer;
    write_geometry(writer);
    writer.begin_table("OEF1X");
    writer.block({.table_code = 4, .element_type = 1, .row_words = 3}, {whole(71), 1., 2.});
    writer.block({.table_code = 4, .element_type = 2, .row_words = 3}, {whole(71), 1., 2.});
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    EXPECT_TRUE(model->results().empty());
    EXPECT_EQ(diagnostics.count(Code::UnknownBlock), 2U);
}

}  // namespace
}  // namespace feelem
