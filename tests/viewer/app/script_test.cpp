// SPDX-License-Identifier: Apache-2.0
// Scripts of the desk.
#include "viewer/app/script.hpp"

#include "feelem/error.hpp"

#include <gmock/gmock.h>

namespace feelem::viewer {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
    try {
        (void)parse_script(text, "talk.txt");
    } catch (const Error& error) {
        return error.what();
    }
    return "taken";
}

TEST(Script, deeds_come_in_order_of_time) {
    const auto deeds = parse_script("2 key F   # fit\n\n1 move 0.25 0.75\n2 press left\n", "talk.txt");
    ASSERT_EQ(deeds.size(), 3U);
    EXPECT_EQ(deeds[0].deed, Deed::Move);
    EXPECT_EQ(deeds[0].x, 0.25);
    EXPECT_EQ(deeds[0].y, 0.75);
    EXPECT_EQ(deeds[1].word, "F");
    EXPECT_EQ(deeds[2].deed, Deed::Press);
}

TEST(Script, a_glide_is_sixty_moves_a_second_from_end_to_end) {
    const auto deeds = parse_script("1 glide 0 0 1 0.5 0.5", "talk.txt");
    ASSERT_EQ(deeds.size(), 31U);
    EXPECT_EQ(deeds.front().x, 0);
    EXPECT_DOUBLE_EQ(deeds[15].x, 0.5);
    EXPECT_EQ(deeds.back().x, 1);
    EXPECT_EQ(deeds.back().y, 0.5);
    EXPECT_DOUBLE_EQ(deeds.back().at, 1.5);
}

TEST(Script, the_player_gives_each_deed_once_and_late_ones_too) {
    ScriptPlayer player(parse_script("0 key A\n1 key B\n5 quit", "talk.txt"));
    EXPECT_EQ(player.due(0.5).size(), 1U);
    EXPECT_EQ(player.due(0.9).size(), 0U);
    EXPECT_FALSE(player.is_done());
    EXPECT_EQ(player.due(7).size(), 2U);
    EXPECT_TRUE(player.is_done());
}

TEST(Script, what_cannot_be_understood_names_its_line_and_what_there_is) {
    EXPECT_THAT(
        refusal("0 key A\n1 presss left"), testing::AllOf(HasSubstr("talk.txt:2"), HasSubstr("\"press\""))
    );
    EXPECT_THAT(refusal("1 move 0.5"), HasSubstr("1.5 move 0.5 0.5"));
    EXPECT_THAT(refusal("1 press lefty"), HasSubstr("no button \"lefty\""));
    EXPECT_THAT(refusal("1 release Left"), HasSubstr("left, right or middle"));
    EXPECT_THAT(refusal("soon quit"), HasSubstr("\"soon\" is not a number"));
    EXPECT_THAT(refusal("-1 quit"), HasSubstr("begins at 0"));
    EXPECT_THAT(refusal("1 glide 0 0 1 1 1e9"), HasSubstr("1e9"));
    EXPECT_THAT(refusal("1 move nan 0"), HasSubstr("nan"));
    EXPECT_THAT(refusal("3"), HasSubstr("expected SECONDS"));
}

}  // namespace
}  // namespace feelem::viewer
