// SPDX-License-Identifier: Apache-2.0
// The mouse, keys, the pin, and what stands in the room.
#include "viewer/core/handles.hpp"
#include "viewer/core/room_of_hands.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace feelem::viewer::test {
namespace {

/// A mouse above the near square, the model drawn in its own units at its own place.
struct Desk : Ready {
    explicit Desk(Scene scene) : Ready(std::move(scene)) {
        input.head.position = {0.5F, 0.5F, 5};
        input.pointer.ray = down_at(0.7F, 0.4F);
    }
    Snapshot next(double seconds = 0.01) { return last = frame(input, seconds); }
    Overlay overlay() { return overlay_of(viewer, last, input); }

    FrameInput input;
    Snapshot last;
};

bool has_label(const Overlay& overlay, const std::string& text) {
    return std::ranges::any_of(overlay.labels, [&](const Label& label) {
        return label.text.find(text) != std::string::npos;
    });
}

std::ptrdiff_t count_of(const Overlay& overlay, Mark::Kind kind) {
    return std::ranges::count(overlay.marks, kind, &Mark::kind);
}

TEST(Interaction, hover_reads_and_a_press_hears) {
    Desk desk(sensed_squares());
    EXPECT_EQ(desk.next().pointer, Pointer::Mouse);
    EXPECT_FALSE(desk.last.is_held || desk.last.sound);
    EXPECT_NEAR(desk.last.probed->readings.at(0).value, 21, 1e-4);
    desk.input.pointer.primary = true;
    EXPECT_TRUE(desk.next().sound);
    desk.input.pointer.ray = down_at(0.2F, 0.1F);
    EXPECT_TRUE(desk.next().sound) << "a drag sweeps";
    desk.input.pointer.ray = down_at(7, 7);
    EXPECT_FALSE(desk.next().probed || desk.last.sound);
    desk.input.pointer.ray = down_at(0.2F, 0.1F);
    desk.input.pointer.primary = false;
    EXPECT_FALSE(desk.next().sound);
}

TEST(Interaction, a_press_beside_the_model_is_no_press_on_it) {
    Desk desk(sensed_squares());
    desk.input.pointer.ray = down_at(7, 7);
    desk.input.pointer.primary = true;
    desk.next();
    desk.input.pointer.ray = down_at(0.7F, 0.4F);
    EXPECT_FALSE(desk.next().is_held);
}

TEST(Interaction, key_s_holds_what_the_mouse_is_on) {
    Desk desk(sensed_squares());
    desk.input.hold = true;
    EXPECT_TRUE(desk.next().is_held);
    desk.input.is_focused = false;
    EXPECT_FALSE(desk.next().is_held || desk.last.sound);
}

TEST(Interaction, a_double_press_leaves_a_note_and_two_slow_ones_do_not) {
    Desk desk(sensed_squares());
    const auto press = [&](double after) {
        desk.input.pointer.primary = true;
        desk.next(after);
        desk.input.pointer.primary = false;
        desk.next(0.05);
    };
    press(0.1);
    press(0.6);
    EXPECT_TRUE(desk.viewer.state.markers.empty());
    press(0.2);
    ASSERT_EQ(desk.viewer.state.markers.size(), 1u);
    EXPECT_EQ(desk.viewer.state.markers[0].node, 3);
    desk.next();
    EXPECT_TRUE(has_label(desk.overlay(), "1  30"));
}

TEST(Interaction, a_note_by_key_stands_at_the_place_pressed_last_when_nothing_is_pointed_at) {
    Desk desk(sensed_squares());
    desk.input.pointer.primary = true;
    desk.next();
    desk.input.pointer = {};
    desk.next();
    desk.input.commands = {Command::PlaceMarker};
    desk.next();
    ASSERT_EQ(desk.viewer.state.markers.size(), 1u);
    EXPECT_EQ(desk.viewer.state.markers[0].node, 3);
}

TEST(Interaction, what_was_gone_to_is_read_while_nobody_points_and_heard_by_key) {
    Desk desk(sensed_squares());
    desk.input.pointer.ray.reset();
    go_to_node(desk.viewer.state, desk.viewer.model, 3);
    EXPECT_EQ(desk.next().pointer, Pointer::Pin);
    EXPECT_EQ(desk.last.probed->readings.at(0).value, 30);
    EXPECT_EQ(desk.last.probed->node_id, 3);
    desk.input.hold = true;
    EXPECT_TRUE(desk.next().sound);
    desk.input.pointer.ray = down_at(0.7F, 0.4F);
    EXPECT_EQ(desk.next().pointer, Pointer::Mouse);
    set_part(desk.viewer.state, 0, PartLook::Hidden);
    desk.input.pointer.ray.reset();
    EXPECT_FALSE(desk.next().probed) << "its part is hidden";
}

TEST(Interaction, the_mouse_drags_the_knob_of_a_plane) {
    Desk desk(sensed_squares());
    add_cut(desk.viewer.state, desk.viewer.model);
    const glm::vec3 knob = *knobs_of(desk.viewer.state, desk.viewer.model).at(0);
    EXPECT_TRUE(pressable(desk.viewer, down_at(knob.x, knob.y)));
    desk.input.pointer.ray = down_at(knob.x, knob.y);
    desk.input.pointer.primary = true;
    EXPECT_FALSE(desk.next().is_held);
    desk.input.pointer.ray = down_at(knob.x + 0.2F, knob.y);
    desk.next();
    EXPECT_NEAR(desk.viewer.state.cuts[0].plane.offset, 0.7, 1e-4);
    desk.input.pointer.primary = false;
    desk.next();
    desk.input.pointer.ray = down_at(knob.x, knob.y);
    desk.next();
    EXPECT_NEAR(desk.viewer.state.cuts[0].plane.offset, 0.7, 1e-4);
}

TEST(Interaction, a_long_pause_does_not_run_through_the_steps) {
    Desk desk(sensed_squares());
    desk.next();
    desk.input.commands = {Command::PlaySteps};
    desk.next();
    EXPECT_TRUE(desk.viewer.state.playing);
    desk.next(100);
    EXPECT_EQ(desk.viewer.state.step, 0u);
    for (int i = 0; i < 6; ++i) desk.next(0.1);
    EXPECT_EQ(desk.viewer.state.step, 1u);
}

TEST(Interaction, the_headset_coming_and_going_lets_go_of_everything) {
    Desk desk(sensed_squares());
    desk.input.pointer.primary = true;
    EXPECT_TRUE(desk.next().is_held);
    desk.input.is_headset = true;
    desk.input.head.position = {0, 1.6F, 0};
    EXPECT_FALSE(desk.next().is_held);
    EXPECT_TRUE(desk.viewer.state.stand);
    const glm::mat4 there = desk.viewer.state.placement;
    desk.input.is_headset = false;
    desk.next();
    EXPECT_EQ(desk.viewer.state.placement, there) << "the desk goes on with the same room";
}

TEST(Interaction, fit_leaves_the_model_at_the_desk_and_brings_it_to_the_table_in_a_headset) {
    Desk desk(sensed_squares());
    const glm::mat4 before = desk.viewer.state.placement;
    desk.input.commands = {Command::Fit};
    desk.next();
    EXPECT_EQ(desk.viewer.state.placement, before);
    desk.input.is_headset = true;
    desk.input.commands = {Command::TrueScale};
    desk.next();
    desk.input.commands = {Command::TrueScale};
    desk.next();
    EXPECT_NEAR(glm::length(glm::vec3(desk.viewer.state.placement[0])), 1, 1e-5);
    desk.input.commands = {Command::Fit};
    desk.next();
    EXPECT_NEAR(glm::length(glm::vec3(desk.viewer.state.placement[0])), 0.8, 1e-5);
}

TEST(Overlay, extremes_stand_where_the_solver_found_them_on_the_drawn_shape) {
    Scene scene = sensed_squares();
    scene.results[0].values[0].min = Extreme{10, 1};
    scene.results[0].values[0].max = Extreme{50, 13};
    Desk desk(scene);
    desk.next();
    const Overlay overlay = desk.overlay();
    EXPECT_TRUE(has_label(overlay, "MX 50"));
    EXPECT_TRUE(has_label(overlay, "MN 10"));
    const auto is_at = [&](const glm::vec3& place) {
        return std::ranges::any_of(overlay.marks, [&](const Mark& mark) {
            return mark.kind == Mark::Kind::Dot && glm::distance(mark.from, place) < 1e-5F;
        });
    };
    EXPECT_TRUE(is_at({1, 1, -1}));
    EXPECT_TRUE(is_at({0, 0, 0}));
    set_part(desk.viewer.state, 1, PartLook::Hidden);
    desk.next();
    EXPECT_FALSE(has_label(desk.overlay(), "MX"));
    desk.viewer.state.extremes = false;
    desk.next();
    EXPECT_FALSE(has_label(desk.overlay(), "MN"));
}

TEST(Overlay, passed_limits_opened_material_and_numbers_of_hot_spots_are_said) {
    Scene scene = sensed_squares();
    scene.parts[1].kind = "solid";
    for (auto& triangle : scene.parts[1].triangles) std::swap(triangle[1], triangle[2]);
    Desk desk(scene);
    set_limit(desk.viewer.state, "T", 15);
    desk.viewer.state.hot.shown = true;
    desk.next();
    EXPECT_TRUE(has_label(desk.overlay(), "> 15"));
    EXPECT_TRUE(has_label(desk.overlay(), "1"));
    desk.viewer.state.cuts = {{{{0, 0, 1}, -0.5F}, true}};
    desk.next();
    EXPECT_TRUE(has_label(desk.overlay(), "no value"));
    EXPECT_FALSE(has_label(desk.overlay(), "> 15"));
}

TEST(Overlay, a_headset_sees_rays_bar_and_ring_and_the_desk_a_reticle) {
    Desk desk(sensed_squares());
    desk.viewer.state.extremes = false;
    desk.next();
    EXPECT_EQ(count_of(desk.overlay(), Mark::Kind::Ring), 1);
    EXPECT_EQ(count_of(desk.overlay(), Mark::Kind::Line), 0);

    Room room(sensed_squares());
    room.viewer.state.extremes = false;
    room.point(kRight, room.world({0.7F, 0.4F, 0}));
    room.next();
    const Overlay overlay = overlay_of(room.viewer, room.last, room.input);
    EXPECT_EQ(count_of(overlay, Mark::Kind::Line), 3) << "two rays and the bar";
    const auto ray = std::ranges::find_if(overlay.marks, [&](const Mark& mark) {
        return mark.kind == Mark::Kind::Line && mark.from == room.hand(kRight).aim.position;
    });
    ASSERT_NE(ray, overlay.marks.end());
    EXPECT_LT(glm::distance(ray->to, room.world({0.7F, 0.4F, 0})), 1e-4F);
    room.hand(kRight).is_tracked = false;
    room.next();
    const Overlay lost = overlay_of(room.viewer, room.last, room.input);
    EXPECT_EQ(count_of(lost, Mark::Kind::Line), 2);
}

}  // namespace
}  // namespace feelem::viewer::test
