// SPDX-License-Identifier: Apache-2.0
// What goes wrong with headsets, row by row: the program says so in plain words, lets go of what is gone,
// goes on at the desk, and is back by itself when the headset is.
#include "viewer/xr/stay.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <gmock/gmock.h>

namespace feelem::viewer {

namespace {

using testing::Each;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Le;

using XrFaults = NeedsOpenGl;

/// Texture and context as the program had them: they must outlive whatever the runtime does.
class Belongings {
public:
    Belongings() : context_(eglGetCurrentContext()), texture_(texture_of(4, 4, {11, 22, 33, 44})) {}

    bool are_kept() const {
        std::array<std::uint8_t, 64> bytes{};
        if (eglGetCurrentContext() != context_) return false;
        glGetTextureImage(texture_, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.size(), bytes.data());
        return bytes[0] == 11 && bytes[63] == 44 && glGetError() == GL_NO_ERROR;
    }

private:
    EGLContext context_;
    unsigned texture_;
};

std::size_t refusals(const Stay& stay) {
    std::size_t count = 0;
    for (const auto& each : stay.record("instance")) count += each["instance"] == "refused";
    return count;
}

TEST_F(XrFaults, no_runtime_is_said_once_and_the_desk_is_there_at_once) {
    Stay stay("");
    Environment environment;
    environment.unset("XR_RUNTIME_JSON");
    environment.set("XDG_CONFIG_HOME", "/nonexistent");
    environment.set("XDG_CONFIG_DIRS", "/nonexistent");
    environment.set("HOME", "/nonexistent");

    ASSERT_TRUE(stay.reach(XrState::NoRuntime, 5));
    EXPECT_FALSE(stay.system->begin_frame());
    EXPECT_THAT(stay.system->status().why, HasSubstr("No OpenXR runtime"));
    EXPECT_THAT(stay.system->status().hint, HasSubstr("feelem-xr doctor"));

    // Installed meanwhile: who did not insist on a headset is not asked again by himself.
    environment.set("XR_RUNTIME_JSON", FEELEM_SCRIPTED_XR_JSON);
    stay.pass(60);
    EXPECT_EQ(stay.system->status().state, XrState::NoRuntime);
    stay.system->enter();
    EXPECT_TRUE(stay.reach(XrState::Focused));
}

TEST_F(XrFaults, broken_manifest_is_no_runtime) {
    Stay stay("");
    Environment environment;
    environment.set("XR_RUNTIME_JSON", "/nonexistent/runtime.json");
    EXPECT_TRUE(stay.reach(XrState::NoRuntime, 5));
}

TEST_F(XrFaults, no_runtime_is_asked_for_again_where_a_headset_is_required) {
    Stay stay("", "", {.application = "feelem-xr", .is_required = true});
    Environment environment;
    environment.set("XR_RUNTIME_JSON", "/nonexistent/runtime.json");
    ASSERT_TRUE(stay.reach(XrState::NoRuntime, 5));

    environment.set("XR_RUNTIME_JSON", FEELEM_SCRIPTED_XR_JSON);
    EXPECT_TRUE(stay.reach(XrState::Focused, 15));
}

TEST_F(XrFaults, service_that_is_down_is_asked_again_every_two_to_five_seconds_without_waiting) {
    Stay stay("", "no_service");

    ASSERT_TRUE(stay.reach(XrState::NoService, 5));
    const double start = stay.time;
    stay.pass(60 - start);

    EXPECT_THAT(refusals(stay), testing::AllOf(Ge(60U / 5U), Le(60U / 2U)));
    EXPECT_THAT(stay.system->status().why, HasSubstr("does not start"));
    stay.set_faults("");
    EXPECT_TRUE(stay.reach(XrState::Focused, 7)) << "it is there: the next try finds it";
    EXPECT_THAT(stay.system->status().why, IsEmpty());
    EXPECT_THAT(stay.system->status().runtime, HasSubstr("scripted runtime 1.2.3"));
}

TEST_F(XrFaults, service_that_takes_its_time_does_not_hold_up_the_desk) {
    Stay stay("", "slow_service");
    int turns = 0;
    while (stay.system->poll(stay.time += 0.01).is_asking && turns < 100'000) ++turns;
    EXPECT_GT(turns, 1) << "the desk had its turns while the service took half a second";
    EXPECT_TRUE(stay.reach(XrState::Focused, 1));
}

TEST_F(XrFaults, headset_that_is_missing_is_looked_for_every_two_seconds) {
    Stay stay("", "no_headset");

    ASSERT_TRUE(stay.reach(XrState::NoHeadset, 5));
    EXPECT_THAT(stay.system->status().hint, HasSubstr("switch it on"));
    stay.pass(10);
    EXPECT_EQ(stay.system->status().state, XrState::NoHeadset);
    EXPECT_FALSE(stay.system->begin_frame());

    stay.set_faults("");
    EXPECT_TRUE(stay.reach(XrState::Focused, 2.2));
    EXPECT_EQ(stay.system->status().headset, "Scripted headset");
}

TEST_F(XrFaults, headset_that_cannot_take_our_pictures_is_named_so) {
    for (const char* fault : {"no_opengl", "no_egl", "no_srgb"}) {
        Stay stay("", fault);
        ASSERT_TRUE(stay.reach(XrState::Unusable, 5)) << fault;
        EXPECT_THAT(stay.system->status().why, HasSubstr("cannot show our pictures")) << fault;
        stay.end();
        EXPECT_THAT(stay.complaints(), IsEmpty()) << fault;
    }
}

TEST_F(XrFaults, menu_of_the_headset_stops_senses_and_hands_and_keeps_the_frames) {
    Stay stay("0 input right trigger/value 1\n20 state visible\n40 state focused");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(10));
    ASSERT_TRUE(stay.last.input.is_focused);
    ASSERT_TRUE(stay.last.input.hands[1].is_tracked);
    const Pose before = stay.last.input.hands[1].aim;

    ASSERT_TRUE(stay.reach(XrState::Visible));
    // The state comes with the frame after: that one is already silent.
    ASSERT_TRUE(stay.frames(5));
    EXPECT_FALSE(stay.last.input.is_focused);
    EXPECT_TRUE(stay.last.should_render) << "it is still seen behind the menu";
    EXPECT_FALSE(stay.last.input.hands[1].is_tracked);
    EXPECT_EQ(stay.last.input.hands[1].trigger, 0);
    EXPECT_FALSE(stay.last.input.hands[1].can_vibrate);
    EXPECT_EQ(stay.last.input.hands[1].aim.position, before.position) << "a ghost stands where it was";

    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(2));
    EXPECT_TRUE(stay.last.input.hands[1].is_tracked);
    EXPECT_EQ(stay.last.input.hands[1].trigger, 1);
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFaults, menu_is_known_in_the_very_frame_in_which_the_hands_are_gone) {
    Stay stay("20 state visible");
    std::vector<bool> focused;
    stay.draw = [&](const XrFrame& frame) { focused.push_back(frame.input.is_focused); };
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.reach(XrState::Visible));
    // Frame 20 itself, by xrSyncActions' answer alone: within 50 ms at any frame rate.
    ASSERT_GE(focused.size(), 21U);
    EXPECT_TRUE(focused[19]);
    EXPECT_FALSE(focused[20]);
}

