// SPDX-License-Identifier: Apache-2.0
// Controllers of every make, and bare hands, as one kind of input.
#include "viewer/xr/actions.hpp"
#include "viewer/xr/stay.hpp"

#include <gmock/gmock.h>

namespace feelem::viewer {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Press {
    std::vector<const char*> inputs;  ///< Of the right hand, all at 1 for three frames, and then at 0.
    const char* part;                 ///< What that is; empty: nothing.
};

struct Controller {
    const char *name, *profile, *title;
    std::vector<Press> presses;
};

/// All that the hand does; empty: nothing.
std::string parts_of(const HandInput& hand) {
    std::string text;
    const auto add = [&](bool is_on, const char* part) { text += is_on ? part : ""; };
    add(hand.trigger == 1, "trigger");
    add(hand.squeeze == 1, "squeeze");
    add(hand.stick.x == 1, "stick");
    add(hand.stick_pressed, "pressed stick");
    add(hand.lower_button, "lower");
    add(hand.upper_button, "upper");
    add(hand.menu, "menu");
    return text;
}

void PrintTo(const Controller& controller, std::ostream* out) {
    *out << controller.name;
}

class XrControllers : public testing::TestWithParam<Controller> {
protected:
    void SetUp() override {
        try {
            const GlContext context;
        } catch (const std::exception& error) {
            GTEST_SKIP() << "no OpenGL here: " << error.what();
        }
    }
};

TEST_P(XrControllers, every_part_does_what_it_is_for_and_nothing_else) {
    const Controller& controller = GetParam();
    std::string script = "0 pose right 0.25 1.3 -0.4\n";
    for (const char* side : {"left", "right"})
        script += std::string("0 profile ") + side + " " + controller.profile + "\n";
    std::vector<std::string> wanted;
    int frame = 12;
    for (const Press& press : controller.presses) {
        for (const char* input : press.inputs) {
            script += std::to_string(frame) + " input right " + input + " 1\n";
            script += std::to_string(frame + 3) + " input right " + input + " 0\n";
        }
        frame += 6;
        wanted.push_back(press.part);
    }
    Stay stay(script);
    std::vector<std::string> seen(controller.presses.size());
    int count = 0;
    stay.draw = [&](const XrFrame& each) {
        const std::string parts = parts_of(each.input.hands[1]);
        const auto at = static_cast<std::size_t>((count - 12) / 6);
        const int phase = count < 12 ? 5 : (count - 12) % 6;
        if (phase == 1 && at < seen.size()) seen[at] = parts;
        EXPECT_TRUE(phase < 3 || parts.empty())
            << "nothing is pressed in frame " << count << ", but " << parts;
        EXPECT_EQ(parts_of(each.input.hands[0]), "") << "the left hand does nothing";
        ++count;
    };
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(static_cast<std::size_t>(frame)));
    const HandInput& hand = stay.last.input.hands[1];

