// SPDX-License-Identifier: Apache-2.0
// Files of distributed runs: SYNTHETIC ones and a real pair.
#include "read_ansys_rst/opened_rst.hpp"

#include "feelem/derive.hpp"
#include "feelem/error.hpp"
#include "feelem/skin.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace feelem {
namespace {

using test::load_wanted;
using test::open_written;
using test::OpenedRst;
using test::value_at;
using test::WrittenModel;
using testing::ElementsAre;

/// One of the two bricks with its eight nodes; displacement of a node is its number.
WrittenModel domain(std::size_t brick) {
    const WrittenModel both = test::two_bricks();
    WrittenModel model = both;
    model.nodes_of_all = 12;
    model.elements = {both.elements[brick]};
    model.nodes.clear();
    model.storage = both.elements[brick].nodes;
    test::WrittenSet set;
    for (const std::int32_t id : model.storage) {
        model.nodes.push_back(both.nodes[static_cast<std::size_t>(id / 10 - 1)]);
        for (int c = 0; c < 3; ++c) set.solution.push_back(id + c);
    }
    set.element_records.push_back({0, 3, std::vector<double>(48, 100.0 * static_cast<double>(brick + 1)), 0});
    model.sets = {set};
    return model;
}

TEST(RstDomains, files_of_one_run_are_one_model) {
    const OpenedRst opened = open_written({domain(1), domain(0)});
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 12u);
    EXPECT_EQ(mesh.element_count(), 2u);
    EXPECT_FALSE(opened.diagnostics->has(Code::ResultForPartOfModel));
    ASSERT_EQ(opened.model->results().size(), 2u);
    const Result u = load_wanted(opened, {"displacement"});
    for (std::int64_t id = 10; id <= 120; id += 10)
        EXPECT_EQ(value_at(opened, u, id, "y"), static_cast<float>(id + 1));
    const Result stress = load_wanted(opened, {"stress"});
    EXPECT_EQ(stress.row_count(), 16u);
    EXPECT_TRUE(std::ranges::is_sorted(stress.row_owner));
    for (std::size_t row = 0; row < 16; ++row) {
        const std::int64_t id = raw(element_at(mesh, ElementIndex{stress.row_owner[row]}).id());
        EXPECT_EQ(stress.values[6 * row], id == 7 ? 100.0F : 200.0F);
    }
    Diagnostics ignored;
    EXPECT_EQ(make_skin(mesh, {}, ignored).report.solid_quad_kept, 10u);
}

TEST(RstDomains, domain_that_is_not_given_is_reported_with_numbers) {
    const OpenedRst opened = open_written(domain(0));
    EXPECT_TRUE(opened.diagnostics->has(Code::ResultForPartOfModel));
    EXPECT_THAT(opened.diagnostics->entries().back().text, testing::HasSubstr("8 of 12"));
}

TEST(RstDomains, nodes_whose_files_disagree_are_missing) {
    WrittenModel other = domain(1);
    other.sets[0].solution[0] += 1;  // Node 20, x.
    const OpenedRst opened = open_written({domain(0), other});
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_TRUE(std::isnan(value_at(opened, u, 20, "x")));
    EXPECT_EQ(value_at(opened, u, 20, "y"), 21.0F);
    EXPECT_EQ(opened.diagnostics->count(Code::SeveralValuesAtNode), 1u);
}

TEST(RstDomains, files_of_two_runs_are_not_mixed) {
    WrittenModel other = domain(1);
    other.time += 5;
    EXPECT_THROW(open_written({domain(0), other}), Error);
    WrittenModel longer = domain(1);
    longer.sets.push_back(longer.sets[0]);
    longer.sets[1].substep = 2;
    EXPECT_THROW(open_written({domain(0), longer}), Error);
}

TEST(RstDomains, combined_file_wins_over_its_parts) {
    WrittenModel whole = test::two_bricks();
    test::WrittenSet set;
    set.solution.assign(36, 0.25);
    whole.sets = {set};
    const OpenedRst opened = open_written({domain(0), domain(1), whole});
    EXPECT_EQ(value_at(opened, load_wanted(opened, {"displacement"}), 20, "x"), 0.25F);
    EXPECT_EQ(opened.model->results().size(), 1u);
    EXPECT_EQ(opened.diagnostics->count(Code::UnknownBlock), 2u);
}

TEST(RstDomains, two_files_of_one_mesh_are_one_model_with_the_steps_of_both) {
    WrittenModel heat = test::two_bricks();
    heat.dofs = {20};
    test::WrittenSet set;
    set.solution.assign(12, 25);
    heat.sets = {set};
    WrittenModel load = test::two_bricks();
    set.solution.assign(36, 0.25);
    load.sets = {set};
    const OpenedRst opened = open_written({heat, load});
    ASSERT_EQ(opened.model->steps().size(), 2u);
    EXPECT_EQ(opened.model->steps()[0].input, 0u);
    EXPECT_EQ(opened.model->steps()[1].input, 1u);
    EXPECT_TRUE(test::has_wanted(opened, {"temperature", 0}));
    EXPECT_TRUE(test::has_wanted(opened, {"displacement", 1}));
}

TEST(RstDomains, real_pair_has_all_nodes_and_a_closed_skin) {
    const std::string folder = "rst/distributed_v211/";
    const OpenedRst opened = test::open_corpus({folder + "file1.rst", folder + "file0.rst"});
    if (!opened.model) GTEST_SKIP() << "the corpus is not here";
    const Mesh& mesh = opened.model->mesh();
    EXPECT_EQ(mesh.node_count(), 432u);
    EXPECT_EQ(mesh.element_count() + mesh.skipped_elements.at("SURF154"), 72u);
    Diagnostics ignored;
    const Surface surface = make_skin(mesh, {}, ignored);
    EXPECT_TRUE(surface.report.closed);
    EXPECT_EQ(surface.report.solid_quad_kept, 102u);  // 64 and 64, of which 13 are where they meet.
    EXPECT_EQ(opened.model->steps().size(), 6u);
    const Result u = load_wanted(opened, {"displacement"});
    EXPECT_FLOAT_EQ(value_at(opened, u, 89, "x"), 8.7298458F);   // file1's largest
    EXPECT_FLOAT_EQ(value_at(opened, u, 57, "z"), -1.9081438F);  // file0's smallest
    for (const float value : u.values) EXPECT_FALSE(std::isnan(value));
    EXPECT_FALSE(opened.diagnostics->has(Code::SeveralValuesAtNode));
}

}  // namespace
}  // namespace feelem