TEST_F(XrFaults, headset_off_the_head_gets_empty_frames_until_it_is_back) {
    Stay stay("20 state hidden\n40 state focused");
    ASSERT_TRUE(stay.reach(XrState::Asleep));  // On the way in.
    ASSERT_TRUE(stay.reach(XrState::Focused));

    ASSERT_TRUE(stay.reach(XrState::Asleep));
    ASSERT_TRUE(stay.frames(3));
    EXPECT_FALSE(stay.last.should_render);
    EXPECT_EQ(stay.last.eyes[0].framebuffer, 0U);
    EXPECT_THAT(stay.record("layers").back()["layers"], IsEmpty());

    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(1));
    EXPECT_TRUE(stay.last.should_render);
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFaults, hand_that_is_lost_stays_where_it_was_last_seen) {
    Stay stay(
        "0 pose left -0.3 1.1 -0.5\n0 input left trigger/value 0.8\n20 tracking left 0\n30 tracking left 1"
    );
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(2));
    ASSERT_NEAR(stay.last.input.hands[0].trigger, 0.8, 1e-6);

    ASSERT_TRUE(stay.frames(20));
    const HandInput& lost = stay.last.input.hands[0];
    EXPECT_FALSE(lost.is_tracked);
    EXPECT_EQ(lost.trigger, 0);
    EXPECT_NEAR(lost.aim.position.x, -0.3, 1e-5);
    EXPECT_TRUE(stay.last.input.hands[1].is_tracked) << "the other hand goes on";

    ASSERT_TRUE(stay.frames(10));
    EXPECT_TRUE(stay.last.input.hands[0].is_tracked);
}

