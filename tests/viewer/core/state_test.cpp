// SPDX-License-Identifier: Apache-2.0
// What a person can change, and what comes of it.
#include "support/paths.hpp"
#include "viewer/core/scene_in_memory.hpp"

#include "feelem/error.hpp"
#include "feelem/presented_view.hpp"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace feelem::viewer::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Two steps of temperature and a displacement, all senses free.
Scene warm_square() {
    Scene scene = two_squares();
    scene.parts.pop_back();
    add_result_to(scene, "temperature", {"value"}, {{10, 20, 30, 40}, {5, 5, 5, 90}});
    add_result_to(
        scene,
        "displacement",
        {"x", "y", "z"},
        {{0, 0, 0.5F, 0, 0, 0, 0, 0, 0, 0, 0, 0}, std::vector<float>(12)}
    );
    PresentedResult t = presented("T", "temperature", "value");
    t.range_mode = "auto";
    t.lo.reset();
    t.hi.reset();
    scene.presentation.results = {t, presented("U", "displacement", "z")};
    scene.presentation.deformation_result = "U";
    PresentedEffect colour;
    colour.result = "T";
    scene.presentation.effects = {colour};
    return scene;
}

TEST(ViewerState, boiler_starts_as_its_presentation_says) {
    Ready ready(boiler_path());
    const ViewerState state = first_state(ready.viewer.model);
    EXPECT_EQ(result_of(state.presentation, Sense::Colour)->key, "T");
    EXPECT_EQ(result_of(state.presentation, Sense::Pitch)->key, "U");
    EXPECT_EQ(result_of(state.presentation, Sense::Pulses)->key, "S");
    EXPECT_EQ(result_of(state.presentation, Sense::Ticks), nullptr);
    EXPECT_FALSE(state.changed);
    const Look look = make_look(state, ready.viewer.model, false);
    ASSERT_TRUE(look.field);
    EXPECT_EQ(ready.memory.scene().results[look.field->result].quantity, "temperature");
    ASSERT_TRUE(look.shape);
    const Scene& scene = ready.memory.scene();
    const auto& largest =
        scene.results[find_field(scene, *result_of(state.presentation, Sense::Pitch), 0)->result];
    const double most = static_cast<double>(largest.values[0].max->value);
    EXPECT_NEAR(
        static_cast<double>(look.shape->factor) * most, 0.05 * ready.viewer.model.largest_side(), 1e-3
    );
}

TEST(ViewerState, model_starts_eighty_centimetres_large_in_front_of_the_person) {
    Ready ready(boiler_path());
    const ViewerState state = first_state(ready.viewer.model);
    const glm::mat4 to_world = model_to_world(state, ready.viewer.model);
    const float scale = glm::length(glm::vec3(to_world[0]));
    EXPECT_NEAR(static_cast<float>(ready.viewer.model.largest_side()) * scale, 0.8F, 1e-4F);
    const auto &low = ready.viewer.model.arrays().low, &high = ready.viewer.model.arrays().high;
    const glm::vec4 middle((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2, 1);
    const glm::vec4 at = to_world * middle;
    EXPECT_NEAR(at.x, 0, 1e-4);
    EXPECT_NEAR(at.y, 1, 1e-4);
    EXPECT_NEAR(at.z, -1.2, 1e-4);
}

TEST(ViewerState, automatic_range_is_that_of_the_step_and_a_typed_one_stays) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    const PresentedResult& t = state.presentation.results[0];
    EXPECT_EQ(range_at(state, ready.viewer.model, t).hi, 40);
    step_by(state, ready.viewer.model, 1);
    EXPECT_EQ(range_at(state, ready.viewer.model, t).lo, 5);
    EXPECT_EQ(range_at(state, ready.viewer.model, t).hi, 90);
    set_range(state, "T", "manual", 60, 20);
    EXPECT_EQ(range_at(state, ready.viewer.model, t).lo, 20);
    EXPECT_EQ(range_at(state, ready.viewer.model, t).hi, 60);
}

TEST(ViewerState, steps_go_round_and_bring_their_own_values) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    const ViewedModel& model = ready.viewer.model;
    EXPECT_EQ(make_look(state, model, false).field->values, 0u);
    step_by(state, model, -1);
    EXPECT_EQ(state.step, 1u);
    EXPECT_EQ(make_look(state, model, false).field->values, 1u);
    step_by(state, model, 1);
    EXPECT_EQ(state.step, 0u);
    EXPECT_FALSE(make_look(state, model, false).shape->factor == 0);
    step_by(state, model, 1);
    EXPECT_FALSE(make_look(state, model, false).shape) << "nothing moves in the second step";
}

