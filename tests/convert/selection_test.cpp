// SPDX-License-Identifier: Apache-2.0
// Which steps are taken, ranges with ids, ranks: on made-up models.
#include "base/nearest_name.hpp"
#include "convert/model_values.hpp"
#include "convert/presenting.hpp"
#include "convert/selection.hpp"
#include "convert/skin_options.hpp"
#include "convert/stale_files.hpp"
#include "made_up_source.hpp"
#include "support/meshes.hpp"
#include "support/paths.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>

namespace feelem::test {
namespace {

using testing::ElementsAre;

std::vector<std::size_t> steps_of(const MadeUpSource& source, std::string_view text) {
    Diagnostics diagnostics;
    return select_steps(source.steps(), text, DefaultSteps::UpToTwenty, diagnostics);
}

TEST(Steps, up_to_twenty_are_all_taken) {
    MadeUpSource source;
    for (int i = 1; i <= 20; ++i) source.add(0, 1, i);

    EXPECT_EQ(steps_of(source, "").size(), 20U);
}

TEST(Steps, of_more_than_twenty_the_last_of_each_load_step_and_every_mode_stay) {
    MadeUpSource source;
    for (int i = 1; i <= 15; ++i) source.add(0, 1, i);
    for (int i = 1; i <= 15; ++i) source.add(0, 2, i);
    source.add(1, 1, 1, StepKind::Mode);
    source.add(1, 1, 2, StepKind::Mode);
    Diagnostics diagnostics;

    const auto steps = select_steps(source.steps(), "", DefaultSteps::UpToTwenty, diagnostics);

    EXPECT_THAT(steps, ElementsAre(14, 29, 30, 31));
    EXPECT_TRUE(diagnostics.has(Code::StepsLeftOut));
}

TEST(Steps, are_named_by_load_step_substep_mode_and_last) {
    MadeUpSource source;
    source.add(0, 1, 1);
    source.add(0, 1, 2);
    source.add(0, 2, 1);
    source.add(1, 1, 1, StepKind::Mode);
    source.add(1, 1, 2, StepKind::Mode);

    EXPECT_THAT(steps_of(source, "2"), ElementsAre(2));
    EXPECT_THAT(steps_of(source, "1.2"), ElementsAre(1, 4));
    EXPECT_THAT(steps_of(source, "mode:2"), ElementsAre(4));
    EXPECT_THAT(steps_of(source, "last"), ElementsAre(2, 4)) << "the last of each input";
    EXPECT_THAT(steps_of(source, "mode:1, 2.1"), ElementsAre(2, 3));
    EXPECT_THAT(steps_of(source, "all"), ElementsAre(0, 1, 2, 3, 4));
}

TEST(Steps, that_are_not_there_or_no_steps_are_refused) {
    MadeUpSource source;
    source.add(0, 1, 1);

    EXPECT_THROW(steps_of(source, "7"), Error);
    EXPECT_THROW(steps_of(source, "mode:1"), Error);
    EXPECT_THROW(steps_of(source, "first"), Error);
    EXPECT_THROW(steps_of(source, "1.x"), Error);
    EXPECT_THROW(steps_of(source, "1,"), Error);
}

TEST(Results, are_chosen_by_name_and_file) {
    MadeUpSource source;
    source.add(0, 1, 1);
    source.add(1, 1, 1);

    EXPECT_THAT(select_results(source, {0, 1}, "temperature"), ElementsAre(0, 1));
    EXPECT_THAT(select_results(source, {0, 1}, "temperature@b.frd"), ElementsAre(1));
    EXPECT_THAT(select_results(source, {0}, ""), ElementsAre(0)) << "only those of the steps";
    EXPECT_THROW(select_results(source, {0, 1}, "temperature@c.frd"), Error);
}

TEST(Results, on_request_are_taken_when_they_are_named_or_all_are_asked_for) {
    MadeUpSource source;
    source.add(0, 1, 1);
    source.add(0, 1, 2);
    source.made_results.back().on_request = true;

    EXPECT_THAT(select_results(source, {0, 1}, ""), ElementsAre(0));
    EXPECT_THAT(select_results(source, {0, 1}, "all"), ElementsAre(0, 1));
    EXPECT_THAT(select_results(source, {0, 1}, "temperature"), ElementsAre(0, 1));
}

TEST(Range, smallest_id_on_a_tie_also_across_parts) {
    const Mesh mesh = brick_grid(1, 1, 1);
    Result result;
    result.info.components = {"value"};
    result.info.location = Location::PartNodal;
    result.values = {5, 1, 5, 1};
    result.row_owner = {0, 0, 1, 1};
    result.row_node = {NodeIndex{6}, NodeIndex{7}, NodeIndex{2}, NodeIndex{3}};

    const ComponentRange range = range_over_model(mesh, result, 0);

    EXPECT_EQ(range.max, 5);
    EXPECT_EQ(range.max_id, 3) << "node index 2";
    EXPECT_EQ(range.min_id, 4) << "node index 3";
    EXPECT_EQ(range.missing, 4U) << "of 8 nodes";
}

TEST(Range, of_more_rows_than_are_searched_at_once_takes_the_smallest_ids) {
    const Mesh mesh = brick_grid(40, 40, 40);
    ASSERT_GT(mesh.node_count(), std::size_t{3} << 14U);
    Result result;
    result.info.components = {"value"};
    result.info.location = Location::PartNodal;
    // Nodes backwards, so that the smallest number of equal values stands last.
    for (std::size_t i = mesh.node_count(); i-- > 0;) {
        result.row_owner.push_back(0);
        result.row_node.push_back(NodeIndex{static_cast<std::uint32_t>(i)});
        result.values.push_back(i % 20'000 == 9'000 ? 7.0F : i % 20'000 == 5 ? -3.0F : 1.0F);
    }
    result.values[11] = std::nanf("");
    result.values[12] = 0;

    const ComponentRange range = range_over_model(mesh, result, 0);

    EXPECT_EQ(range.max, 7);
    EXPECT_EQ(range.max_id, raw(mesh.node_ids[9'000]));
    EXPECT_EQ(range.min, -3);
    EXPECT_EQ(range.min_id, raw(mesh.node_ids[5]));
    EXPECT_EQ(range.valid, mesh.node_count() - 1);
    EXPECT_EQ(range.missing, 1U);
    EXPECT_EQ(range.zeros, 1U);
}

TEST(Range, of_nothing_is_no_range) {
    const Mesh mesh = brick_grid(1, 1, 1);
    Result result;
    result.info.components = {"value"};
    result.values.assign(8, std::nanf(""));

    const ComponentRange range = range_over_model(mesh, result, 0);

    EXPECT_EQ(range.valid, 0U);
    EXPECT_EQ(range.missing, 8U);
}

TEST(Range, of_unaveraged_values_names_the_element_too) {
    const Mesh mesh = brick_grid(2, 1, 1);
    Result result;
    result.info.components = {"value"};
    result.info.location = Location::ElementNodal;
    result.values = {1, 9, 9};
    result.row_owner = {0, 0, 1};
    result.row_node = {NodeIndex{0}, NodeIndex{1}, NodeIndex{1}};

    const ComponentRange range = range_over_model(mesh, result, 0);

    EXPECT_EQ(range.max_id, 2);
    EXPECT_EQ(range.max_element, 1) << "the smallest on a tie";
    EXPECT_EQ(range.min_element, 1);
}

TEST(Percentile, is_the_value_of_nearest_rank) {
    std::vector<float> values{15, 20, 35, 40, 50};

    EXPECT_EQ(nearest_rank(values, 0), 15);
    EXPECT_EQ(nearest_rank(values, 30), 20);
    EXPECT_EQ(nearest_rank(values, 40), 20);
    EXPECT_EQ(nearest_rank(values, 40.001), 35);
    EXPECT_EQ(nearest_rank(values, 100), 50);
}

TEST(Percentile, counts_a_node_of_split_vertices_once_and_interpolated_values_never) {
    Surface surface;
    surface.parts.push_back({PartIndex{0}, PartKind::Solid, 0, 4});
    surface.vertex_node = {NodeIndex{5}, NodeIndex{5}, NodeIndex{6}, kNoNode};
    SurfaceField field;
    field.component_count = 1;
    field.values = {1, 1, 2, 3};
    field.validity = {Validity::Solver, Validity::Solver, Validity::Solver, Validity::Interpolated};

    EXPECT_THAT(solver_values(surface, field, 0), ElementsAre(1, 2));
}

TEST(NearestName, is_found_for_typing_errors_only) {
    const std::array<std::string_view, 3> known{"temperature", "stress", "strain"};

    EXPECT_EQ(nearest_name("tempreature", known), "temperature");
    EXPECT_EQ(nearest_name("sterss", known), "stress");
    EXPECT_EQ(nearest_name("voltage", known), "");
    EXPECT_EQ(nearest_name("", known), "");
}

TEST(SurfaceNodes, are_the_first_numbers_of_number_rows) {
    const char* list =
        " LIST ALL SELECTED NODES.   DSYS= 0\n\n    NODE        X             Y             Z\n"
        "       7   1.0E-01       0.00          -2.0\r\n       3   0.0  0.0  0.0\n  12\n 7 0 0 0\n page 3 of "
        "4\n";

    EXPECT_THAT(read_surface_nodes(list, "list"), ElementsAre(NodeId{3}, NodeId{7}, NodeId{12}));
    EXPECT_THROW(read_surface_nodes("no numbers", "list"), Error);
}

TEST(StaleFiles, of_dead_processes_are_removed_and_others_stay) {
    const std::string folder = scratch_folder("stale_files");
    // No process has this number: Linux ends at 4194304.
    for (const char* name :
         {"a.glb.tmp-999999999", "a.d.tmp-999999999", "b.glb.tmp-999999999", "a.glb.tmp-x"}) {
        write_file(folder + "/" + name, "x");
    }
    write_file(folder + "/a.glb.tmp-1", "init is alive");

    remove_stale_files(folder + "/a.glb");

    EXPECT_FALSE(std::filesystem::exists(folder + "/a.glb.tmp-999999999"));
    EXPECT_FALSE(std::filesystem::exists(folder + "/a.d.tmp-999999999"));
    EXPECT_TRUE(std::filesystem::exists(folder + "/b.glb.tmp-999999999"));
    EXPECT_TRUE(std::filesystem::exists(folder + "/a.glb.tmp-x"));
    EXPECT_TRUE(std::filesystem::exists(folder + "/a.glb.tmp-1"));
}

}  // namespace
}  // namespace feelem::test