TEST_F(XrFaults, headset_that_loses_its_way_keeps_the_last_view) {
    Stay stay("0 pose head 0.1 1.6 0\n20 tracking head 0");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(30));
    EXPECT_TRUE(stay.last.should_render);
    EXPECT_NEAR(stay.last.eyes[0].view.pose.position.x, 0.1 - 0.032, 1e-5);
    EXPECT_EQ(stay.record("layers").back()["layers"].size(), 1U);
}

TEST_F(XrFaults, session_that_is_stopped_begins_again_when_the_headset_is_ready) {
    Stay stay("20 stop 50");
    const Belongings belongings;
    ASSERT_TRUE(stay.reach(XrState::Focused));

    ASSERT_TRUE(stay.reach(XrState::Starting));
    EXPECT_FALSE(stay.system->begin_frame()) << "the desk keeps its own time";
    EXPECT_TRUE(belongings.are_kept());

    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(5));
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFaults, headset_that_is_left_by_its_menu_leaves_the_desk_and_can_be_entered_again) {
    Stay stay("20 exit");
    const Belongings belongings;
    ASSERT_TRUE(stay.reach(XrState::Focused));

    ASSERT_TRUE(stay.reach(XrState::Ended));
    EXPECT_TRUE(belongings.are_kept());
    stay.pass(30);
    EXPECT_EQ(stay.system->status().state, XrState::Ended) << "nobody is pulled back in";
    EXPECT_EQ(stay.record("instance").back()["instance"], "destroyed");

    stay.system->enter();
    EXPECT_TRUE(stay.reach(XrState::Focused, 5));
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFaults, leaving_by_our_own_menu_ends_the_session_in_order) {
    Stay stay("");
    ASSERT_TRUE(stay.reach(XrState::Focused));

    stay.system->leave();
    ASSERT_TRUE(stay.reach(XrState::Ended, 2));
    stay.end();

    std::vector<std::string> states;
    for (const auto& each : stay.record("state")) states.push_back(each["state"]);
    EXPECT_THAT(
        states,
        ElementsAre(
            "idle",
            "ready",
            "synchronized",
            "visible",
            "focused",
            "visible",
            "synchronized",
            "stopping",
            "idle",
            "exiting"
        )
    );
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFaults, loss_that_is_announced_is_awaited_outside_and_comes_back) {
    for (const char* what : {"session", "instance"}) {
        Stay stay(std::string("20 loss_pending ") + what);
        const Belongings belongings;
        ASSERT_TRUE(stay.reach(XrState::Focused)) << what;

        ASSERT_TRUE(stay.reach(XrState::Starting)) << what;
        EXPECT_THAT(stay.system->status().why, HasSubstr("restarts or loses")) << what;
        EXPECT_EQ(stay.record("session").back()["session"], "destroyed") << what;
        EXPECT_TRUE(belongings.are_kept()) << what;

        const double lost = stay.time;
        ASSERT_TRUE(stay.reach(XrState::Focused, 5)) << what;
        EXPECT_GE(stay.time - lost, 1.9) << what;
        stay.end();
        EXPECT_THAT(stay.complaints(), IsEmpty()) << what;
    }
}