TEST(ViewerState, a_result_takes_a_sense_and_the_one_before_lets_it_go) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    assign(state, "U", Sense::Colour);
    EXPECT_EQ(result_of(state.presentation, Sense::Colour)->key, "U");
    assign(state, "T", Sense::Ticks);
    EXPECT_EQ(result_of(state.presentation, Sense::Ticks)->key, "T");
    release(state, Sense::Ticks);
    EXPECT_EQ(effect_of(state.presentation, Sense::Ticks), nullptr);
    assign(state, "nobody", Sense::Ticks);
    EXPECT_EQ(effect_of(state.presentation, Sense::Ticks), nullptr);
    EXPECT_TRUE(state.changed);
}

TEST(ViewerState, signed_results_are_not_told_by_a_rate) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    state.presentation.results[0].scale = Scale::Signed;
    assign(state, "T", Sense::Pulses);
    EXPECT_EQ(effect_of(state.presentation, Sense::Pulses), nullptr);
    EXPECT_THAT(state.notice, HasSubstr("signed"));
}

TEST(ViewerState, next_result_goes_through_those_the_scene_has) {
    Scene scene = warm_square();
    scene.presentation.results.insert(
        scene.presentation.results.begin() + 1, presented("X", "pressure", "value")
    );
    Ready ready(scene);
    std::vector<std::string> seen;
    for (int i = 0; i < 3; ++i) {
        next_result(ready.viewer.state, ready.viewer.model);
        seen.push_back(result_of(ready.viewer.state.presentation, Sense::Colour)->key);
    }
    EXPECT_THAT(seen, ElementsAre("U", "T", "U"));
}

TEST(ViewerState, a_scene_without_presentation_shows_what_it_has) {
    Scene scene = warm_square();
    scene.presentation = {};
    Ready ready(scene);
    const ViewerState state = first_state(ready.viewer.model);
    EXPECT_EQ(result_of(state.presentation, Sense::Colour)->name, "temperature");
    EXPECT_FALSE(state.changed);
}

TEST(ViewerState, deformation_is_automatic_true_none_or_typed) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    const ViewedModel& model = ready.viewer.model;
    EXPECT_NEAR(factor_of(state, model), 0.05 * 1 / 0.5, 1e-12);
    run(state, model, Command::TrueDeformation, {});
    EXPECT_EQ(factor_of(state, model), 1);
    run(state, model, Command::NoDeformation, {});
    EXPECT_EQ(factor_of(state, model), 0);
    EXPECT_FALSE(make_look(state, model, false).shape);
    state.deformation = Deformation::Typed;
    state.typed_factor = -7;
    EXPECT_EQ(make_look(state, model, false).shape->factor, -7);
    release(state, Sense::Shape);
    EXPECT_EQ(factor_of(state, model), 0);
}

TEST(ViewerState, a_mode_swings_once_in_two_seconds_and_other_steps_follow_each_other) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    const ViewedModel& model = ready.viewer.model;
    double age = 0;
    state.playing = true;
    play(state, model, 0.59, age);
    EXPECT_EQ(state.step, 0u);
    play(state, model, 0.02, age);
    EXPECT_EQ(state.step, 1u);

    Scene scene = warm_square();
    for (Step& step : scene.steps) step.kind = StepKind::Mode;
    Ready modes(scene);
    ViewerState& mode = modes.viewer.state;
    const auto factor = [&] { return make_look(mode, modes.viewer.model, false).shape->factor; };
    const float rest = factor();
    mode.playing = true;
    play(mode, modes.viewer.model, 1, age);
    EXPECT_EQ(mode.step, 0u);
    EXPECT_NEAR(factor(), -rest, 1e-6);
    play(mode, modes.viewer.model, 1, age);
    EXPECT_NEAR(factor(), rest, 1e-6);
    mode.playing = false;
    play(mode, modes.viewer.model, 0.3, age);
    EXPECT_EQ(factor(), rest) << "what no longer plays stands as the solver gave it";
}

