// SPDX-License-Identifier: Apache-2.0
// Steps and nodal results of small SYNTHETIC result files.
#include "read_ansys_rst/opened_rst.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"
#include "feelem/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace feelem {
namespace {

using test::load_wanted;
using test::open_written;
using test::OpenedRst;
using test::value_at;
using test::WrittenModel;
using test::WrittenSet;
using testing::ElementsAre;

/// Row k (from 0) of the solution holds k + 1 in the first column, 100 times that in the second and so on.
WrittenSet plain_set(const WrittenModel& model) {
    WrittenSet set;
    for (std::size_t row = 0; row < model.storage.size(); ++row) {
        double value = static_cast<double>(row) + 1;
        for (std::size_t c = 0; c < model.dofs.size(); ++c, value *= 100) set.solution.push_back(value);
    }
    return set;
}

WrittenModel with_set() {
    WrittenModel model = test::two_bricks();
    model.sets.push_back(plain_set(model));
    return model;
}

TEST(RstMesh, nodes_elements_and_materials_come_out) {
    const OpenedRst opened = open_written(with_set());
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 12u);
    EXPECT_EQ(mesh.coordinates[raw(find_node(mesh, NodeId{120}))], (Point3{2, 1, 1}));
    ASSERT_EQ(mesh.blocks.size(), 1u);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Hex8);
    EXPECT_THAT(mesh.blocks[0].ids, ElementsAre(ElementId{7}, ElementId{8}));
    ASSERT_EQ(mesh.parts.size(), 2u);
    EXPECT_EQ(mesh.parts[0].name, "material 1");
    EXPECT_EQ(mesh.parts[1].name, "material 2");
    EXPECT_FALSE(mesh.length_unit);
    EXPECT_EQ(opened.model->solver().name, "Ansys");
    EXPECT_EQ(opened.model->solver().version, "25.2");
    EXPECT_EQ(opened.model->title(), "SYNTHETIC");
}

TEST(RstMesh, latin_1_title_becomes_utf_8) {
    WrittenModel model = with_set();
    model.title = "Kessel f\xFCr 3 bar";
    EXPECT_EQ(open_written(model).model->title(), "Kessel f\xC3\xBCr 3 bar");
    model.title = "Kessel f\xC3\xBCr 3 bar";
    EXPECT_EQ(open_written(model).model->title(), "Kessel f\xC3\xBCr 3 bar");
}

TEST(RstMesh, elements_without_surface_and_unknown_ones_are_counted) {
    WrittenModel model = with_set();
    model.types.push_back({174, 4, 0, 0});
    model.types.push_back({999, 4, 0, 0});
    model.elements.push_back({9, 2, 1, {10, 20, 50, 40}});
    model.elements.push_back({10, 3, 1, {10, 20, 50, 40}});
    model.elements.push_back({11, 4, 1, {10, 20, 50, 40}});
    const OpenedRst opened = open_written(model);
    const auto& skipped = opened.model->mesh().skipped_elements;
    EXPECT_EQ(skipped.at("CONTA174"), 1u);
    EXPECT_EQ(skipped.at("routine 999"), 1u);
    EXPECT_EQ(skipped.at("type 4"), 1u);
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownElementType), 2u);
}

TEST(RstMesh, components_become_sets_and_minus_ends_a_range) {
    WrittenModel model = with_set();
    model.components = {{"FIXED", true, {10, 30, -60, 120}}, {"RIGHT", false, {8}}};
    const OpenedRst opened = open_written(model);
    ASSERT_EQ(opened.model->mesh().node_sets.size(), 1u);
    EXPECT_EQ(opened.model->mesh().node_sets[0].name, "FIXED");
    EXPECT_EQ(opened.model->mesh().node_sets[0].nodes.size(), 6u);  // 10, 30 to 60 in tens, 120
    ASSERT_EQ(opened.model->mesh().element_sets.size(), 1u);
    EXPECT_THAT(opened.model->mesh().element_sets[0].elements, ElementsAre(ElementIndex{1}));
}

TEST(RstNodal, rows_go_to_the_nodes_of_the_storage_order) {
    const OpenedRst opened = open_written(with_set());
    ASSERT_EQ(opened.model->results().size(), 1u);
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_EQ(u.info.solver_name, "U");
    EXPECT_EQ(u.info.shape, Shape::Vector);
    EXPECT_FALSE(u.info.nodal_system);
    EXPECT_EQ(value_at(opened, u, 120, "x"), 1.0F);
    EXPECT_EQ(value_at(opened, u, 120, "y"), 100.0F);
    EXPECT_EQ(value_at(opened, u, 10, "x"), 12.0F);
    EXPECT_EQ(value_at(opened, u, 10, "z"), 120000.0F);
}

