// SPDX-License-Identifier: Apache-2.0
// Which results a scene gets, under which ids, at which steps.
#include "convert/presenting.hpp"
#include "convert/scene_plan.hpp"
#include "made_up_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

namespace feelem::test {
namespace {

using testing::ElementsAre;

ScenePlan plan_of(const MadeUpSource& source) {
    std::vector<std::size_t> steps(source.made_steps.size()), results(source.made_results.size());
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = i;
    for (std::size_t i = 0; i < results.size(); ++i) results[i] = i;
    return plan_scene(source, steps, results);
}

std::vector<std::string> ids_of(const ScenePlan& plan) {
    std::vector<std::string> ids;
    for (const PlannedResult& planned : plan.results) ids.push_back(planned.scene.id);
    return ids;
}

TEST(ScenePlan, vectors_and_tensors_stay_whole_and_get_their_invariants) {
    MadeUpSource source;
    source.add_step(0, 1, 1);
    source.add_result("displacement", {"x", "y", "z"}, Shape::Vector);
    source.add_result("stress", {"xx", "yy", "zz", "xy", "yz", "zx"}, Shape::SymmetricTensor);

    const ScenePlan plan = plan_of(source);

    EXPECT_THAT(
        ids_of(plan),
        ElementsAre(
            "displacement",
            "displacement_magnitude",
            "stress",
            "stress_von_mises",
            "stress_tresca",
            "stress_principal_1",
            "stress_principal_2",
            "stress_principal_3"
        )
    );
    EXPECT_EQ(plan.results[3].scene.title, "von Mises stress");
    EXPECT_EQ(plan.results[1].scene.title, "Displacement magnitude");
    EXPECT_TRUE(plan.results[1].scene.derived);
    EXPECT_EQ(plan.domain, Domain::Node);
}

TEST(ScenePlan, invariants_that_the_file_lists_are_the_files) {
    MadeUpSource source;
    source.add_step(0, 1, 1);
    source.add_result("displacement", {"x", "y", "z", "magnitude"}, Shape::Vector);

    const ScenePlan plan = plan_of(source);

    EXPECT_THAT(ids_of(plan), ElementsAre("displacement", "displacement_magnitude"));
    EXPECT_FALSE(plan.results[1].scene.derived);
}

TEST(ScenePlan, incomplete_vectors_are_scalars_so_that_nothing_is_invented) {
    MadeUpSource source;
    source.add_step(0, 1, 1);
    source.add_result("displacement", {"x", "y"}, Shape::Vector);

    const std::vector<std::string> ids = ids_of(plan_of(source));

    ASSERT_GE(ids.size(), 2U);
    EXPECT_EQ(ids[0], "displacement_x");
    EXPECT_EQ(ids[1], "displacement_y");
}

TEST(ScenePlan, layers_and_complex_parts_have_ids_of_their_own) {
    MadeUpSource source;
    source.add_step(0, 1, 1);
    source.add_result("temperature", {"value"}, Shape::Scalar).layer = Layer::Top;
    source.add_result("temperature", {"value"}, Shape::Scalar).layer = Layer::Bottom;
    source.add_result("pressure", {"value"}, Shape::Scalar).complex = Complex::Imaginary;

    EXPECT_THAT(ids_of(plan_of(source)), ElementsAre("temperature_top", "temperature_bottom", "pressure_im"));
}

TEST(ScenePlan, odd_and_repeated_names_give_plain_ids_that_differ) {
    MadeUpSource source;
    source.add_step(0, 1, 1);
    for (const char* name :
         {"T (\xC2\xB0"
          "C)",
          "t___c_",
          "temperature",
          "temperature",
          "",
          "../x",
          "T\"<"}) {
        source.add_result(name, {"value"}, Shape::Scalar);
    }

    const std::vector<std::string> ids = ids_of(plan_of(source));

    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 7U);
    for (const std::string& id : ids) {
        EXPECT_FALSE(id.empty());
        EXPECT_EQ(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << id;
    }
}

TEST(ScenePlan, one_result_goes_on_over_steps_and_another_unit_is_another_result) {
    MadeUpSource source;
    source.add(0, 1, 1);
    source.add(0, 1, 2);
    source.add(0, 1, 3);
    source.made_results.back().unit = "K";

    const ScenePlan plan = plan_of(source);

    EXPECT_THAT(ids_of(plan), ElementsAre("temperature", "temperature_2"));
    EXPECT_EQ(plan.results[0].values.size(), 2U);
    EXPECT_EQ(plan.results[1].values[0].step, 2U);
}

TEST(ScenePlan, equal_steps_of_two_inputs_join_only_when_no_result_is_in_both) {
    MadeUpSource source;
    source.add(0, 1, 1);
    source.add_step(1, 1, 1);
    source.add_result("displacement", {"x", "y", "z"}, Shape::Vector);
    EXPECT_EQ(plan_of(source).steps.size(), 1U);

    source.add_result("temperature", {"value"}, Shape::Scalar);
    EXPECT_EQ(plan_of(source).steps.size(), 2U);
}

TEST(ScenePlan, elemental_results_need_vertices_of_their_own) {
    MadeUpSource source;
    source.add(0, 1, 1);
    source.made_results.back().location = Location::Elemental;

    EXPECT_EQ(plan_of(source).domain, Domain::ElementNode);
}

TEST(ShownStep, is_the_last_of_the_fullest_and_a_mode_only_when_there_is_nothing_else) {
    MadeUpSource source;
    source.add(0, 1, 1);
    source.add_result("displacement", {"x", "y", "z"}, Shape::Vector);
    source.add(0, 1, 2);
    source.add_result("displacement", {"x", "y", "z"}, Shape::Vector);
    source.add(0, 1, 3);
    source.add(0, 2, 1, StepKind::Mode);
    EXPECT_EQ(choose_shown_step(plan_of(source), {}), 1U);

    Presentation wanted;
    wanted.step = std::array{0, 1, 3};
    EXPECT_EQ(choose_shown_step(plan_of(source), wanted), 2U);

    MadeUpSource modes;
    modes.add(0, 1, 1, StepKind::Mode);
    modes.add(0, 2, 1, StepKind::Mode);
    EXPECT_EQ(choose_shown_step(plan_of(modes), {}), 0U);
}

}  // namespace
}  // namespace feelem::test
