// SPDX-License-Identifier: Apache-2.0
// What is submitted to the headset: both eyes, panels, depth; and where the room is.
#include "viewer/xr/stay.hpp"

#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <cmath>

namespace feelem::viewer {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using XrFrames = NeedsOpenGl;
using Bytes = std::array<std::uint8_t, 4>;
constexpr Bytes kLeftBytes{200, 100, 50, 255}, kRightBytes{10, 20, 30, 255};

void draw_two_colours(const XrFrame& frame) {
    fill_eyes(frame, {kLeftBytes, kRightBytes});
}

std::vector<int> middle(const nlohmann::json& picture) {
    return picture["middle"].get<std::vector<int>>();
}

TEST_F(XrFrames, both_eyes_arrive_with_the_bytes_that_were_drawn) {
    Stay stay("");
    stay.draw = draw_two_colours;

    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(60));
    stay.end();

    std::size_t drawn = 0;
    for (const auto& each : stay.record("layers")) {
        if (each["layers"].empty()) continue;
        ++drawn;
        const auto& views = each["layers"][0]["views"];
        EXPECT_EQ(views[0]["format"], GL_SRGB8_ALPHA8) << "what is linear would be shown too light";
        EXPECT_THAT(middle(views[0]), ElementsAre(200, 100, 50, 255));
        EXPECT_THAT(middle(views[1]), ElementsAre(10, 20, 30, 255));
        EXPECT_NEAR(views[1]["x"].get<double>() - views[0]["x"].get<double>(), 0.064, 1e-3);
    }
    EXPECT_GE(drawn, 60U);
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFrames, eyes_have_the_views_of_the_headset) {
    Stay stay("0 pose head 0.1 1.7 0.2");

    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(2));

    const auto& [left, right] = stay.last.eyes;
    EXPECT_NEAR(left.view.pose.position.x, 0.1 - 0.032, 1e-5);
    EXPECT_NEAR(right.view.pose.position.x, 0.1 + 0.032, 1e-5);
    EXPECT_FLOAT_EQ(left.view.field.left, -0.9F);
    EXPECT_FLOAT_EQ(left.view.field.right, 0.8F);
    EXPECT_FLOAT_EQ(right.view.field.up, 0.75F);
    EXPECT_FLOAT_EQ(right.view.field.down, -0.85F);
    EXPECT_EQ(left.width, 96);
    EXPECT_EQ(left.height, 80);
    EXPECT_NEAR(stay.last.input.head.position.y, 1.7, 1e-5) << "heights are above the floor";
    EXPECT_TRUE(stay.last.input.is_headset);
    EXPECT_NEAR(stay.last.period, 1 / 90.0, 1e-6);
}