TEST(RstNodal, two_to_the_hundredth_is_missing_and_nan_is_reported) {
    WrittenModel model = with_set();
    model.sets[0].solution[0] = std::ldexp(1.0, 100);
    model.sets[0].solution[4] = std::nan("");
    model.sets[0].solution[5] = 1e39;  // Too large for a float, but also no such unknown.
    const OpenedRst opened = open_written(model);
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_TRUE(std::isnan(value_at(opened, u, 120, "x")));
    EXPECT_TRUE(std::isnan(value_at(opened, u, 110, "y")));
    EXPECT_TRUE(std::isnan(value_at(opened, u, 110, "z")));
    EXPECT_EQ(opened.diagnostics->count(Code::NonFiniteValue), 1u);
}

TEST(RstNodal, rows_of_some_nodes_go_where_the_list_behind_them_says) {
    WrittenModel model = with_set();
    model.sets[0].solution = {1, 2, 3, 4, 5, 6};
    model.sets[0].rows = {12, 2};
    const OpenedRst opened = open_written(model);
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_EQ(value_at(opened, u, 10, "x"), 1.0F);
    EXPECT_EQ(value_at(opened, u, 110, "z"), 6.0F);
    EXPECT_TRUE(std::isnan(value_at(opened, u, 120, "x")));
    model.sets[0].rows = {13, 2};
    EXPECT_THROW(load_wanted(open_written(model), {"displacement"}), Error);
}

TEST(RstNodal, every_unknown_of_every_physics_has_a_name) {
    WrittenModel model = test::two_bricks();
    model.dofs = {1, 2, 4, 5, 6, 9, 19, 20, 21, 22, 33, 34, 64, 27, 77};
    model.sets.push_back(plain_set(model));
    const OpenedRst opened = open_written(model);
    std::vector<std::string> names;
    for (const ResultInfo& info : opened.model->results()) names.push_back(info.name);
    EXPECT_THAT(
        names,
        ElementsAre(
            "displacement",
            "rotation",
            "magnetic_vector_potential",
            "pressure",
            "temperature",
            "electric_potential",
            "magnetic_scalar_potential",
            "temperature",
            "te2",
            "temperature",
            "sp01",
            "dof77"
        )
    );
    EXPECT_THAT(opened.model->results()[0].components, ElementsAre("x", "y"));
    EXPECT_EQ(opened.model->results()[0].shape, Shape::Other);  // No third direction, so no magnitude.
    EXPECT_THAT(opened.model->results()[2].components, ElementsAre("z"));
    const Result top = load_wanted(opened, {"temperature", 0, Complex::No, Layer::Top});
    EXPECT_EQ(value_at(opened, top, 120, "value"), static_cast<float>(1e24));
}

TEST(RstNodal, units_are_those_that_the_file_declares) {
    WrittenModel model = test::two_bricks();
    model.dofs = {1, 2, 3, 4, 5, 6, 20};
    model.sets.push_back(plain_set(model));
    model.units = 4;
    const OpenedRst inch = open_written(model);
    ASSERT_TRUE(inch.model->mesh().length_unit);
    EXPECT_EQ(inch.model->mesh().length_unit->name, "in");
    EXPECT_EQ(inch.model->mesh().length_unit->metres, 0.0254);
    EXPECT_EQ(load_wanted(inch, {"displacement"}).info.unit, "in");
    EXPECT_EQ(load_wanted(inch, {"rotation"}).info.unit, "rad");
    EXPECT_EQ(load_wanted(inch, {"temperature"}).info.unit, "degF");
    for (const std::int32_t code : {-1, 0, 99}) {
        model.units = code;
        const OpenedRst unknown = open_written(model);
        EXPECT_FALSE(unknown.model->mesh().length_unit) << code;
        EXPECT_EQ(load_wanted(unknown, {"displacement"}).info.unit, "") << code;
    }
    model.units = 5;
    model.analysis = 2;
    EXPECT_EQ(load_wanted(open_written(model), {"displacement"}).info.unit, "");  // A mode has no size.
}

TEST(RstNodal, rotated_nodes_keep_their_values_and_turn_with_the_angles) {
    WrittenModel model = with_set();
    model.nodes[0][4] = 90;  // Node 10: x of its system is y of the global one.
    const OpenedRst opened = open_written(model);
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_TRUE(u.info.nodal_system);
    EXPECT_EQ(value_at(opened, u, 10, "x"), 12.0F);
    const Result turned = to_global(opened.model->mesh(), u);
    EXPECT_NEAR(value_at(opened, turned, 10, "y"), 12.0F, 1e-5F);
    EXPECT_NEAR(value_at(opened, turned, 10, "x"), -1200.0F, 1e-3F);
    EXPECT_EQ(value_at(opened, turned, 20, "x"), 11.0F);
}

