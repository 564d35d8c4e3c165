// SPDX-License-Identifier: Apache-2.0
// Real lists of the team's corpus, with the counts and extremes that its ORIGINS.md says. Skipped where there
// is no corpus.
#include "read_ansys/opened_lists.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace feelem {
namespace {

using test::extremes;
using test::load_only;
using test::open_files;
using test::ValueExtremes;
using testing::ElementsAre;

class CorpusLists : public testing::Test {
protected:
    static std::string path(const std::string& name) {
        const auto found = test::corpus_file(name);
        return found ? *found : std::string();
    }
    void SetUp() override {
        if (!test::corpus_file("ansys/lists")) GTEST_SKIP() << "no corpus beside the project";
    }
};

void expect_block(const Mesh& mesh, std::size_t index, ElementType type, std::size_t count) {
    ASSERT_LT(index, mesh.blocks.size());
    EXPECT_EQ(mesh.blocks[index].type, type);
    EXPECT_EQ(mesh.blocks[index].ids.size(), count);
}

TEST_F(CorpusLists, gem_has_two_materials_of_tetrahedra_and_a_potential) {
    auto opened = open_files({path("ansys/lists/garfield-gem")}, "1=SOLID123");
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 14066u);
    ASSERT_EQ(mesh.blocks.size(), 1u);
    expect_block(mesh, 0, ElementType::Tet10, 8758);
    std::array<std::size_t, 2> of_part{};
    for (const PartIndex part : mesh.blocks[0].parts) ++of_part.at(raw(part));
    EXPECT_EQ(mesh.parts[0].name, "material 3");
    EXPECT_EQ(of_part[0], 5589u);
    EXPECT_EQ(of_part[1], 3169u);
    EXPECT_EQ(mesh.coordinates[5], (Point3{0.035, 0.12124355653, -0.025}));
    const ValueExtremes volt = extremes(mesh, load_only(opened, "electric_potential"), "value");
    EXPECT_EQ(volt.min, -200);
    EXPECT_EQ(volt.min_id, 25);
    EXPECT_EQ(volt.max, 350);
    EXPECT_EQ(volt.max_id, 30);
    EXPECT_EQ(volt.valid, 14066u);
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownBlock), 1u) << "MPLIST";
    EXPECT_FALSE(opened.diagnostics->has(Code::GuessedElementType));
}

TEST_F(CorpusLists, strip_is_found_to_be_of_eight_node_quads) {
    auto opened = open_files({path("ansys/lists/garfield-strip2d")});
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 1782u);
    expect_block(mesh, 0, ElementType::Quad8, 555);
    EXPECT_EQ(opened.diagnostics->count(Code::GuessedElementType), 555u);
    const ValueExtremes volt = extremes(mesh, load_only(opened, "electric_potential"), "value");
    EXPECT_EQ(volt.min, 0);
    EXPECT_EQ(volt.max, 1000);
    EXPECT_EQ(volt.max_id, 4);
    EXPECT_EQ(volt.valid, 1782u);
}

TEST_F(CorpusLists, blade_has_quads_and_five_digits) {
    const auto opened = open_files({path("ansys/lists/blade-plane-quad4")}, "3=PLANE182");
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 515u);
    expect_block(mesh, 0, ElementType::Quad4, 408);
    EXPECT_TRUE(mesh.node_angles.empty());
    EXPECT_TRUE(opened.diagnostics->has(Code::LowPrecision));
}

TEST_F(CorpusLists, truss_files_without_suffix_are_recognised) {
    auto opened = open_files({path("ansys/lists/truss3-link180")}, "1=LINK180");
    const Mesh& mesh = opened.model->mesh();
    expect_block(mesh, 0, ElementType::Line2, 3);
    const Result u = load_only(opened, "displacement");
    EXPECT_EQ(test::value_at(mesh, u, "z", 2), -0.45981F);
    EXPECT_EQ(test::value_at(mesh, u, "magnitude", 2), 0.48106F);
    const Result stress = load_only(opened, "stress");
    EXPECT_EQ(stress.info.location, Location::ElementNodal);
    EXPECT_EQ(stress.row_count(), 6u);
    EXPECT_EQ(extremes(mesh, stress, "xx").min, -2e10F);
    EXPECT_EQ(extremes(mesh, stress, "xx").max, 1.7321e10F);
    EXPECT_EQ(extremes(mesh, load_only(opened, "elastic_strain"), "xx").max, 0.086603F);
}