    EXPECT_EQ(seen, wanted);
    EXPECT_TRUE(hand.is_tracked);
    EXPECT_FALSE(hand.is_bare);
    EXPECT_TRUE(hand.can_vibrate);
    EXPECT_NEAR(hand.aim.position.x, 0.25, 1e-5);
    EXPECT_NEAR(hand.aim.position.y, 1.3, 1e-5);
    EXPECT_NEAR(hand.grip.position.z, -0.35, 1e-5);
    EXPECT_EQ(stay.system->status().input, controller.title);
    EXPECT_TRUE(stay.system->haptics(Side::Right).pulse(0.5, 35));
    stay.end();
    EXPECT_EQ(stay.record("haptic")[0]["felt"], true);
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    all,
    XrControllers,
    testing::Values(
        Controller{
            "simple",
            "/interaction_profiles/khr/simple_controller",
            "simple controllers",
            {{{"select/click"}, "trigger"}, {{"menu/click"}, "upper"}}},
        Controller{
            "touch",
            "/interaction_profiles/oculus/touch_controller",
            "Touch controllers",
            {{{"trigger/value"}, "trigger"},
             {{"squeeze/value"}, "squeeze"},
             {{"thumbstick/x"}, "stick"},
             {{"thumbstick/click"}, "pressed stick"},
             {{"a/click"}, "lower"},
             {{"b/click"}, "upper"}}},
        Controller{
            "index",
            "/interaction_profiles/valve/index_controller",
            "Index controllers",
            {{{"trigger/value"}, "trigger"},
             {{"squeeze/value"}, ""},
             {{"squeeze/force"}, "squeeze"},
             {{"thumbstick/x"}, "stick"},
             {{"thumbstick/click"}, "pressed stick"},
             {{"a/click"}, "lower"},
             {{"b/click"}, "upper"}}},
        Controller{
            "vive",
            "/interaction_profiles/htc/vive_controller",
            "Vive wands",
            {{{"trigger/value"}, "trigger"},
             {{"squeeze/click"}, "squeeze"},
             {{"trackpad/x"}, ""},
             {{"trackpad/click"}, "pressed stick"},
             {{"trackpad/x", "trackpad/click"}, "stick"},
             {{"menu/click"}, "upper"}}},
        Controller{
            "wmr",
            "/interaction_profiles/microsoft/motion_controller",
            "Mixed Reality controllers",
            {{{"trigger/value"}, "trigger"},
             {{"squeeze/click"}, "squeeze"},
             {{"thumbstick/x"}, "stick"},
             {{"thumbstick/click"}, "pressed stick"},
             {{"trackpad/click"}, "lower"},
             {{"menu/click"}, "upper"}}}
    ),
    [](const auto& each) { return std::string(each.param.name); }
);

using XrInput = NeedsOpenGl;

TEST_F(XrInput, left_touch_controller_has_x_y_and_menu) {
    Stay stay(
        "0 input left x/click\n0 input left menu/click\n30 input left y/click\n0 input left thumbstick/y -0.5"
    );
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(3));
    const HandInput& hand = stay.last.input.hands[0];
    EXPECT_TRUE(hand.lower_button);
    EXPECT_TRUE(hand.menu);
    EXPECT_FALSE(hand.upper_button);
    EXPECT_FLOAT_EQ(hand.stick.y, -0.5F);
    ASSERT_TRUE(stay.frames(30));
    EXPECT_TRUE(stay.last.input.hands[0].upper_button);
}

TEST(XrPad, thumb_that_rests_on_the_pad_does_not_walk) {
    HandInput resting, middle, rim;
    resting.stick = middle.stick = {0.1F, 0.2F};
    rim.stick = {0, 0.9F};
    middle.stick_pressed = rim.stick_pressed = true;

    xr::read_pad_as_stick(resting);
    xr::read_pad_as_stick(middle);
    xr::read_pad_as_stick(rim);

    EXPECT_EQ(resting.stick, glm::vec2(0));
    EXPECT_FALSE(resting.stick_pressed);
    EXPECT_EQ(middle.stick, glm::vec2(0));
    EXPECT_TRUE(middle.stick_pressed);
    EXPECT_EQ(rim.stick, glm::vec2(0, 0.9F));
    EXPECT_FALSE(rim.stick_pressed);
}

TEST_F(XrInput, controllers_may_be_changed_in_the_middle_of_a_stay) {
    Stay stay("20 profile right /interaction_profiles/valve/index_controller\n20 input right a/click");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(3));
    EXPECT_EQ(stay.system->status().input, "Touch controllers");
    ASSERT_TRUE(stay.frames(25));
    EXPECT_EQ(stay.system->status().input, "Touch controllers and Index controllers");
    EXPECT_TRUE(stay.last.input.hands[1].lower_button);
}