TEST(RstNodal, reactions_are_missing_where_nothing_holds_the_node) {
    WrittenModel model = with_set();
    model.dofs = {1, 2, 3, 20};
    model.sets[0] = plain_set(model);
    model.units = 6;
    // Row 1 (node 120) holds UY; row 12 (node 10) UX, and its temperature.
    model.sets[0].reaction_at = {2, 45, 48};
    model.sets[0].reactions = {-5, 7, 0.25};
    const OpenedRst opened = open_written(model);
    const Result force = load_wanted(opened, {"reaction_force"});
    EXPECT_EQ(force.info.unit, "N");
    EXPECT_EQ(value_at(opened, force, 120, "y"), -5.0F);
    EXPECT_TRUE(std::isnan(value_at(opened, force, 120, "x")));
    EXPECT_EQ(value_at(opened, force, 10, "x"), 7.0F);
    EXPECT_TRUE(std::isnan(value_at(opened, force, 50, "x")));
    EXPECT_EQ(value_at(opened, load_wanted(opened, {"reaction_heat_flow"}), 10, "value"), 0.25F);
    model.sets[0].reaction_at = {2, 45, 49};
    EXPECT_THROW(load_wanted(open_written(model), {"reaction_force"}), Error);
}

TEST(RstSteps, kinds_follow_the_analysis) {
    const std::vector<std::pair<std::int32_t, StepKind>> kinds{
        {0, StepKind::Static},
        {1, StepKind::Buckling},
        {2, StepKind::Mode},
        {3, StepKind::Frequency},
        {4, StepKind::Time},
        {6, StepKind::Frequency},
        {9, StepKind::Other}};
    for (const auto& [analysis, kind] : kinds) {
        WrittenModel model = with_set();
        model.analysis = analysis;
        EXPECT_EQ(open_written(model).model->steps()[0].kind, kind) << analysis;
    }
}

TEST(RstSteps, load_steps_substeps_and_times_are_the_files) {
    WrittenModel model = with_set();
    model.sets.push_back(model.sets[0]);
    model.sets[1].load_step = 2;
    model.sets[1].substep = 5;
    model.sets[1].time = 3.5;
    model.sets[1].solution[0] = -8;
    const OpenedRst opened = open_written(model);
    ASSERT_EQ(opened.model->steps().size(), 2u);
    EXPECT_EQ(opened.model->steps()[1].step, 2);
    EXPECT_EQ(opened.model->steps()[1].substep, 5);
    EXPECT_EQ(opened.model->steps()[1].value, 3.5);
    EXPECT_EQ(value_at(opened, load_wanted(opened, {"displacement", 1}), 120, "x"), -8.0F);
    EXPECT_EQ(value_at(opened, load_wanted(opened, {"displacement", 0}), 120, "x"), 1.0F);
}

TEST(RstSteps, real_and_imaginary_sets_are_one_step) {
    WrittenModel model = with_set();
    model.analysis = 3;
    model.is_complex = true;
    model.sets[0].time = 50;
    model.sets.push_back(model.sets[0]);
    model.sets[1].imaginary = true;
    model.sets[1].solution[0] = 0.5;
    const OpenedRst opened = open_written(model);
    ASSERT_EQ(opened.model->steps().size(), 1u);
    EXPECT_EQ(opened.model->steps()[0].value, 50);
    EXPECT_EQ(value_at(opened, load_wanted(opened, {"displacement", 0, Complex::Real}), 120, "x"), 1.0F);
    EXPECT_EQ(value_at(opened, load_wanted(opened, {"displacement", 0, Complex::Imaginary}), 120, "x"), 0.5F);
}

TEST(RstSteps, modes_are_labelled_by_number) {
    WrittenModel model = with_set();
    model.analysis = 2;
    model.sets[0].substep = 4;
    EXPECT_EQ(open_written(model).model->steps()[0].label, "mode 4");
}

TEST(RstSource, sector_of_a_cyclic_model_is_said_to_be_one) {
    WrittenModel model = with_set();
    model.sectors = 8;
    EXPECT_TRUE(open_written(model).diagnostics->has(Code::ResultForPartOfModel));
}

TEST(RstSource, other_binaries_of_ansys_are_refused_by_name) {
    std::string bytes = test::write_rst(with_set());
    bytes[8] = 4;  // A .full file.
    try {
        test::open_bytes(bytes);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::UnknownFormat);
        EXPECT_THAT(error.what(), testing::HasSubstr(".rst"));
    }
}

}  // namespace
}  // namespace feelem
