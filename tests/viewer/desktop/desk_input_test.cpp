// SPDX-License-Identifier: Apache-2.0
// Events in, wishes out: each kind of event does what docs/native-viewer-keys.md says, and nothing else.
#include "viewer/desktop/desk_input.hpp"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace feelem::viewer {
namespace {

using Kind = DeskEvent::Kind;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A ball of half a metre is the model; the stage is the right part of the window.
class DeskInputTest : public ::testing::Test {
protected:
    DeskInputTest() {
        situation.pixels = {1000, 500};
        situation.stage = std::array{200, 0, 800, 500};
        situation.box = {{-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F}};
        situation.hit = [](const Ray& ray) -> std::optional<glm::vec3> {
            const float along = -glm::dot(ray.origin, ray.direction);
            const glm::vec3 nearest = ray.origin + along * ray.direction;
            const float off = glm::length(nearest);
            if (off > 0.5F) return std::nullopt;
            return ray.origin + (along - std::sqrt(0.25F - off * off)) * ray.direction;
        };
        step({});
    }

    DeskFrame step(std::vector<DeskEvent> events) {
        situation.time += 1.0 / 60;
        return input.step(events, situation);
    }
    static DeskEvent mouse(Kind kind, glm::vec2 at, int button = 0) {
        DeskEvent event;
        event.kind = kind;
        event.at = at;
        event.button = button;
        return event;
    }
    static DeskEvent wheel(glm::vec2 at, float notches) {
        DeskEvent event = mouse(Kind::Wheel, at);
        event.wheel = {0, notches};
        return event;
    }
    static DeskEvent key(std::string name, Kind kind = Kind::KeyDown) {
        DeskEvent event;
        event.kind = kind;
        event.text = std::move(name);
        return event;
    }
    static DeskEvent finger(Kind kind, glm::vec2 at, std::int64_t id = 1) {
        DeskEvent event = mouse(kind, at);
        event.finger = id;
        return event;
    }
    glm::vec2 seen(const glm::vec3& point) const {
        return glm::vec2(200, 0) + *place_of(input.camera(), point, 1.6F) * glm::vec2(800, 500);
    }

