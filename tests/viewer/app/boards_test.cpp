// SPDX-License-Identifier: Apache-2.0
// Boards of the room.
#include "viewer/app/boards.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace feelem::viewer {
namespace {

constexpr float kEyeHeight = 1.6F;
const glm::vec3 kEye{0, kEyeHeight, 0};

std::array<BoardPlace, kBoards> places(bool left_handed = false) {
    Look look;
    look.field = FieldChoice{};
    Snapshot snapshot;
    snapshot.probed.emplace();
    snapshot.probed->world = {0, 1, -1.2F};
    return place_boards(Stand{}, kEyeHeight, left_handed, snapshot, look, kEye);
}
const BoardPlace& of(const std::array<BoardPlace, kBoards>& all, Board board) {
    return all[static_cast<std::size_t>(board)];
}

TEST(Boards, their_fronts_look_at_the_eye) {
    const auto all = places();
    for (const BoardPlace& place : all) {
        ASSERT_TRUE(place.is_shown);
        const glm::vec3 front = place.pose.orientation * glm::vec3(0, 0, 1);
        EXPECT_GT(glm::dot(front, glm::normalize(kEye - place.pose.position)), 0.9999F);
        const glm::vec3 right = place.pose.orientation * glm::vec3(1, 0, 0);
        EXPECT_NEAR(right.y, 0, 1e-5) << "upright";
    }
}

TEST(Boards, panel_stands_left_and_legend_right_and_the_left_handed_have_it_mirrored) {
    EXPECT_LT(of(places(), Board::Panel).pose.position.x, -0.3F);
    EXPECT_GT(of(places(), Board::Legend).pose.position.x, 0.3F);
    EXPECT_GT(of(places(true), Board::Panel).pose.position.x, 0.3F);
    EXPECT_LT(of(places(true), Board::Legend).pose.position.x, -0.3F);
}

TEST(Boards, a_ray_at_the_panels_middle_presses_it_and_the_model_is_not_meant) {
    const auto all = places();
    const Pose panel = of(all, Board::Panel).pose;
    FrameInput input;
    input.time = 1;
    HandInput& hand = input.hands[1];
    hand.is_tracked = true;
    hand.aim.position = kEye;
    const glm::vec3 along = glm::normalize(panel.position - kEye);
    hand.aim.orientation = glm::rotation(glm::vec3(0, 0, -1), along);
    hand.trigger = 1;
    BoardPointer pointer;
    const PanelInput pressed = pointer.point(input, all);
    ASSERT_TRUE(pressed.at);
    const glm::vec2 middle = glm::vec2(size_of(Board::Panel).pixels) / 2.0F;
    EXPECT_NEAR(pressed.at->x, middle.x, 2);
    EXPECT_NEAR(pressed.at->y, middle.y, 2);
    EXPECT_TRUE(pressed.buttons[0]);
    EXPECT_NEAR(hand.panel_distance.value_or(0), glm::distance(kEye, panel.position), 1e-3);

    input.is_focused = false;
    EXPECT_FALSE(pointer.point(input, all).buttons[0]) << "the headset's own menu stands before it";
    input.is_focused = true;
    hand.aim.orientation = glm::quat(1, 0, 0, 0);
    EXPECT_FALSE(pointer.point(input, all).at);
    EXPECT_FALSE(hand.panel_distance);
}

TEST(Boards, a_trigger_pulled_on_the_model_presses_nothing_when_it_comes_across_the_panel) {
    const auto all = places();
    FrameInput input;
    HandInput& hand = input.hands[1];
    hand.is_tracked = true;
    hand.aim.position = kEye;
    hand.trigger = 1;
    BoardPointer pointer;
    EXPECT_FALSE(pointer.point(input, all).at);
    const glm::vec3 along = glm::normalize(of(all, Board::Panel).pose.position - kEye);
    hand.aim.orientation = glm::rotation(glm::vec3(0, 0, -1), along);
    const PanelInput swept = pointer.point(input, all);
    EXPECT_TRUE(swept.at);
    EXPECT_FALSE(swept.buttons[0]);
    hand.trigger = 0;
    EXPECT_FALSE(pointer.point(input, all).buttons[0]);
    hand.trigger = 1;
    EXPECT_TRUE(pointer.point(input, all).buttons[0]);
}

TEST(Boards, the_card_stands_above_the_place_and_does_not_hide_it) {
    const auto all = places();
    const BoardPlace& card = of(all, Board::Card);
    const glm::vec3 lower = card.pose.position - card.pose.orientation * glm::vec3(0, card.size.y / 2, 0);
    const auto height_angle = [](const glm::vec3& at) {
        return std::atan2(at.y - kEye.y, std::hypot(at.x - kEye.x, at.z - kEye.z));
    };
    EXPECT_GT(height_angle(lower), height_angle({0, 1, -1.2F}));
}

TEST(Boards, the_card_covers_the_same_angle_at_any_distance) {
    Look look;
    Snapshot snapshot;
    snapshot.probed.emplace();
    const auto angle_at = [&](float away) {
        snapshot.probed->world = {0, kEyeHeight, -away};
        const auto all = place_boards(Stand{}, kEyeHeight, false, snapshot, look, kEye);
        const BoardPlace& card = of(all, Board::Card);
        return card.size.x / glm::distance(card.pose.position, kEye);
    };
    EXPECT_NEAR(angle_at(0.5F), angle_at(4), 1e-4);
}

}  // namespace
}  // namespace feelem::viewer