TEST_F(XrInput, bare_hand_pinches_points_and_makes_a_fist) {
    Stay stay("0 pose head 0 1.6 0\n0 pose right 0.2 1.3 -0.4\n0 hand left off\n0 hand right 0 0\n"
              "20 hand right 1 0\n40 hand right 0 1\n60 hand right off\n60 tracking right 0");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(5));
    const HandInput open = stay.last.input.hands[1];
    EXPECT_TRUE(open.is_tracked);
    EXPECT_TRUE(open.is_bare);
    EXPECT_FALSE(open.can_vibrate);
    EXPECT_LT(open.trigger, 0.05F);
    EXPECT_LT(open.squeeze, 0.05F);
    ASSERT_TRUE(open.fingertip);
    EXPECT_NEAR(open.fingertip->x, 0.2 - 0.02 + 0.03, 1e-4);
    EXPECT_NEAR(open.grip.position.x, 0.2, 1e-5);
    const glm::vec3 ahead = open.aim.orientation * glm::vec3(0, 0, -1);
    EXPECT_LT(ahead.z, -0.8F) << "it points away from the person";

    ASSERT_TRUE(stay.frames(20));
    const HandInput pinch = stay.last.input.hands[1];
    EXPECT_GT(pinch.trigger, 0.95F);
    EXPECT_LT(pinch.squeeze, 0.05F) << "the other fingers stay open";
    const glm::vec3 still_ahead = pinch.aim.orientation * glm::vec3(0, 0, -1);
    EXPECT_GT(glm::dot(ahead, still_ahead), 0.9999F) << "the ray does not jump when the fingers close";

    ASSERT_TRUE(stay.frames(20));
    EXPECT_GT(stay.last.input.hands[1].squeeze, 0.95F);
    EXPECT_LT(stay.last.input.hands[1].trigger, 0.05F);
    EXPECT_EQ(stay.system->status().input, "Touch controllers and bare hands");

    ASSERT_TRUE(stay.frames(20));
    EXPECT_FALSE(stay.last.input.hands[1].is_tracked);
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrInput, headset_that_sees_no_hands_is_served) {
    Stay stay("0 hand right 0 0", "no_hands");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(5));
    EXPECT_FALSE(stay.last.input.hands[1].is_tracked);
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

struct Shaken {
    const char *faults, *kind;
};

class XrShaking : public testing::TestWithParam<Shaken> {};

TEST_P(XrShaking, pulse_is_sent_by_the_best_way_there_is_and_stopped) {
    Stay stay("", GetParam().faults);
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(3));
    HapticSink& right = stay.system->haptics(Side::Right);

    EXPECT_TRUE(right.pulse(0.387, 35));
    EXPECT_TRUE(right.pulse(7, 5000)) << "no more than the whole motor, no longer than 200 ms";
    EXPECT_FALSE(right.pulse(std::numeric_limits<double>::quiet_NaN(), 35));
    right.stop();
    stay.end();

    const auto sent = stay.record("haptic");
    ASSERT_EQ(sent.size(), 3U);
    EXPECT_EQ(sent[0]["haptic"], GetParam().kind);
    EXPECT_EQ(sent[0]["hand"], 1);
    EXPECT_NEAR(sent[0]["amplitude"].get<double>(), 0.387, 1e-4);
    EXPECT_EQ(sent[0]["milliseconds"].get<double>(), 35);
    EXPECT_EQ(sent[1]["amplitude"].get<double>(), 1);
    EXPECT_EQ(sent[1]["milliseconds"].get<double>(), 200);
    EXPECT_EQ(sent[2]["haptic"], "stop");
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    all,
    XrShaking,
    testing::Values(
        Shaken{"", "parametric"},
        Shaken{"no_parametric", "envelope"},
        Shaken{"no_parametric no_envelope", "vibration"}
    ),
    [](const auto& each) { return std::string(each.param.kind); }
);

}  // namespace

}  // namespace feelem::viewer