TEST_F(XrFrames, frame_that_shall_not_be_drawn_is_ended_without_layers) {
    Stay stay("5 render 0\n8 render 1");
    std::vector<bool> drawn;
    stay.draw = [&](const XrFrame& frame) {
        drawn.push_back(frame.should_render);
        draw_two_colours(frame);
    };

    ASSERT_TRUE(stay.frames(10));
    stay.end();

    EXPECT_THAT(drawn, ElementsAre(false, true, true, true, true, false, false, false, true, true));
    const auto frames = stay.record("layers");
    ASSERT_EQ(frames.size(), 10U);
    for (std::size_t i = 0; i < frames.size(); ++i)
        EXPECT_EQ(frames[i]["layers"].size(), drawn[i] ? 1U : 0U) << i;
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFrames, panel_is_a_layer_of_its_own_and_is_copied_only_when_it_changes) {
    Stay stay("");
    unsigned texture = texture_of(64, 32, {1, 2, 3, 255});
    XrQuad quad;
    quad.name = 7;
    quad.texture = texture;
    quad.width = 64;
    quad.height = 32;
    stay.draw = draw_two_colours;
    stay.pictures = [&] { return XrPictures{{&quad, 1}, {}}; };
    ASSERT_TRUE(stay.reach(XrState::Focused));

    quad.has_changed = false;
    glClearTexImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, Bytes{9, 9, 9, 255}.data());
    ASSERT_TRUE(stay.frames(1));
    const auto kept = stay.record("layers").back();
    quad.has_changed = true;
    ASSERT_TRUE(stay.frames(1));
    const auto changed = stay.record("layers").back();
    stay.end();
    glDeleteTextures(1, &texture);

    ASSERT_EQ(kept["layers"].size(), 2U);
    EXPECT_EQ(kept["layers"][1]["kind"], "quad");
    EXPECT_THAT(middle(kept["layers"][1]), ElementsAre(1, 2, 3, 255));
    EXPECT_THAT(middle(changed["layers"][1]), ElementsAre(9, 9, 9, 255));
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFrames, panel_that_grows_gets_a_larger_picture) {
    Stay stay("");
    unsigned small = texture_of(16, 16, {1, 2, 3, 255}), large = texture_of(128, 64, {4, 5, 6, 255});
    XrQuad quad;
    quad.texture = small;
    quad.width = quad.height = 16;
    stay.pictures = [&] { return XrPictures{{&quad, 1}, {}}; };
    ASSERT_TRUE(stay.reach(XrState::Focused));

    quad.texture = large;
    quad.width = 128;
    quad.height = 64;
    ASSERT_TRUE(stay.frames(1));
    stay.end();

    EXPECT_THAT(middle(stay.record("layers").back()["layers"][1]), ElementsAre(4, 5, 6, 255));
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFrames, depth_goes_along_where_it_is_taken_and_was_drawn) {
    Stay stay("");
    bool writes = true;
    stay.draw = [](const XrFrame& frame) {
        for (const XrEye& eye : frame.eyes)
            if (eye.depth_texture)
                glClearTexImage(eye.depth_texture, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    };
    stay.pictures = [&] {
        return XrPictures{{}, writes ? std::optional(XrDepth{0.02F, 200}) : std::nullopt};
    };

    ASSERT_TRUE(stay.reach(XrState::Focused));
    EXPECT_NE(stay.last.eyes[0].depth_texture, 0U);
    EXPECT_EQ(stay.record("layers").back()["layers"][0]["views"][1]["depth"], true);
    writes = false;
    ASSERT_TRUE(stay.frames(1));
    EXPECT_EQ(stay.record("layers").back()["layers"][0]["views"][1]["depth"], false);
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());

    Stay without("", "no_depth");
    ASSERT_TRUE(without.reach(XrState::Focused));
    EXPECT_EQ(without.last.eyes[0].depth_texture, 0U);
    without.end();
    EXPECT_THAT(without.complaints(), IsEmpty());
}

TEST_F(XrFrames, runtime_that_refuses_array_images_is_served) {
    Stay stay("", "no_array");
    stay.draw = draw_two_colours;
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(3));
    stay.end();
    EXPECT_EQ(stay.record("layers").back()["layers"].size(), 1U);
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFrames, recentred_room_has_the_person_in_its_middle_and_keeps_its_floor) {
    const float half = std::sqrt(0.5F);  // A quarter turn to the left.
    Stay stay(
        "0 pose head 0.5 1.7 -0.4 0 " + std::to_string(half) + " 0 " + std::to_string(half) +
        "\n40 pose head 0.5 1.7 -1.4 0 " + std::to_string(half) + " 0 " + std::to_string(half)
    );
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(1));
    EXPECT_NEAR(stay.last.input.head.position.x, 0.5, 1e-5);

    stay.system->recentre();
    ASSERT_TRUE(stay.frames(1));

    const Pose& head = stay.last.input.head;
    EXPECT_NEAR(head.position.x, 0, 1e-5);
    EXPECT_NEAR(head.position.y, 1.7, 1e-5);
    EXPECT_NEAR(head.position.z, 0, 1e-5);
    const glm::vec3 ahead = head.orientation * glm::vec3(0, 0, -1);
    EXPECT_NEAR(ahead.z, -1, 1e-4);

    ASSERT_TRUE(stay.frames(40));
    EXPECT_NEAR(stay.last.input.head.position.x, 1, 1e-5)
        << "a step to the right: the room stays, once it is set";
}

TEST_F(XrFrames, headset_that_recentres_itself_voids_ours) {
    Stay stay("0 pose head 0.5 1.7 -0.4\n20 recentre");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    stay.system->recentre();
    ASSERT_TRUE(stay.frames(1));
    ASSERT_NEAR(stay.last.input.head.position.x, 0, 1e-5);

    ASSERT_TRUE(stay.frames(20));

    EXPECT_NEAR(stay.last.input.head.position.x, 0, 1e-5) << "LOCAL is where the head is, and so is the room";
    EXPECT_NEAR(stay.last.input.head.position.y, 1.7, 1e-5);
    stay.end();
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrFrames, without_a_stage_the_floor_is_a_standing_person_below_the_start) {
    Stay stay("0 pose head 0 1.5 0", "no_stage");
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(1));
    EXPECT_NEAR(stay.last.input.head.position.y, 1.5, 1e-5);
}

}  // namespace

}  // namespace feelem::viewer
