// SPDX-License-Identifier: Apache-2.0
// The way to the largest value by ear: rank among the values there are, ticks from 1.5 to 12 a second.
#include "support/paths.hpp"
#include "viewer/core/guidance.hpp"
#include "viewer/core/room_of_hands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

namespace feelem::viewer::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Guidance, rank_and_rate_are_those_of_the_contract) {
    const auto contract =
        nlohmann::json::parse(feelem::test::read_file(feelem::test::project_file("tests/contract/guide.json"))
        );
    ASSERT_GT(contract.at("guide").size(), 5U);
    for (const auto& row : contract.at("guide")) {
        const std::vector<float> sorted = row["sorted"];
        const double rank = rank_of(sorted, row["value"]);
        EXPECT_NEAR(rank, row["rank"], 1e-12) << row;
        EXPECT_NEAR(guide_rate(rank), row["rate"], 1e-9) << row;
    }
    EXPECT_EQ(rank_of({}, 3), 0);
    const std::vector<float> some{1, 2};
    EXPECT_EQ(rank_of(some, std::nan("")), 0);
    EXPECT_EQ(guide_rate(-1), 1.5);
    EXPECT_EQ(guide_rate(2), 12);
}

TEST(Guidance, ticks_alone_tell_the_rank_of_what_is_seen_and_the_top_is_said_once) {
    Ready ready(sensed_squares());
    ViewerState& state = ready.viewer.state;
    state.events.enter = false;
    FrameInput input;
    input.hold = true;
    input.head.position = {0, 0, 3};
    const auto at = [&](std::int64_t node) {
        state.pin = node;
        return ready.frame(input, 1);
    };
    EXPECT_GT(at(4).sound.value().gain, 0);
    run(state, ready.viewer.model, Command::ToggleGuide, {});
    ASSERT_TRUE(state.guide);
    const Snapshot low = at(1), high = at(11);
    EXPECT_EQ(low.sound.value().gain, 0) << "no tone";
    EXPECT_LT(low.sound->tick_rate, 2);
    EXPECT_THAT(low.events, IsEmpty()) << "the smallest is no news here";
    EXPECT_EQ(high.sound.value().tick_rate, 12);
    EXPECT_THAT(high.events, ElementsAre(SenseEvent::Maximum));
    EXPECT_THAT(at(11).events, IsEmpty());
    state.sound = false;
    EXPECT_FALSE(at(11).sound);
    state.sound = true;
    run(state, ready.viewer.model, Command::ToggleGuide, {});
    EXPECT_GT(at(4).sound.value().gain, 0);
}

TEST(Guidance, only_what_can_be_seen_is_ranked) {
    Ready ready(sensed_squares());
    ViewerState& state = ready.viewer.state;
    const ViewedModel& model = ready.viewer.model;
    const auto seen = find_field(model.about(), state.presentation.results[0], state.step);
    ASSERT_TRUE(seen);
    const FieldSpan field = model.values(*seen);
    const PartSpan& first = model.arrays().parts.at(0);
    double largest = -1e30;
    for (std::size_t v = first.first_vertex; v < first.first_vertex + first.vertices; ++v)
        largest = std::max(largest, double{field.values[v * field.components + seen->component]});
    RankList ranks;
    const double among_all = ranks.rank(state, model, *seen, largest);
    EXPECT_LT(among_all, 1);
    state.parts.at(1) = PartLook::Hidden;
    EXPECT_EQ(ranks.rank(state, model, *seen, largest), 1) << "the other part's larger values are hidden";
    state.parts.at(1) = PartLook::Clear;
    EXPECT_EQ(ranks.rank(state, model, *seen, largest), among_all) << "a clear part is seen";
}

}  // namespace
}  // namespace feelem::viewer::test
