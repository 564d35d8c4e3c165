// SPDX-License-Identifier: Apache-2.0
// The shipped boilers as lists: counts and extremes, whose right answers are those of the solver's own file
// to the printed digits, at the smallest node on a tie.
#include "read_ansys/opened_lists.hpp"
#include "support/paths.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace feelem {
namespace {

using test::extremes;
using test::load_only;
using test::open_files;

std::vector<std::string> boiler(const std::string& folder, const std::vector<std::string>& names) {
    std::vector<std::string> paths;
    for (const std::string& name : names)
        paths.push_back(test::project_file("examples/boiler/" + folder + "/" + name));
    return paths;
}

const std::vector<std::string> kAllLists{
    "PRNSOL_S.lis", "ELIST.lis", "PRNSOL_U.lis", "NLIST_all.lis", "ETLIST.lis", "PRNSOL_TEMP.lis"};

TEST(BoilerLists, hex_linear_has_its_nodes_elements_and_wedges) {
    auto opened = open_files(boiler("hex_linear", kAllLists));
    const Mesh& mesh = opened.model->mesh();

    EXPECT_EQ(mesh.node_count(), 2546u);
    ASSERT_EQ(mesh.blocks.size(), 2u);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Hex8);
    EXPECT_EQ(mesh.blocks[0].ids.size(), 1248u);
    EXPECT_EQ(mesh.blocks[1].type, ElementType::Wedge6);
    EXPECT_EQ(mesh.blocks[1].ids.size(), 24u);
    ASSERT_EQ(mesh.parts.size(), 1u);
    EXPECT_EQ(mesh.parts[0].name, "material 1");
    EXPECT_FALSE(opened.diagnostics->has(Code::GuessedElementType)) << test::all_texts(*opened.diagnostics);
}

TEST(BoilerLists, hex_linear_extremes_are_the_printed_ones_at_the_smallest_node) {
    auto opened = open_files(boiler("hex_linear", kAllLists));
    const Mesh& mesh = opened.model->mesh();

    const auto temperature = extremes(mesh, load_only(opened, "temperature"), "value");
    EXPECT_EQ(temperature.min, 124.05F);
    EXPECT_EQ(temperature.min_id, 1231);
    EXPECT_EQ(temperature.max, 227.51F);
    EXPECT_EQ(temperature.max_id, 67);
    EXPECT_EQ(temperature.valid, 2546u);

    const Result displacement = load_only(opened, "displacement");
    EXPECT_EQ(displacement.info.components, (std::vector<std::string>{"x", "y", "z", "magnitude"}));
    EXPECT_EQ(displacement.info.shape, Shape::Vector);
    EXPECT_EQ(displacement.info.solver_name, "U");
    EXPECT_EQ(extremes(mesh, displacement, "magnitude").max, 4.2462F);
    EXPECT_EQ(extremes(mesh, displacement, "magnitude").max_id, 212);
    EXPECT_EQ(extremes(mesh, displacement, "x").max, 0.8792F);
    EXPECT_EQ(extremes(mesh, displacement, "x").max_id, 6);

    const Result stress = load_only(opened, "stress");
    EXPECT_EQ(stress.info.components, (std::vector<std::string>{"xx", "yy", "zz", "xy", "yz", "zx"}));
    EXPECT_EQ(stress.info.shape, Shape::SymmetricTensor);
    EXPECT_EQ(stress.info.averaging, Averaging::Solver);
    EXPECT_FALSE(stress.info.corner_only);
    EXPECT_EQ(extremes(mesh, stress, "yy").min, -367.51F);
    EXPECT_EQ(extremes(mesh, stress, "yy").min_id, 120);
    EXPECT_EQ(extremes(mesh, stress, "zx").max, 46.222F);
}

TEST(BoilerLists, steps_name_their_input_and_are_static_at_time_one) {
    auto opened = open_files(boiler("hex_linear", kAllLists));
    ASSERT_EQ(opened.model->steps().size(), 3u);
    for (const Step& step : opened.model->steps()) {
        EXPECT_EQ(step.step, 1);
        EXPECT_EQ(step.substep, 1);
        EXPECT_EQ(step.kind, StepKind::Static);
        EXPECT_EQ(step.value, 1.0);
    }
}

TEST(BoilerLists, small_lists_stress_at_corner_nodes_only) {
    auto opened = open_files(boiler("small", kAllLists));
    const Mesh& mesh = opened.model->mesh();

    EXPECT_EQ(mesh.node_count(), 7670u);
    ASSERT_EQ(mesh.blocks.size(), 1u);
    EXPECT_EQ(mesh.blocks[0].type, ElementType::Tet10);
    EXPECT_EQ(mesh.blocks[0].ids.size(), 3809u);
    const Result stress = load_only(opened, "stress");
    EXPECT_TRUE(stress.info.corner_only);
    EXPECT_LT(extremes(mesh, stress, "xx").valid, 7670u);
    const Result temperature = load_only(opened, "temperature");
    EXPECT_FALSE(temperature.info.corner_only);
    EXPECT_EQ(extremes(mesh, temperature, "value").max, 237.15F);
    EXPECT_EQ(extremes(mesh, temperature, "value").max_id, 2770);
    EXPECT_EQ(extremes(mesh, load_only(opened, "displacement"), "magnitude").max, 4.0853F);
    EXPECT_EQ(extremes(mesh, load_only(opened, "displacement"), "magnitude").max_id, 2193);
}

TEST(BoilerLists, both_node_lists_of_the_paper_together_say_nothing_twice) {
    auto opened =
        open_files(boiler("small", {"NLIST_surface.lis", "NLIST_all.lis", "ELIST.lis", "ETLIST.lis"}));
    EXPECT_EQ(opened.model->mesh().node_count(), 7670u);
    EXPECT_FALSE(opened.diagnostics->has(Code::DuplicateNode));
}

TEST(BoilerLists, a_node_list_alone_is_a_list_of_ids) {
    auto opened = open_files(boiler("small", {"NLIST_surface.lis"}));
    EXPECT_EQ(opened.model->mesh().node_count(), 5146u);
    EXPECT_EQ(opened.model->mesh().element_count(), 0u);
}

TEST(BoilerLists, results_alone_read_by_node_id) {
    auto opened = open_files(boiler("hex_linear", {"PRNSOL_TEMP.lis"}));
    const auto temperature = extremes(opened.model->mesh(), load_only(opened, "temperature"), "value");
    EXPECT_EQ(temperature.min, 124.05F);
    EXPECT_EQ(temperature.min_id, 1231);
}

TEST(BoilerLists, without_type_list_the_shape_is_concluded_and_said) {
    auto opened = open_files(boiler("small", {"NLIST_all.lis", "ELIST.lis"}));
    ASSERT_EQ(opened.model->mesh().blocks.size(), 1u);
    EXPECT_EQ(opened.model->mesh().blocks[0].type, ElementType::Tet10);
    EXPECT_EQ(opened.diagnostics->count(Code::GuessedElementType), 3809u);
}

TEST(BoilerLists, lists_of_results_go_with_the_mesh_of_a_frd_file) {
    auto paths = boiler("hex_linear", {"PRNSOL_TEMP.lis", "heat.frd"});
    auto opened = open_files(paths);
    EXPECT_EQ(opened.model->mesh().element_count(), 1272u);
    int temperatures = 0;
    for (const ResultInfo& info : opened.model->results()) temperatures += info.name == "temperature" ? 1 : 0;
    EXPECT_EQ(temperatures, 2);
}

}  // namespace
}  // namespace feelem
