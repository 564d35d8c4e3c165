// SPDX-License-Identifier: Apache-2.0
// How fine the picture is.
#include "viewer/core/governor.hpp"

#include <gtest/gtest.h>

namespace feelem::viewer {
namespace {

constexpr double kBudget = 1.0 / 90;

void round_of(Governor& governor, double share) {
    for (std::size_t i = 0; i < kGovernorRound; ++i) govern(governor, share * kBudget, kBudget);
}

TEST(Governor, slow_frames_make_the_picture_coarser_a_step_a_round_and_far_too_slow_ones_two) {
    Governor governor;
    round_of(governor, 1.2);
    EXPECT_EQ(governor.level, 0U) << "a little late is no reason";
    round_of(governor, 2);
    EXPECT_EQ(governor.level, 1U);
    round_of(governor, 10);
    EXPECT_EQ(governor.level, 3U);
    for (int i = 0; i < 9; ++i) round_of(governor, 100);
    EXPECT_EQ(governor.level, kFineness.size() - 1);
}

TEST(Governor, quick_frames_bring_the_finer_level_back_when_it_may_be_in_time) {
    Governor governor;
    governor.level = 2;
    round_of(governor, 0.7);
    EXPECT_EQ(governor.level, 2U) << "0.7 of the time at 0.6 of the resolution would be 1.09";
    round_of(governor, 0.5);
    EXPECT_EQ(governor.level, 1U);
}

TEST(Governor, a_finer_level_tried_in_vain_is_tried_again_more_rarely) {
    Governor governor;
    governor.level = 1;
    int quick_rounds = 0;
    for (const int expected : {1, 2, 4, 8, 16, 16}) {
        for (quick_rounds = 0; governor.level == 1; ++quick_rounds) round_of(governor, 0.3);
        EXPECT_EQ(quick_rounds, expected);
        round_of(governor, 2);
        EXPECT_EQ(governor.level, 1U);
    }
}

TEST(Governor, one_late_frame_and_a_sleep_change_nothing) {
    Governor governor;
    for (std::size_t i = 0; i < 60; ++i)
        govern(governor, i % kGovernorRound == 3 ? 20 * kBudget : 0.5 * kBudget, kBudget);
    EXPECT_EQ(governor.level, 0U);
    for (int i = 0; i < 60; ++i) govern(governor, 4, kBudget);
    EXPECT_EQ(governor.level, 0U);
}

}  // namespace
}  // namespace feelem::viewer