TEST_F(CorpusLists, columns_that_run_together_come_apart) {
    auto opened = open_files({path("ansys/lists/excerpts/plane182_prnsol_s_run_together.txt")});
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 12u);
    const Result stress = load_only(opened, "stress");
    const ValueExtremes xx = extremes(mesh, stress, "xx");
    EXPECT_EQ(xx.max, 7.414e6F);
    EXPECT_EQ(xx.max_id, 1);
    EXPECT_EQ(xx.min, -7.6372e6F);
    EXPECT_EQ(xx.min_id, 7);
    EXPECT_EQ(extremes(mesh, stress, "yy").min, -0.7414e6F);
    EXPECT_EQ(extremes(mesh, stress, "yy").min_id, 12);
}

TEST_F(CorpusLists, one_component_of_a_displacement_is_read) {
    auto opened = open_files({path("ansys/lists/excerpts/plane182_prnsol_u_y.txt")});
    const Result u = load_only(opened, "displacement");
    EXPECT_THAT(u.info.components, ElementsAre("y"));
    EXPECT_EQ(extremes(opened.model->mesh(), u, "y").max, 0.16174e-2F);
    EXPECT_EQ(extremes(opened.model->mesh(), u, "y").max_id, 7);
}

TEST_F(CorpusLists, shell_results_have_a_top_and_a_bottom) {
    auto opened = open_files({path("ansys/lists/excerpts/shell181_presol_prnsol.txt")});
    const Mesh& mesh = opened.model->mesh();
    expect_block(mesh, 0, ElementType::Quad4, 1);
    ASSERT_EQ(opened.model->results().size(), 4u);
    const Result top = opened.model->load(0);
    const Result bottom = opened.model->load(1);
    EXPECT_EQ(top.info.location, Location::ElementNodal);
    EXPECT_EQ(top.info.layer, Layer::Top);
    EXPECT_EQ(extremes(mesh, top, "yy").max, 91.212F);
    EXPECT_EQ(bottom.info.layer, Layer::Bottom);
    EXPECT_EQ(extremes(mesh, bottom, "yy").min, -91.213F);
    const Result averaged = opened.model->load(3);
    EXPECT_EQ(averaged.info.location, Location::PartNodal);
    EXPECT_EQ(averaged.info.layer, Layer::Bottom);
    EXPECT_EQ(extremes(mesh, averaged, "yy").min, -91.213F);
    EXPECT_EQ(extremes(mesh, averaged, "yy").valid, 4u);
    // The list has no coordinates, so nothing can be drawn.
    EXPECT_TRUE(opened.diagnostics->has(Code::NotAMesh));
}

TEST_F(CorpusLists, modal_stress_has_its_frequency) {
    auto opened = open_files({path("ansys/lists/excerpts/solid187_presol_s_freq.txt")});
    EXPECT_EQ(opened.model->steps()[0].kind, StepKind::Frequency);
    EXPECT_EQ(opened.model->steps()[0].value, 47.852);
    const Result stress = load_only(opened, "stress");
    EXPECT_EQ(extremes(opened.model->mesh(), stress, "xx").max, 59613);
    EXPECT_EQ(extremes(opened.model->mesh(), stress, "xx").max_id, 7614);
}

TEST_F(CorpusLists, elements_without_nodes_are_refused) {
    try {
        open_files({path("ansys/lists/excerpts/shell281_elist_slist_mplist_crlf.txt")});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::NotAMesh);
    }
}

TEST_F(CorpusLists, headless_lists_are_named_by_their_title) {
    auto opened = open_files(
        {path("ansys/rst/hexbeam_v150/prnsol_s.txt"),
         path("ansys/rst/hexbeam_v150/prnsol_s_prin.txt"),
         path("ansys/rst/hexbeam_v150/prnsol_u.txt")}
    );
    const Mesh& mesh = opened.model->mesh();
    const ValueExtremes magnitude = extremes(mesh, load_only(opened, "displacement"), "magnitude");
    EXPECT_EQ(magnitude.valid, 321u);
    EXPECT_EQ(magnitude.max, 47.41259499F);
    EXPECT_EQ(magnitude.max_id, 2);
    EXPECT_EQ(extremes(mesh, load_only(opened, "displacement"), "x").min, -0.1957718340E+02F);
    EXPECT_EQ(extremes(mesh, load_only(opened, "displacement"), "x").min_id, 71);
    EXPECT_EQ(extremes(mesh, load_only(opened, "stress", "xx"), "xx").valid, 99u);
    EXPECT_EQ(extremes(mesh, load_only(opened, "stress", "von_mises"), "von_mises").valid, 99u);
}

