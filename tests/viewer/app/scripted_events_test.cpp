// SPDX-License-Identifier: Apache-2.0
// A script's deeds as events of the window.
#include "viewer/app/scripted_events.hpp"

#include <gtest/gtest.h>

namespace feelem::viewer {
namespace {

TEST(ScriptedHand, presses_happen_where_the_mouse_was_moved_to) {
    ScriptedHand hand;
    const auto deeds = parse_script("0 move 0.25 0.5\n0 press right\n0 release right\n0 wheel -2", "t");
    const ScriptedFrame frame = hand.frame(deeds, {800, 600});
    ASSERT_EQ(frame.events.size(), 4U);
    EXPECT_EQ(frame.events[0].kind, DeskEvent::Kind::Moved);
    EXPECT_EQ(frame.events[1].kind, DeskEvent::Kind::Pressed);
    EXPECT_EQ(frame.events[1].button, 1);
    EXPECT_EQ(frame.events[1].at, glm::vec2(200, 300));
    EXPECT_EQ(frame.events[3].wheel.y, -2);
    EXPECT_FALSE(frame.quits);
}

TEST(ScriptedHand, a_key_goes_down_and_up_and_the_rest_is_for_the_program) {
    ScriptedHand hand;
    const ScriptedFrame frame =
        hand.frame(parse_script("0 key F\n0 screenshot a.png\n0 quit", "t"), {800, 600});
    ASSERT_EQ(frame.events.size(), 2U);
    EXPECT_EQ(frame.events[0].kind, DeskEvent::Kind::KeyDown);
    EXPECT_EQ(frame.events[0].text, "F");
    EXPECT_EQ(frame.events[1].kind, DeskEvent::Kind::KeyUp);
    EXPECT_EQ(frame.screenshots, std::vector<std::string>{"a.png"});
    EXPECT_TRUE(frame.quits);
}

TEST(ScriptedHand, keys_are_pressed_with_shift_and_control) {
    ScriptedHand hand;
    const ScriptedFrame frame = hand.frame(parse_script("0 hold Ctrl+S\n0 hold Shift+P", "t"), {800, 600});
    ASSERT_EQ(frame.events.size(), 2U);
    EXPECT_EQ(frame.events[0].text, "S");
    EXPECT_TRUE(frame.events[0].control);
    EXPECT_FALSE(frame.events[0].shift);
    EXPECT_EQ(frame.events[1].text, "P");
    EXPECT_TRUE(frame.events[1].shift);
}

}  // namespace
}  // namespace feelem::viewer
