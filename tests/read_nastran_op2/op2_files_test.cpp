// SPDX-License-Identifier: Apache-2.0
// .op2 files of our own making in every form that the format has, and damaged ones.
#include "read_nastran_op2/op2_models.hpp"
#include "support/exercise.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>

namespace feelem {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

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

TEST(Op2, grids_in_cylindrical_systems_stand_at_their_basic_places) {
    Op2Writer writer;
    writer.begin_table("GEOM1");
    writer.record(
        {whole(2001),
         whole(20),
         whole(9),
         whole(5),
         whole(2),
         whole(2),
         whole(0),
         1.,
         0.,
         0.,
         1.,
         0.,
         1.,
         2.,
         0.,
         0.}
    );
    writer.record(
        {whole(4501), whole(45), whole(1), whole(8), whole(5), 2., 90., 3., whole(0), whole(0), whole(0)}
    );
    writer.end_table();
    Diagnostics diagnostics;
    const auto model = open(writer.finish(), diagnostics);
    // Two from the axis through (1, 0, 0), at 90 degrees: along y.
    const Point3& place = model->mesh().coordinates[0];
    EXPECT_NEAR(place[0], 1, 1e-12);
    EXPECT_NEAR(place[1], 2, 1e-12);
    EXPECT_NEAR(place[2], 3, 1e-12);
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

TEST(Op2, results_of_grids_that_the_file_before_mostly_has_not_are_refused_with_counts) {
    Op2Writer foreign;
    foreign.begin_table("OUGV1");
    foreign.block({}, joined({row(4, 1), row(98, 1), row(99, 1)}));
    foreign.end_table();
    Diagnostics diagnostics;
    std::vector<NamedBytes> files{{"a.op2", static_file({})}, {"b.op2", foreign.finish()}};
    try {
        open_model(std::move(files), {}, diagnostics);
        FAIL() << "was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::MeshesDiffer);
        EXPECT_THAT(error.what(), HasSubstr("of its 3 grids the inputs before it, with 4 grids, have 1."));
    }
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