    static constexpr glm::vec2 kMiddle{600, 250}, kBeside{230, 20}, kPanel{100, 250};
    DeskSituation situation;
    DeskInput input;
};

TEST_F(DeskInputTest, first_frame_shows_the_whole_model) {
    EXPECT_TRUE(input.camera().fitted);
    EXPECT_NEAR(glm::length(input.camera().target), 0, 1e-6F);
}

TEST_F(DeskInputTest, hover_points_with_the_ray_through_the_mouse) {
    const DeskFrame frame = step({mouse(Kind::Moved, kMiddle)});
    ASSERT_TRUE(frame.input.pointer.ray);
    EXPECT_NEAR(glm::length(*situation.hit(*frame.input.pointer.ray)), 0.5F, 1e-4F);
    EXPECT_FALSE(frame.input.pointer.primary);
    EXPECT_EQ(frame.input.head.position, frame.input.pointer.ray->origin);
}

TEST_F(DeskInputTest, press_on_the_model_probes_and_does_not_turn) {
    const float yaw = input.camera().yaw;
    step({mouse(Kind::Pressed, kMiddle)});
    DeskFrame frame = step({mouse(Kind::Moved, kMiddle + glm::vec2(30, 0))});
    EXPECT_TRUE(frame.input.pointer.primary);
    EXPECT_TRUE(frame.input.pointer.ray);
    EXPECT_EQ(frame.panel.pointer, kMiddle + glm::vec2(30, 0)) << "the card keeps out of its way";
    EXPECT_EQ(input.camera().yaw, yaw);
    frame = step({mouse(Kind::Moved, kPanel)});
    EXPECT_TRUE(frame.input.pointer.ray) << "a sweep that leaves the stage goes on";
    EXPECT_FALSE(frame.panel.at) << "and presses nothing on a panel";
    frame = step({mouse(Kind::Released, kPanel)});
    EXPECT_FALSE(frame.input.pointer.primary);
    EXPECT_FALSE(frame.input.pointer.ray);
}

TEST_F(DeskInputTest, drag_beside_the_model_turns_by_eight_thousandths_a_point) {
    const DeskCamera before = input.camera();
    step({mouse(Kind::Pressed, kBeside)});
    const DeskFrame frame = step({mouse(Kind::Moved, kBeside + glm::vec2(50, 10))});
    EXPECT_NEAR(input.camera().yaw, before.yaw - 50 * 0.008F, 1e-5F);
    EXPECT_NEAR(input.camera().pitch, before.pitch + 10 * 0.008F, 1e-5F);
    EXPECT_FALSE(frame.input.pointer.ray) << "nothing is read while the model turns";
    EXPECT_FALSE(frame.input.pointer.primary);
}

TEST_F(DeskInputTest, a_dense_screen_turns_as_far_for_the_same_way_of_the_hand) {
    situation.density = 2;
    const float before = input.camera().yaw;
    step({mouse(Kind::Pressed, kBeside)});
    step({mouse(Kind::Moved, kBeside + glm::vec2(100, 0))});
    EXPECT_NEAR(input.camera().yaw, before - 50 * 0.008F, 1e-5F);
}

TEST_F(DeskInputTest, middle_drag_turns_on_the_model_too) {
    const float before = input.camera().yaw;
    step({mouse(Kind::Pressed, kMiddle, 2), mouse(Kind::Moved, kMiddle + glm::vec2(10, 0))});
    EXPECT_NEAR(input.camera().yaw, before - 0.08F, 1e-5F);
}

TEST_F(DeskInputTest, right_drag_carries_the_model_with_the_pointer) {
    const glm::vec3 target = input.camera().target;
    step({mouse(Kind::Pressed, kMiddle, 1), mouse(Kind::Moved, kMiddle + glm::vec2(60, -40))});
    const glm::vec2 at = seen(target);
    EXPECT_NEAR(at.x, kMiddle.x + 60, 0.1F);
    EXPECT_NEAR(at.y, kMiddle.y - 40, 0.1F);
}

TEST_F(DeskInputTest, wheel_zooms_at_the_pointer) {
    const glm::vec2 at = kMiddle + glm::vec2(70, 30);
    const DeskFrame hover = step({mouse(Kind::Moved, at)});
    const glm::vec3 point = *situation.hit(*hover.input.pointer.ray);
    const float before = input.camera().distance;
    const DeskFrame frame = step({wheel(at, 1)});
    EXPECT_NEAR(input.camera().distance, before * std::exp(-0.18F), 1e-4F);
    EXPECT_NEAR(glm::distance(seen(point), at), 0, 0.1F);
    EXPECT_EQ(frame.input.pointer.wheel, 1);
}

TEST_F(DeskInputTest, wheel_over_a_panel_scrolls_it) {
    const float before = input.camera().distance;
    const DeskFrame frame = step({wheel(kPanel, -1)});
    EXPECT_EQ(frame.panel.wheel, -1);
    EXPECT_EQ(input.camera().distance, before);
}

TEST_F(DeskInputTest, press_on_a_panel_is_the_panels_until_it_ends) {
    DeskFrame frame = step({mouse(Kind::Pressed, kPanel)});
    EXPECT_TRUE(frame.panel.buttons[0]);
    EXPECT_EQ(frame.panel.at, kPanel);
    EXPECT_FALSE(frame.input.pointer.ray);
    frame = step({mouse(Kind::Moved, kMiddle)});
    EXPECT_TRUE(frame.panel.buttons[0]) << "a slider that is held";
    EXPECT_FALSE(frame.input.pointer.primary);
    EXPECT_FALSE(frame.input.pointer.ray);
}

TEST_F(DeskInputTest, a_list_that_hangs_over_the_stage_is_a_panel) {
    situation.over_panel = true;
    const DeskFrame frame = step({mouse(Kind::Pressed, kMiddle)});
    EXPECT_TRUE(frame.panel.buttons[0]);
    EXPECT_FALSE(frame.input.pointer.ray);
}

TEST_F(DeskInputTest, a_click_within_one_frame_is_a_press_of_one_frame) {
    DeskFrame frame = step({mouse(Kind::Pressed, kPanel), mouse(Kind::Released, kPanel)});
    EXPECT_TRUE(frame.panel.buttons[0]);
    frame = step({});
    EXPECT_FALSE(frame.panel.buttons[0]);
    EXPECT_EQ(frame.panel.at, kPanel);
    frame = step({mouse(Kind::Pressed, kMiddle), mouse(Kind::Released, kMiddle)});
    EXPECT_TRUE(frame.input.pointer.primary);
    EXPECT_FALSE(step({}).input.pointer.primary);
}

TEST_F(DeskInputTest, one_finger_probes_the_model_and_is_gone_when_it_lifts) {
    DeskFrame frame = step({finger(Kind::FingerDown, kMiddle)});
    EXPECT_TRUE(frame.input.pointer.primary);
    EXPECT_TRUE(frame.input.pointer.ray);
    frame = step({finger(Kind::FingerUp, kMiddle)});
    EXPECT_FALSE(frame.input.pointer.primary);
    frame = step({});
    EXPECT_FALSE(frame.input.pointer.ray) << "a finger does not hover";
}

TEST_F(DeskInputTest, one_finger_taps_on_a_panel) {
    DeskFrame frame = step({finger(Kind::FingerDown, kPanel), finger(Kind::FingerUp, kPanel)});
    EXPECT_TRUE(frame.panel.buttons[0]);
    frame = step({});
    EXPECT_FALSE(frame.panel.buttons[0]);
    EXPECT_TRUE(frame.panel.at) << "let go where it was pressed";
    EXPECT_FALSE(step({}).panel.at);
}

TEST_F(DeskInputTest, two_fingers_move_and_scale_and_let_the_probe_go) {
    const glm::vec3 point = *situation.hit(ray_at(input.camera(), {0.5F, 0.5F}, 1.6F));
    const float before = glm::distance(pose_of(input.camera()).position, point);
    step({finger(Kind::FingerDown, kMiddle - glm::vec2(50, 0), 1)});
    DeskFrame frame = step({finger(Kind::FingerDown, kMiddle + glm::vec2(50, 0), 2)});
    EXPECT_FALSE(frame.input.pointer.primary);
    EXPECT_FALSE(frame.input.pointer.ray);
    frame = step(
        {finger(Kind::FingerMoved, kMiddle - glm::vec2(100, 0), 1),
         finger(Kind::FingerMoved, kMiddle + glm::vec2(100, 0), 2)}
    );
    EXPECT_NEAR(glm::distance(pose_of(input.camera()).position, point), before / 2, before * 0.02F);
    step({finger(Kind::FingerUp, kMiddle, 2)});
    const float yaw = input.camera().yaw;
    step({finger(Kind::FingerMoved, kMiddle, 1)});
    EXPECT_EQ(input.camera().yaw, yaw) << "the finger that stays does nothing new";
}

TEST_F(DeskInputTest, keys_become_commands_and_repeat_only_where_that_helps) {
    EXPECT_THAT(
        step({key("M"), key(".")}).input.commands, ElementsAre(Command::ToggleMute, Command::NextStep)
    );
    DeskEvent mute = key("M");
    DeskEvent next = key(".");
    mute.repeated = next.repeated = true;
    EXPECT_THAT(step({mute, next}).input.commands, ElementsAre(Command::NextStep));
    EXPECT_THAT(step({key("M", Kind::KeyUp)}).input.commands, IsEmpty());
}

TEST_F(DeskInputTest, a_bracket_is_found_by_its_place_where_the_keyboard_has_another_sign) {
    DeskEvent event = key("Ü");
    event.place = "[";
    EXPECT_THAT(step({event}).input.commands, ElementsAre(Command::ClipBack));
    event.text = "Y";
    event.place = "Z";
    EXPECT_THAT(step({event}).input.commands, IsEmpty()) << "letters are known by their name alone";
}

TEST_F(DeskInputTest, s_holds_until_it_is_let_go_or_the_window_loses_focus) {
    EXPECT_TRUE(step({key("S")}).input.hold);
    EXPECT_TRUE(step({}).input.hold);
    EXPECT_FALSE(step({key("S", Kind::KeyUp)}).input.hold);
    step({key("S")});
    DeskEvent lost;
    lost.kind = Kind::FocusLost;
    DeskFrame frame = step({lost});
    EXPECT_FALSE(frame.input.hold);
    EXPECT_FALSE(frame.input.is_focused);
    lost.kind = Kind::FocusGained;
    frame = step({lost});
    EXPECT_FALSE(frame.input.hold);
    EXPECT_TRUE(frame.input.is_focused);
}

TEST_F(DeskInputTest, s_is_let_go_also_with_shift_down) {
    step({key("S")});
    DeskEvent up = key("S", Kind::KeyUp);
    up.shift = true;
    EXPECT_FALSE(step({up}).input.hold);
}

TEST_F(DeskInputTest, what_is_typed_into_a_field_commands_nothing) {
    situation.is_typing = true;
    DeskEvent text;
    text.kind = Kind::Text;
    text.text = "1";
    const DeskFrame frame = step({key("1"), text, key("Backspace")});
    EXPECT_THAT(frame.input.commands, IsEmpty());
    EXPECT_EQ(frame.panel.text, "1");
    EXPECT_THAT(frame.panel.keys, ElementsAre(PanelKey::Backspace));
}

TEST_F(DeskInputTest, losing_focus_lets_everything_go) {
    step({mouse(Kind::Pressed, kMiddle)});
    DeskEvent lost;
    lost.kind = Kind::FocusLost;
    EXPECT_FALSE(step({lost}).input.pointer.primary);
    const float yaw = input.camera().yaw;
    step({mouse(Kind::Moved, kMiddle + glm::vec2(80, 0))});
    EXPECT_EQ(input.camera().yaw, yaw);
}

TEST_F(DeskInputTest, f_fits_also_what_core_changes_with_it) {
    step({wheel(kMiddle, 2)});
    const float near = input.camera().distance;
    const DeskFrame frame = step({key("F")});
    EXPECT_THAT(frame.input.commands, ElementsAre(Command::Fit));
    EXPECT_GT(input.camera().distance, near);
    situation.box = {{-5, -5, -5}, {5, 5, 5}};
    step({});
    EXPECT_NEAR(input.camera().radius, std::sqrt(75.0F), 1e-4F);
}

TEST_F(DeskInputTest, keys_move_the_camera) {
    DeskCamera before = input.camera();
    DeskEvent right = key("Right");
    right.shift = true;
    step({right});
    EXPECT_NEAR(input.camera().yaw, before.yaw - 15 * std::numbers::pi_v<float> / 180, 1e-5F);
    step({key("PageUp")});
    EXPECT_NEAR(input.camera().distance, before.distance * 0.8F, 1e-5F);
    DeskEvent z = key("Z");
    z.shift = true;
    step({z});
    EXPECT_NEAR((pose_of(input.camera()).orientation * glm::vec3(0, 0, 1)).z, 1, 1e-5F);
}

TEST_F(DeskInputTest, window_wishes_are_handed_on) {
    EXPECT_THAT(
        step({key("T"), key("F1"), key("F11")}).actions,
        ElementsAre(DeskAction::Theme, DeskAction::Help, DeskAction::FullScreen)
    );
    DeskEvent drop;
    drop.kind = Kind::Dropped;
    drop.text = "/tmp/boiler.glb";
    DeskEvent close;
    close.kind = Kind::CloseWanted;
    const DeskFrame frame = step({drop, close});
    EXPECT_THAT(frame.dropped, ElementsAre("/tmp/boiler.glb"));
    EXPECT_TRUE(frame.close_wanted);
}

TEST_F(DeskInputTest, sticks_turn_and_move_by_time_and_a_slack_one_does_nothing) {
    situation.pad.is_connected = true;
    situation.pad.left = {0.1F, -0.1F};
    const DeskCamera before = input.camera();
    step({});
    EXPECT_EQ(input.camera().yaw, before.yaw);
    EXPECT_TRUE(input.camera().fitted);
    situation.pad.left = {1, 0};
    for (int i = 0; i < 30; ++i) step({});
    EXPECT_NEAR(input.camera().yaw, before.yaw - 1, 1e-3F) << "half a second at two radians a second";
    situation.pad.left = {0, 0};
    situation.pad.right_trigger = 1;
    for (int i = 0; i < 30; ++i) step({});
    EXPECT_NEAR(input.camera().distance, before.distance * std::exp(-0.6F), 1e-3F);
}

TEST_F(DeskInputTest, a_gamepad_points_at_the_middle_and_holds_with_a) {
    situation.pad.is_connected = situation.pad.can_rumble = true;
    DeskEvent a;
    a.kind = Kind::PadPressed;
    a.text = "a";
    DeskFrame frame = step({a});
    EXPECT_TRUE(frame.input.hold);
    EXPECT_TRUE(frame.input.pointer.can_vibrate);
    ASSERT_TRUE(frame.input.pointer.ray);
    EXPECT_NEAR(
        glm::dot(frame.input.pointer.ray->direction, frame.input.head.orientation * glm::vec3(0, 0, -1)),
        1,
        1e-5F
    );
    a.kind = Kind::PadReleased;
    EXPECT_FALSE(step({a}).input.hold);
    DeskEvent next;
    next.kind = Kind::PadPressed;
    next.text = "dpright";
    EXPECT_THAT(step({next}).input.commands, ElementsAre(Command::NextStep));
    frame = step({mouse(Kind::Moved, kBeside)});
    EXPECT_LT(
        glm::dot(frame.input.pointer.ray->direction, frame.input.head.orientation * glm::vec3(0, 0, -1)),
        0.999F
    ) << "the mouse points again";
}

TEST_F(DeskInputTest, an_unplugged_gamepad_lets_go) {
    situation.pad.is_connected = true;
    DeskEvent a;
    a.kind = Kind::PadPressed;
    a.text = "a";
    step({a});
    situation.pad = {};
    EXPECT_FALSE(step({}).input.hold);
}

}  // namespace
}  // namespace feelem::viewer