TEST(ViewerState, a_complex_mode_turns_through_its_imaginary_part) {
    Scene scene = warm_square();
    std::vector<float> aside(12);
    aside[0] = 0.5F;
    add_result_to(scene, "displacement", {"x", "y", "z"}, {aside, aside});
    scene.results[1].complex = Complex::Real;
    scene.results[2].complex = Complex::Imaginary;
    Ready ready(scene);
    ViewerState& state = ready.viewer.state;
    state.angle = std::numbers::pi / 2;
    const Look look = make_look(state, ready.viewer.model, false);
    ASSERT_TRUE(look.shape && look.shape->imaginary);
    EXPECT_EQ(look.shape->imaginary->result, 2u);
    EXPECT_NEAR(look.shape->factor, 0, 1e-7);
    EXPECT_NEAR(look.shape->imaginary_factor, -factor_of(state, ready.viewer.model), 1e-6);
    EXPECT_TRUE(swings(state, ready.viewer.model));
}

TEST(ViewerState, planes_stand_in_the_middle_move_as_far_as_the_model_and_turn_round) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    const ViewedModel& model = ready.viewer.model;
    run(state, model, Command::ToggleClip, {});
    ASSERT_EQ(cuts_of(state).size(), 1u);
    EXPECT_EQ(state.cuts[0].plane.normal, glm::vec3(1, 0, 0));
    EXPECT_EQ(state.cuts[0].plane.offset, 0.5F);
    run(state, model, Command::ClipForward, {});
    EXPECT_NEAR(state.cuts[0].plane.offset, 0.51, 1e-6);
    move_cut(state, model, 0, 3);
    EXPECT_EQ(state.cuts[0].plane.offset, 1);
    flip_cut(state, 0);
    EXPECT_EQ(state.cuts[0].plane.normal, glm::vec3(-1, 0, 0));
    EXPECT_EQ(state.cuts[0].plane.offset, -1);
    add_cut(state, model);
    EXPECT_EQ(state.cuts[1].plane.normal, glm::vec3(0, 1, 0));
    add_cut(state, model);
    add_cut(state, model);
    EXPECT_EQ(state.cuts.size(), kMostCuts);
    run(state, model, Command::ToggleClip, {});
    EXPECT_TRUE(cuts_of(state).empty());
    run(state, model, Command::ToggleClip, {});
    EXPECT_EQ(cuts_of(state).size(), kMostCuts);
}

TEST(ViewerState, first_hot_spot_of_the_boiler_is_the_solvers_extreme) {
    Ready ready(boiler_path());
    ViewerState& state = ready.viewer.state;
    assign(state, "S", Sense::Colour);
    const std::vector<HotSpot> spots = hot_spots(state, ready.viewer.model);
    ASSERT_EQ(spots.size(), 5u);
    const Scene& scene = ready.memory.scene();
    const auto field = find_field(scene, *result_of(state.presentation, Sense::Colour), state.step);
    const SceneValues& stated = scene.results[field->result].values[field->values];
    EXPECT_EQ(spots[0].node, stated.max->id);
    EXPECT_EQ(spots[0].value, static_cast<double>(stated.max->value));
    EXPECT_NEAR(*spots[0].utilisation, spots[0].value / 250, 1e-12);
    for (std::size_t i = 1; i < spots.size(); ++i) EXPECT_LE(spots[i].value, spots[i - 1].value);
    state.hot.largest = false;
    EXPECT_EQ(hot_spots(state, ready.viewer.model).front().node, stated.min->id);
}

TEST(ViewerState, hot_spots_keep_apart_pass_over_the_hidden_and_are_gone_to_in_turn) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    state.hot.share = 0.5;
    const auto nodes = [&] {
        std::vector<std::int64_t> out;
        for (const HotSpot& spot : hot_spots(state, ready.viewer.model)) out.push_back(spot.node);
        return out;
    };
    EXPECT_THAT(nodes(), ElementsAre(4)) << "3 is outdone by its neighbour 4";
    run(state, ready.viewer.model, Command::NextHotSpot, {});
    EXPECT_EQ(state.pin, 4);
    ASSERT_TRUE(state.look_at);
    HotSpotList list;
    EXPECT_EQ(list.of(state, ready.viewer.model).size(), 1u);
    set_part(state, 0, PartLook::Hidden);
    EXPECT_TRUE(list.of(state, ready.viewer.model).empty());
    run(state, ready.viewer.model, Command::NextHotSpot, {});
    EXPECT_THAT(state.notice, HasSubstr("no hot spots"));
}