TEST_F(XrFaults, lost_session_is_let_go_and_made_anew) {
    Stay stay("20 lose_session");
    const Belongings belongings;
    ASSERT_TRUE(stay.reach(XrState::Focused));

    ASSERT_TRUE(stay.reach(XrState::Starting));
    EXPECT_THAT(stay.system->status().what, HasSubstr("broke off"));
    EXPECT_FALSE(stay.system->haptics(Side::Right).pulse(1, 35)) << "nobody is there to feel it";
    EXPECT_TRUE(belongings.are_kept());

    ASSERT_TRUE(stay.reach(XrState::Focused, 5));
    ASSERT_TRUE(stay.frames(5));
    EXPECT_TRUE(stay.last.input.hands[1].can_vibrate);
    stay.end();
    EXPECT_EQ(stay.record("session").size(), 4U) << "made and destroyed, twice";
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFaults, session_that_is_lost_while_the_room_is_put_elsewhere_is_made_anew) {
    Stay stay("20 recentre\n20 lose_session");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    // Its last event asks for a new space, and none can be made.
    ASSERT_TRUE(stay.reach(XrState::Starting));
    ASSERT_TRUE(stay.reach(XrState::Focused, 5));
    ASSERT_TRUE(stay.frames(5));
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFaults, runtime_that_dies_is_awaited_with_scene_and_context_and_used_again) {
    Stay stay("20 lose_instance 3\n60 lose_instance 2");
    const Belongings belongings;
    ASSERT_TRUE(stay.reach(XrState::Focused));

    for (const std::size_t tries : {3U, 5U}) {
        ASSERT_TRUE(stay.reach(XrState::NoService));
        EXPECT_THAT(stay.system->status().what, HasSubstr("service stopped"));
        EXPECT_THAT(stay.system->status().hint, HasSubstr("Model and view are kept"));
        EXPECT_TRUE(belongings.are_kept());
        stay.pass(0.5);
        EXPECT_FALSE(stay.system->begin_frame());

        ASSERT_TRUE(stay.reach(XrState::Focused, 30));
        EXPECT_EQ(refusals(stay), tries);
        ASSERT_TRUE(stay.frames(5));
        EXPECT_TRUE(belongings.are_kept());
    }
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFaults, controller_that_refuses_to_vibrate_is_left_in_peace_and_told_once) {
    Stay stay("0 haptics refused");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(3));
    ASSERT_TRUE(stay.last.input.hands[1].can_vibrate);

    EXPECT_FALSE(stay.system->haptics(Side::Right).pulse(0.5, 35));
    for (int i = 0; i < 10; ++i) {
        EXPECT_FALSE(stay.system->haptics(Side::Right).pulse(0.5, 35));
        ASSERT_TRUE(stay.frames(1));
    }

    EXPECT_FALSE(stay.last.input.hands[1].can_vibrate);
    EXPECT_TRUE(stay.last.input.hands[0].can_vibrate) << "the other hand was not asked";
    EXPECT_EQ(stay.record("haptic").size(), 1U);
    EXPECT_THAT(stay.system->status().quirks, ElementsAre(HasSubstr("right controller does not vibrate")));
}

TEST_F(XrFaults, hand_without_a_controller_is_not_asked_to_vibrate) {
    Stay stay("0 profile left none");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(3));

    EXPECT_FALSE(stay.last.input.hands[0].can_vibrate);
    EXPECT_FALSE(stay.system->haptics(Side::Left).pulse(0.5, 35));
    EXPECT_THAT(stay.record("haptic"), IsEmpty());
    EXPECT_THAT(stay.system->status().quirks, IsEmpty()) << "nothing is amiss";
}

TEST_F(XrFaults, context_that_is_taken_away_is_given_back_and_told_once_a_call) {
    Stay stay("", "loses_context");
    const Belongings belongings;
    bool is_ours = true;
    stay.draw = [&](const XrFrame&) { is_ours = is_ours && belongings.are_kept(); };

    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(20));
    EXPECT_TRUE(is_ours);
    EXPECT_TRUE(belongings.are_kept());
    EXPECT_THAT(stay.system->status().quirks, Each(HasSubstr("takes away our OpenGL context")));
    EXPECT_EQ(stay.system->status().quirks.size(), 3U) << "xrCreateSession, xrCreateSwapchain, xrEndFrame";
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFaults, context_that_a_failing_call_takes_away_is_given_back_to_the_desk) {
    Stay stay("");
    const Belongings belongings;
    const unsigned panel = texture_of(8, 8, {1, 2, 3, 255});
    std::vector<XrQuad> quads(1);
    quads[0].texture = panel;
    quads[0].width = quads[0].height = 8;
    stay.pictures = [&] { return XrPictures{quads, {}}; };
    ASSERT_TRUE(stay.reach(XrState::Focused));

    quads[0].width = 4;  // A picture of another size is made anew, which is refused.
    stay.set_faults("no_srgb loses_context");
    ASSERT_TRUE(stay.turn());
    EXPECT_TRUE(belongings.are_kept());
}

TEST_F(XrFaults, error_that_a_call_leaves_in_opengl_is_cleared_and_told_once) {
    Stay stay("", "leaves_gl_error");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(20));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_THAT(stay.system->status().quirks, Each(HasSubstr("leaves an OpenGL error")));
    EXPECT_EQ(stay.system->status().quirks.size(), 3U);
}

}  // namespace

}  // namespace feelem::viewer
