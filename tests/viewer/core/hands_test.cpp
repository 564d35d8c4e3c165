// SPDX-License-Identifier: Apache-2.0
// What hands do in the room, row by row of docs/interaction.md.
#include "viewer/core/handles.hpp"
#include "viewer/core/room_of_hands.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace feelem::viewer::test {
namespace {

/// A place on the near square, not on an edge.
constexpr glm::vec3 kOnModel(0.7F, 0.4F, 0);

TEST(Hands, model_stands_on_the_table_before_the_person_and_nothing_moves_by_itself) {
    Room room(sensed_squares());
    const glm::vec3 middle = room.world({0.5F, 0.5F, -0.5F});
    EXPECT_NEAR(middle.x, 0, 1e-5);
    EXPECT_NEAR(middle.y, 1, 1e-5);
    EXPECT_LT(middle.z, -1.1);
    EXPECT_NEAR(glm::distance(room.world({0, 0, 0}), room.world({1, 0, 0})), 0.8, 1e-5);
    const glm::mat4 before = room.viewer.state.placement;
    room.input.head.position = {0.4F, 1.2F, 0.3F};
    for (int i = 0; i < 200; ++i) room.next(0.05);
    EXPECT_EQ(room.viewer.state.placement, before);
}

TEST(Hands, the_room_turns_with_whoever_looks_elsewhere_when_they_come) {
    Ready ready(sensed_squares());
    FrameInput input;
    input.is_headset = true;
    input.head = looking({2, 1.1F, 3}, {3, 1.1F, 3});
    ready.frame(input);
    const glm::mat4 to_world = model_to_world(ready.viewer.state, ready.viewer.model);
    const glm::vec3 middle(to_world * glm::vec4(0.5F, 0.5F, -0.5F, 1));
    EXPECT_GT(middle.x, 3.1F);
    EXPECT_NEAR(middle.z, 3, 1e-4);
    EXPECT_TRUE(ready.viewer.interaction.boards_moved);
    ready.frame(input);
    EXPECT_FALSE(ready.viewer.interaction.boards_moved);
}

TEST(Hands, a_ray_reads_and_the_trigger_makes_it_heard_and_felt) {
    Room room(sensed_squares());
    room.point(kRight, room.world(kOnModel));
    Snapshot now = room.next();
    ASSERT_TRUE(now.probed);
    EXPECT_EQ(now.pointer, Pointer::Right);
    EXPECT_FALSE(now.is_held || now.sound || now.touch[kRight]);
    EXPECT_NEAR(now.probed->readings.at(0).value, 10 + 10 * 0.7 + 10 * 0.4, 1e-3);
    room.hand(kRight).trigger = 0.9F;
    now = room.next();
    EXPECT_TRUE(now.is_held && now.sound && now.touch[kRight]);
    EXPECT_FALSE(now.touch[kLeft]);
    room.hand(kRight).trigger = 0.5F;
    EXPECT_TRUE(room.next().is_held) << "a finger that tires a little still presses";
    room.hand(kRight).trigger = 0.1F;
    now = room.next();
    EXPECT_FALSE(now.is_held || now.sound || now.touch[kRight]);
    ASSERT_TRUE(now.probed);
}

TEST(Hands, a_tip_within_three_centimetres_reads_without_a_ray) {
    Room room(sensed_squares());
    HandInput& hand = room.hand(kRight);
    hand.aim.position = room.world(kOnModel) + glm::vec3(0, 0, 0.025F);
    room.point_away(kRight);
    Snapshot now = room.next();
    ASSERT_TRUE(now.probed);
    EXPECT_TRUE(room.at_hand(kRight).touches);
    EXPECT_FALSE(room.at_hand(kRight).ray_length);
    EXPECT_FALSE(now.is_held);
    room.viewer.state.person.by_touch = true;
    EXPECT_TRUE(room.next().is_held) << "who wants it hears by touch alone";
    hand.aim.position.z += 0.01F;
    now = room.next();
    EXPECT_FALSE(now.probed || now.is_held);
    EXPECT_TRUE(room.at_hand(kRight).ray_length);
}

TEST(Hands, a_bare_hand_touches_by_its_finger) {
    Room room(sensed_squares());
    HandInput& hand = room.hand(kRight);
    hand.is_bare = true;
    hand.fingertip = room.world(kOnModel) + glm::vec3(0, 0, 0.01F);
    EXPECT_TRUE(room.next().probed);
    hand.trigger = 1;
    EXPECT_TRUE(room.next().is_held);
}

TEST(Hands, one_grip_carries_the_model_as_the_hand_goes_and_turns) {
    Room room(sensed_squares());
    const glm::vec3 before = room.world(kOnModel);
    room.hand(kRight).squeeze = 1;
    room.next();
    EXPECT_LT(glm::distance(room.world(kOnModel), before), 1e-5F) << "taking hold moves nothing";
    room.move(kRight, {0.1F, 0.2F, -0.3F});
    room.next();
    EXPECT_LT(glm::distance(room.world(kOnModel), before + glm::vec3(0.1F, 0.2F, -0.3F)), 1e-4F);
    room.hand(kRight).grip.orientation = glm::angleAxis(glm::radians(90.0F), glm::vec3(0, 0, 1));
    room.next();
    const glm::vec3 grip = room.hand(kRight).grip.position;
    const glm::vec3 arm = before + glm::vec3(0.1F, 0.2F, -0.3F) - grip;
    EXPECT_LT(glm::distance(room.world(kOnModel), grip + glm::vec3(-arm.y, arm.x, arm.z)), 1e-4F);
    room.hand(kRight).squeeze = 0;
    room.next();
    const glm::vec3 left = room.world(kOnModel);
    room.move(kRight, {1, 0, 0});
    room.next();
    EXPECT_EQ(room.world(kOnModel), left);
}

TEST(Hands, two_grips_scale_about_their_middle_and_keep_the_model_upright) {
    Room room(sensed_squares());
    room.hand(kLeft).squeeze = room.hand(kRight).squeeze = 1;
    room.next();
    const auto side = [&] { return glm::distance(room.world({0, 0, 0}), room.world({1, 0, 0})); };
    const float before = side();
    room.move(kLeft, {-0.3F, 0.4F, 0});
    room.move(kRight, {0.3F, -0.4F, 0});
    room.next();
    const float wide = std::hypot(1.2F, 0.8F);
    EXPECT_NEAR(side() / before, wide / 0.6F, 1e-4);
    const glm::vec3 up = room.world({0, 1, 0}) - room.world({0, 0, 0});
    EXPECT_NEAR(glm::normalize(up).y, 1, 1e-5);
    room.viewer.state.person.upright = false;
    room.next();
    const glm::vec3 leaning = room.world({0, 1, 0}) - room.world({0, 0, 0});
    EXPECT_LT(glm::normalize(leaning).y, 0.95F);
}

TEST(Hands, letting_go_with_one_of_two_hands_does_not_make_the_model_jump) {
    Room room(sensed_squares());
    room.hand(kLeft).squeeze = room.hand(kRight).squeeze = 1;
    room.next();
    room.move(kRight, {0.2F, 0, 0});
    room.next();
    const glm::vec3 before = room.world(kOnModel);
    room.hand(kLeft).squeeze = 0;
    room.next();
    EXPECT_LT(glm::distance(room.world(kOnModel), before), 1e-5F);
}

TEST(Hands, the_trigger_on_the_bar_under_the_model_carries_it) {
    Room room(sensed_squares());
    const auto bar = bar_of(room.viewer.state, room.viewer.model, room.input.head.position);
    EXPECT_LT(bar[0].y, room.world({0, 0, 0}).y);
    EXPECT_NEAR(glm::distance(bar[0], bar[1]), 0.2, 1e-4);
    room.point(kRight, (bar[0] + bar[1]) / 2.0F);
    room.hand(kRight).trigger = 1;
    room.next();
    EXPECT_EQ(room.at_hand(kRight).holds, Holds::Carried);
    const glm::vec3 before = room.world(kOnModel);
    room.next();
    room.move(kRight, {0, 0.1F, 0});
    EXPECT_FALSE(room.next().is_held);
    EXPECT_NEAR(room.world(kOnModel).y, before.y + 0.1F, 1e-5);
}

TEST(Hands, a_pinch_on_nothing_carries_but_a_trigger_on_nothing_does_not) {
    Room room(sensed_squares());
    room.hand(kRight).trigger = 1;
    room.next();
    EXPECT_EQ(room.at_hand(kRight).holds, Holds::Model);
    room.hand(kLeft).is_bare = true;
    room.hand(kLeft).trigger = 1;
    room.next();
    EXPECT_EQ(room.at_hand(kLeft).holds, Holds::Carried);
}

TEST(Hands, the_lower_button_leaves_a_note_at_the_nearest_node) {
    Room room(sensed_squares());
    room.hand(kRight).lower_button = true;
    room.next();
    EXPECT_TRUE(room.viewer.state.markers.empty()) << "it points at nothing";
    room.hand(kRight).lower_button = false;
    room.point(kRight, room.world({0.9F, 0.05F, 0}));
    room.next();
    room.hand(kRight).lower_button = true;
    room.next();
    room.next();
    ASSERT_EQ(room.viewer.state.markers.size(), 1u);
    EXPECT_EQ(room.viewer.state.markers[0].node, 2);
}

TEST(Hands, a_pinch_that_rests_is_offered_a_note_and_takes_it_by_letting_go) {
    Room room(sensed_squares());
    HandInput& hand = room.hand(kRight);
    hand.is_bare = true;
    room.point(kRight, room.world({0.9F, 0.05F, 0}));
    hand.trigger = 1;
    room.next();
    room.next(0.5);
    EXPECT_EQ(room.at_hand(kRight).ring, 0);
    room.next(0.2);
    EXPECT_GT(room.at_hand(kRight).ring, 0);
    hand.trigger = 0;
    room.next();
    ASSERT_EQ(room.viewer.state.markers.size(), 1u);
    hand.trigger = 1;
    room.next();
    room.next(2.5);
    EXPECT_EQ(room.at_hand(kRight).ring, 0) << "who only listens is left alone again";
    hand.trigger = 0;
    room.next();
    EXPECT_EQ(room.viewer.state.markers.size(), 1u);
}

TEST(Hands, a_stick_to_the_side_turns_the_person_by_thirty_degrees_once_a_push) {
    Room room(sensed_squares());
    const glm::vec3 before = room.world(kOnModel);
    room.hand(kRight).stick = {-0.9F, 0};
    room.next();
    room.next();
    // To the left: what was ahead is now to the right.
    const glm::quat turn = glm::angleAxis(glm::radians(-30.0F), glm::vec3(0, 1, 0));
    const glm::vec3 head = room.input.head.position;
    EXPECT_LT(glm::distance(room.world(kOnModel), head + turn * (before - head)), 1e-4F);
    room.hand(kRight).stick = {-0.5F, 0};
    room.next();
    room.hand(kRight).stick = {-0.9F, 0};
    room.next();
    EXPECT_LT(glm::distance(room.world(kOnModel), head + turn * (before - head)), 1e-4F)
        << "a trembling thumb is one push";
}

TEST(Hands, a_stick_ahead_shows_a_ring_and_goes_there_on_release) {
    Room room(sensed_squares());
    const glm::vec3 before = room.world(kOnModel);
    room.point(kRight, {0.5F, 0, 1});
    room.hand(kRight).stick = {0, 0.9F};
    room.next();
    ASSERT_TRUE(room.viewer.interaction.ring);
    EXPECT_NEAR(room.viewer.interaction.ring->x, 0.5F, 1e-4);
    EXPECT_EQ(room.world(kOnModel), before) << "not before it is let go";
    room.hand(kRight).stick = {0, 0};
    room.next();
    EXPECT_FALSE(room.viewer.interaction.ring);
    EXPECT_LT(glm::distance(room.world(kOnModel), before - glm::vec3(0.5F, 0, 1)), 1e-4F);
    room.hand(kRight).aim = looking(room.hand(kRight).aim.position, {0, 3, -2});
    room.hand(kRight).stick = {0, 0.9F};
    room.next();
    EXPECT_FALSE(room.viewer.interaction.ring) << "it points at no floor";
}

TEST(Hands, the_other_hand_steps_changes_the_result_mutes_and_carries_the_plane) {
    Scene scene = sensed_squares();
    add_result_to(scene, "pressure", {"value"}, {std::vector<float>(8, 1)});
    scene.presentation.results.push_back(presented("P", "pressure", "value"));
    Room room(scene);
    room.hand(kLeft).stick = {0.9F, 0};
    room.next();
    room.next();
    EXPECT_EQ(room.viewer.state.step, 1u);
    room.hand(kLeft).upper_button = true;
    room.next();
    room.next();
    EXPECT_EQ(result_of(room.viewer.state.presentation, Sense::Colour)->key, "P");
    room.hand(kLeft).stick_pressed = true;
    room.next();
    EXPECT_FALSE(room.viewer.state.sound);
    room.hand(kLeft).lower_button = true;
    room.next();
    ASSERT_EQ(cuts_of(room.viewer.state).size(), 1u);
    const CutPlane plane = cuts_of(room.viewer.state)[0];
    const glm::vec3 hand(
        glm::inverse(model_to_world(room.viewer.state, room.viewer.model)) *
        glm::vec4(room.hand(kLeft).aim.position, 1)
    );
    EXPECT_NEAR(glm::dot(plane.normal, hand), plane.offset, 1e-3);
}

TEST(Hands, left_handed_mirrors_the_buttons) {
    Room room(sensed_squares());
    room.viewer.state.person.left_handed = true;
    room.hand(kRight).stick = {0.9F, 0};
    room.next();
    EXPECT_EQ(room.viewer.state.step, 1u);
}

TEST(Hands, a_pressed_stick_brings_everything_home) {
    Room room(sensed_squares());
    const glm::mat4 first = room.viewer.state.placement;
    room.hand(kRight).squeeze = 1;
    room.next();
    room.move(kRight, {0.5F, 0.5F, 0});
    room.next();
    room.hand(kRight).squeeze = 0;
    room.hand(kRight).stick_pressed = true;
    room.next();
    room.next();
    for (int i = 0; i < 4; ++i) EXPECT_LT(glm::distance(room.viewer.state.placement[i], first[i]), 1e-5F);
}

TEST(Hands, the_knob_of_a_plane_is_dragged_by_the_ray) {
    Room room(sensed_squares());
    add_cut(room.viewer.state, room.viewer.model);
    const glm::vec3 knob = *knobs_of(room.viewer.state, room.viewer.model).at(0);
    room.point(kRight, knob);
    room.hand(kRight).trigger = 1;
    EXPECT_FALSE(room.next().is_held);
    EXPECT_EQ(room.at_hand(kRight).holds, Holds::Knob);
    room.point(kRight, knob + glm::vec3(0.08F, 0, 0));
    room.next();
    EXPECT_NEAR(room.viewer.state.cuts[0].plane.offset, 0.6, 1e-3) << "8 cm at 0.8 m a unit";
    room.hand(kRight).trigger = 0;
    room.next();
    room.point(kRight, knob);
    room.next();
    EXPECT_NEAR(room.viewer.state.cuts[0].plane.offset, 0.6, 1e-3);
}

TEST(Hands, a_panel_before_the_model_takes_ray_and_trigger_but_not_the_grip) {
    Room room(sensed_squares());
    room.point(kRight, room.world(kOnModel));
    room.hand(kRight).panel_distance = 0.4F;
    EXPECT_FALSE(room.next().probed);
    EXPECT_EQ(room.at_hand(kRight).holds, Holds::Panel);
    EXPECT_EQ(room.at_hand(kRight).ray_length, 0.4F);
    room.hand(kRight).trigger = 1;
    EXPECT_FALSE(room.next().is_held);
    room.hand(kRight).panel_distance.reset();
    EXPECT_FALSE(room.next().is_held) << "who slides off the panel has not pressed the model";
    room.hand(kRight).trigger = 0;
    EXPECT_TRUE(room.next().probed);
    room.hand(kRight).panel_distance = 0.4F;
    room.hand(kRight).squeeze = 1;
    room.next();
    const glm::vec3 before = room.world(kOnModel);
    room.move(kRight, {0, 0.1F, 0});
    room.next();
    EXPECT_NEAR(room.world(kOnModel).y, before.y + 0.1F, 1e-5);
}

TEST(Hands, a_lost_hand_is_silent_at_once_leaves_a_ghost_and_moves_nothing_when_it_comes_back) {
    Room room(sensed_squares());
    room.point(kRight, room.world(kOnModel));
    room.hand(kRight).trigger = room.hand(kRight).squeeze = 1;
    EXPECT_TRUE(room.next().is_held);
    const glm::mat4 before = room.viewer.state.placement;
    const Pose grip = room.hand(kRight).grip;
    room.hand(kRight).is_tracked = false;
    room.hand(kRight).grip = {};
    const Snapshot lost = room.next();
    EXPECT_FALSE(lost.is_held || lost.sound || lost.touch[kRight] || lost.probed);
    ASSERT_TRUE(room.at_hand(kRight).ghost);
    EXPECT_EQ(room.at_hand(kRight).ghost->position, grip.position);
    room.next(0.3);
    EXPECT_TRUE(room.at_hand(kRight).ghost);
    // Soon back, and still pressed: it goes on where it is now.
    room.hand(kRight).is_tracked = true;
    room.hand(kRight).grip = grip;
    room.hand(kRight).grip.position.x += 0.4F;
    EXPECT_TRUE(room.next().is_held);
    EXPECT_EQ(room.viewer.state.placement, before);
    room.hand(kRight).is_tracked = false;
    room.next();
    room.next(0.6);
    EXPECT_FALSE(room.at_hand(kRight).ghost);
    room.hand(kRight).is_tracked = true;
    const Snapshot back = room.next();
    EXPECT_TRUE(back.probed);
    EXPECT_FALSE(back.is_held) << "after so long only a new press counts";
    room.move(kRight, {0, 0.2F, 0});
    room.next();
    EXPECT_EQ(room.viewer.state.placement, before);
}

TEST(Hands, without_focus_everything_stops_until_it_is_pressed_again) {
    Room room(sensed_squares());
    room.point(kRight, room.world(kOnModel));
    room.hand(kRight).trigger = room.hand(kLeft).squeeze = 1;
    EXPECT_TRUE(room.next().is_held);
    const glm::mat4 before = room.viewer.state.placement;
    room.input.is_focused = false;
    room.move(kLeft, {0.3F, 0, 0});
    const Snapshot away = room.next();
    EXPECT_FALSE(away.is_held || away.sound || away.touch[kRight] || away.probed);
    room.input.is_focused = true;
    room.move(kLeft, {0.3F, 0, 0});
    EXPECT_FALSE(room.next().is_held);
    room.move(kLeft, {0.3F, 0, 0});
    room.next();
    EXPECT_EQ(room.viewer.state.placement, before);
    room.hand(kRight).trigger = 0;
    room.next();
    room.hand(kRight).trigger = 1;
    EXPECT_TRUE(room.next().is_held);
}

TEST(Hands, of_two_hands_the_one_that_pressed_last_is_heard_and_both_are_felt) {
    Room room(sensed_squares());
    room.point(kLeft, room.world({0.2F, 0.6F, 0}));
    room.point(kRight, room.world(kOnModel));
    room.hand(kRight).trigger = 1;
    EXPECT_EQ(room.next().pointer, Pointer::Right);
    room.hand(kLeft).trigger = 1;
    const Snapshot now = room.next();
    EXPECT_EQ(now.pointer, Pointer::Left);
    EXPECT_TRUE(now.touch[kLeft] && now.touch[kRight]);
    EXPECT_NE(now.touch[kLeft]->rate, now.touch[kRight]->rate);
}

TEST(Hands, a_button_that_is_down_when_a_hand_comes_is_no_press) {
    Room room(sensed_squares());
    room.hand(kLeft).is_tracked = false;
    room.next();
    room.hand(kLeft).upper_button = room.hand(kLeft).stick_pressed = true;
    room.hand(kLeft).is_tracked = true;
    room.next();
    EXPECT_TRUE(room.viewer.state.sound);
}

TEST(Hands, a_hand_or_head_whose_place_is_no_number_moves_nothing) {
    Room room(sensed_squares());
    const float nowhere = std::nanf("");
    room.hand(kRight).squeeze = 1;
    room.next();
    const glm::mat4 before = room.viewer.state.placement;
    const Pose grip = room.hand(kRight).grip;
    room.hand(kRight).grip.position.x = nowhere;
    room.hand(kRight).aim.position.x = nowhere;
    EXPECT_FALSE(room.next().probed);
    EXPECT_EQ(room.viewer.state.placement, before);
    room.hand(kRight).grip = grip;
    room.move(kRight, {0, 0.1F, 0});
    room.next();
    EXPECT_NE(room.viewer.state.placement, before) << "it is held as before";
    room.hand(kRight).squeeze = 0;
    room.viewer.state.stand.reset();
    const glm::mat4 there = room.viewer.state.placement;
    room.input.head.position.y = room.input.head.position.z = nowhere;
    room.next();
    EXPECT_EQ(room.viewer.state.placement, there);
    EXPECT_FALSE(room.viewer.state.stand) << "the room waits until the head is somewhere";
}

}  // namespace
}  // namespace feelem::viewer::test