TEST_F(CorpusLists, exports_of_two_cubes_keep_the_interface_of_both) {
    auto opened = open_files({path("ansys/workbench/two_cubes/stress_combined.txt")});
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 45u);
    EXPECT_EQ(mesh.length_unit->name, "mm");
    const Result stress = load_only(opened, "normal_stress");
    EXPECT_EQ(stress.info.location, Location::PartNodal);
    EXPECT_EQ(stress.info.unit, "MPa");
    EXPECT_EQ(stress.row_count(), 54u);

    auto one = open_files({path("ansys/workbench/two_cubes/stress_mat_1.txt")});
    const Result alone = load_only(one, "normal_stress");
    EXPECT_EQ(alone.info.location, Location::Nodal);
    EXPECT_EQ(alone.row_count(), 27u);
    // The second body of the combined table is material 1.
    std::size_t at = 0;
    for (std::size_t row = 0; row < stress.row_count(); ++row) {
        if (stress.row_owner[row] != 1) continue;
        EXPECT_EQ(mesh.node_ids[raw(stress.row_node[row])], one.model->mesh().node_ids[at]);
        EXPECT_EQ(stress.values[row], alone.values[at]);
        ++at;
    }
    EXPECT_EQ(at, 27u);
}

TEST_F(CorpusLists, exports_of_every_kind_have_their_rows) {
    const struct {
        const char* file;
        const char* result;
        std::uint64_t rows;
    } rows[] = {
        {"two_cubes/stress_mat_2.txt", "normal_stress", 27},
        {"two_cubes/elastic_strain_combined.txt", "normal_elastic_strain", 54},
        {"two_cubes/elastic_strain_mat_1.txt", "normal_elastic_strain", 27},
        {"two_cubes/elastic_strain_mat_2.txt", "normal_elastic_strain", 27},
        {"extract_shell_layer/stress_bot_nodal_combined.txt", "normal_stress", 80},
        {"extract_shell_layer/stress_bot_nodal_mat_1.txt", "normal_stress", 64},
        {"extract_shell_layer/stress_bot_nodal_mat_2.txt", "normal_stress", 16},
        {"extract_shell_layer/stress_top_nodal_combined.txt", "normal_stress", 80},
        {"extract_shell_layer/stress_top_nodal_mat_1.txt", "normal_stress", 64},
        {"extract_shell_layer/stress_top_nodal_mat_2.txt", "normal_stress", 16},
        {"taxim-dome/dome_dz_x.txt", "directional_deformation", 15230},
        {"taxim-dome/dome_dz_y.txt", "directional_deformation", 15230},
        {"taxim-dome/dome_dz_z.txt", "directional_deformation", 15230},
    };
    for (const auto& row : rows) {
        auto opened = open_files({path(std::string("ansys/workbench/") + row.file)});
        const Result result = load_only(opened, row.result);
        EXPECT_EQ(extremes(opened.model->mesh(), result, "value").valid, row.rows) << row.file;
    }
}

TEST_F(CorpusLists, element_exports_alone_say_what_is_missing) {
    for (const char* side : {"top", "bot"}) {
        try {
            open_files({path(
                std::string("ansys/workbench/extract_shell_layer/stress_") + side + "_elemental_combined.txt"
            )});
            FAIL() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Code::NoElements);
        }
    }
}

TEST_F(CorpusLists, boiler_hex_small_has_wedges_and_eight_transient_steps_elsewhere) {
    auto opened = open_files({path("boiler/as-lists/hex_small")});
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 8907u);
    expect_block(mesh, 0, ElementType::Hex20, 1248);
    expect_block(mesh, 1, ElementType::Wedge15, 24);
    const ValueExtremes temperature = extremes(mesh, load_only(opened, "temperature"), "value");
    EXPECT_EQ(temperature.min, 123.39F);
    EXPECT_EQ(temperature.min_id, 4565);
    EXPECT_EQ(temperature.max, 224.41F);
    EXPECT_EQ(temperature.max_id, 206);
    EXPECT_TRUE(load_only(opened, "stress").info.corner_only);
    EXPECT_EQ(extremes(mesh, load_only(opened, "displacement"), "magnitude").max, 4.6372F);

    auto transient = open_files({path("boiler/as-lists/hex_linear/PRNSOL_TEMP_transient.lis")});
    ASSERT_EQ(transient.model->steps().size(), 8u);
    EXPECT_EQ(transient.model->steps()[7].value, 720);
    EXPECT_EQ(transient.model->steps()[7].kind, StepKind::Time);
    EXPECT_EQ(transient.model->results().size(), 8u);
}

}  // namespace
}  // namespace feelem