TEST(ViewerState, hot_spots_of_nodes_numbered_from_a_billion_on_are_the_same) {
    Scene scene = warm_square();
    for (std::int64_t& id : scene.parts[0].node_ids) id += 1'000'000'000;
    Ready ready(scene);
    ready.viewer.state.hot.share = 0.5;
    const std::vector<HotSpot> spots = hot_spots(ready.viewer.state, ready.viewer.model);
    ASSERT_EQ(spots.size(), 1u);
    EXPECT_EQ(spots[0].node, 1'000'000'004);
}

TEST(ViewerState, a_part_alone_hides_the_others) {
    Ready ready(two_squares());
    isolate_part(ready.viewer.state, 1);
    EXPECT_THAT(
        make_look(ready.viewer.state, ready.viewer.model, false).parts,
        ElementsAre(PartLook::Hidden, PartLook::Shown)
    );
}

TEST(ViewerState, notes_are_one_a_node_and_say_why_not) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    const ViewedModel& model = ready.viewer.model;
    run(state, model, Command::PlaceMarker, {});
    EXPECT_THAT(state.notice, HasSubstr("Point at a node"));
    run(state, model, Command::PlaceMarker, {false, 3});
    run(state, model, Command::PlaceMarker, {false, 3});
    EXPECT_EQ(state.markers.size(), 1u);
    EXPECT_THAT(state.notice, HasSubstr("already"));
    run(state, model, Command::PlaceMarker, {false, 4});
    remove_marker(state, 1);
    ASSERT_EQ(state.markers.size(), 1u);
    EXPECT_EQ(state.markers[0].id, 2);
    run(state, model, Command::RemoveMarkers, {});
    EXPECT_TRUE(state.markers.empty());
}

TEST(ViewerState, escape_lets_go_of_the_place_first_and_leaves_then) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    go_to_node(state, ready.viewer.model, 2);
    run(state, ready.viewer.model, Command::Leave, {});
    EXPECT_FALSE(state.pin);
    EXPECT_FALSE(state.leaves);
    run(state, ready.viewer.model, Command::Leave, {});
    EXPECT_TRUE(state.leaves);
    go_to_node(state, ready.viewer.model, 77);
    EXPECT_FALSE(state.pin);
    EXPECT_THAT(state.notice, HasSubstr("77 is not on the skin"));
}

TEST(ViewerState, level_of_detail_fits_the_budget_and_a_headset_has_one_from_the_start) {
    Scene scene = two_squares();
    for (const std::uint64_t triangles : {3U, 2U, 1U}) {
        SceneLevel level;
        level.triangles = triangles;
        for (std::size_t r = 0; r < scene.results.size(); ++r)
            for (std::size_t v = 0; v < scene.results[r].values.size(); ++v)
                level.values.push_back({r, v, 0.5, 0, 0});
        scene.levels.push_back(level);
    }
    Ready ready(scene);
    const ViewedModel& model = ready.viewer.model;
    EXPECT_EQ(level_within(model, 4, {}), std::nullopt);
    EXPECT_EQ(level_within(model, 3, {}), 0u);
    EXPECT_EQ(level_within(model, 2, {}), 1u);
    EXPECT_EQ(level_within(model, 0, {}), 2u) << "the coarsest when none fits";
    ready.viewer.state.most_triangles = 2;
    EXPECT_EQ(make_look(ready.viewer.state, model, true).level, 1u);
}

TEST(ViewerState, a_level_without_a_bound_for_what_is_drawn_is_left_alone) {
    Scene scene = warm_square();
    scene.levels.resize(2);
    scene.levels[0].triangles = 1;
    scene.levels[1].triangles = 1;
    scene.levels[1].values = {{0, 0, 0.5, 0, 0}};
    Ready ready(scene);
    const ViewedModel& model = ready.viewer.model;
    const std::array first{FieldChoice{0, 0, 0}};
    const std::array both{FieldChoice{0, 0, 0}, FieldChoice{1, 0, 0}};
    EXPECT_EQ(level_within(model, 1, first), 1u) << "the finer one says nothing of this result";
    EXPECT_EQ(level_within(model, 1, both), std::nullopt);
    ViewerState& state = ready.viewer.state;
    state.most_triangles = 1;
    state.deformation = Deformation::None;
    Look look = make_look(state, model, true);
    ASSERT_EQ(look.field, first[0]);
    EXPECT_EQ(look.level, 1u);
    set_step(state, model, 1);
    look = make_look(state, model, true);
    ASSERT_EQ(look.field, (FieldChoice{0, 1, 0}));
    EXPECT_EQ(look.level, std::nullopt) << "no bound at the second step";
}

TEST(ViewerState, a_label_made_of_a_limits_number_goes_with_the_number_and_a_name_stays) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    PresentedResult& t = state.presentation.results.at(0);
    set_limit(state, "T", 25);
    EXPECT_EQ(t.limit_label, "T 25");
    set_limit(state, "T", 30);
    EXPECT_EQ(t.limit_label, "T 30");
    set_limit(state, "T", std::nullopt);
    set_limit(state, "T", 35);
    EXPECT_EQ(t.limit_label, "T 35");
    t.limit_label = "paint";
    set_limit(state, "T", 40);
    EXPECT_EQ(t.limit_label, "paint");
}

TEST(ViewerState, a_saved_presentation_comes_back_as_it_was_changed_and_keeps_what_nobody_knows) {
    Ready ready(boiler_path());
    ViewerState& state = ready.viewer.state;
    const ViewedModel& model = ready.viewer.model;
    assign(state, "S", Sense::Colour);
    set_range(state, "T", "manual", 20, 90);
    set_limit(state, "T", 80);
    set_limit(state, "U", 1.5);
    state.deformation = Deformation::None;
    run(state, model, Command::ToggleIsolines, {});
    const std::string path = feelem::test::scratch_folder("viewer_core_saved") + "/boiler.json";
    save_presentation(state, model, path);
    EXPECT_FALSE(state.changed);
    const std::string text = feelem::test::read_file(path);
    EXPECT_THAT(text, HasSubstr("oneEuro")) << "of keys that this program does not read";
    const Presentation read = parse_presentation(text, "boiler.json");
    EXPECT_EQ(read.results, state.presentation.results);
    EXPECT_EQ(result_of(read, Sense::Colour)->key, "S");
    EXPECT_EQ(read.deformation_factor, 0);
    EXPECT_TRUE(presented_view(text).isolines);
    EXPECT_TRUE(presented_view(text).ghost) << "as it was";
}

TEST(ViewerState, shade_is_off_at_first_and_weaker_for_maps_told_by_lightness) {
    Ready ready(warm_square());
    ViewerState& state = ready.viewer.state;
    const auto floor = [&] { return make_look(state, ready.viewer.model, false).shade_floor; };
    EXPECT_EQ(floor(), 1);
    state.shading = true;
    EXPECT_EQ(floor(), 0.75F);
    ColourEffect effect = effect_of(state.presentation, Sense::Colour)->colour;
    effect.map = "cividis";
    set_colour(state, effect);
    EXPECT_EQ(floor(), 0.875F);
}

TEST(ViewerState, a_result_that_cannot_be_read_is_said_and_is_no_value) {
    SceneInMemory memory(warm_square());
    ModelSource source = memory.source();
    source.values = [](std::size_t, std::size_t) -> FieldSpan {
        throw Error(Code::BadScene, "scene.glb", "cut off");
    };
    const ViewedModel model(source);
    EXPECT_EQ(model.values({0, 0, 0}).components, 0u);
    EXPECT_THAT(model.problem(), HasSubstr("cut off"));
    source.values = [](std::size_t, std::size_t) { return FieldSpan{1, {}, {}}; };
    const ViewedModel lying(source);
    EXPECT_EQ(lying.values({0, 0, 0}).components, 0u) << "shorter than it says";
    EXPECT_FALSE(lying.skin_range({0, 0, 0}));
}

TEST(ViewerState, utilisation_is_a_share_of_the_limit_or_nothing) {
    PresentedResult result = presented("S", "stress", "von_mises");
    EXPECT_EQ(utilisation(5, result), std::nullopt);
    result.limit = 250;
    EXPECT_EQ(utilisation(125, result), 0.5);
    EXPECT_EQ(utilisation(static_cast<double>(kNaN), result), std::nullopt);
    result.limit_is_upper = false;
    EXPECT_EQ(utilisation(500, result), 0.5);
    EXPECT_TRUE(is_past_limit(100, result));
    EXPECT_FALSE(is_past_limit(300, result));
    result.limit = 0;
    EXPECT_EQ(utilisation(1, result), std::nullopt);
}

}  // namespace
}  // namespace feelem::viewer::test
