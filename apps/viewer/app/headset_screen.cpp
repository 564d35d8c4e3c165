// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/headset_screen.hpp"

namespace feelem::viewer {
namespace {

bool is_running(XrState state) {
    return state == XrState::Asleep || state == XrState::Visible || state == XrState::Focused;
}

}  // namespace

UiHeadset words_of(const XrStatus& status) {
    return {status.what, status.why, status.hint, is_running(status.state)};
}

const XrStatus& HeadsetScreen::poll(Stage& stage, double time) {
    const XrStatus& status = system_.poll(time);
    is_shown_ = is_shown_ && is_running(status.state);
    if (!is_shown_) eye_height_.reset();
    stage.devices().headset = words_of(status);
    return status;
}

void HeadsetScreen::place(Stage& stage, const Pose& head) {
    const Viewer& viewer = stage.viewer();
    if (!eye_height_ || viewer.interaction.boards_moved) eye_height_ = head.position.y;
    if (viewer.interaction.menu_asked) shows_panel_ = !shows_panel_;
    const Frame& frame = stage.frame();
    places_ = place_boards(
        viewer.state.stand.value_or(stand_of(head)),
        *eye_height_,
        viewer.state.person.left_handed,
        frame.snapshot,
        frame.look,
        head.position
    );
    BoardPlace& panel = places_[static_cast<std::size_t>(Board::Panel)];
    panel.is_shown = panel.is_shown && shows_panel_;
}

bool HeadsetScreen::frame(Stage& stage, double time, std::span<const Command> desk_commands) {
    std::optional<XrFrame> frame = system_.begin_frame();
    if (!frame) return false;
    is_shown_ = true;
    FrameInput& input = frame->input;
    input.time = time;
    input.is_headset = true;
    input.commands.insert(input.commands.end(), desk_commands.begin(), desk_commands.end());
    if (!eye_height_) place(stage, input.head);
    const PanelInput panel_input = pointer_.point(input, places_);
    for (const Side side : {Side::Left, Side::Right})
        stage.senses().set_sink(
            side, input.hands[static_cast<std::size_t>(side)].can_vibrate ? &system_.haptics(side) : nullptr
        );
    stage.set_budget(frame->period);
    stage.step(input);
    place(stage, input.head);
    quads_.clear();
    if (frame->should_render) draw(stage, *frame, panel_input);
    system_.end_frame({quads_, std::nullopt});
    return true;
}

void HeadsetScreen::draw(Stage& stage, const XrFrame& frame, const PanelInput& panel_input) {
    const UiModel model = stage.panels();
    WindowWishes window;
    for (const Board board : {Board::Panel, Board::Legend, Board::Card}) {
        const auto index = static_cast<std::size_t>(board);
        const BoardPlace& place = places_[index];
        if (!place.is_shown) continue;
        if (!boards_[index]) boards_[index] = std::make_unique<BoardTexture>(board);
        const UiWishes wishes =
            boards_[index]->draw(model, board == Board::Panel ? panel_input : PanelInput{});
        grant(wishes, stage.viewer(), stage.devices(), window);
        const BoardSize size = size_of(board);
        XrQuad quad;
        quad.name = static_cast<int>(board);
        quad.texture = boards_[index]->texture();
        quad.width = size.pixels.x;
        quad.height = size.pixels.y;
        quad.pose = place.pose;
        quad.size = place.size;
        quads_.push_back(quad);
    }
    const std::array<Camera, 2> eyes{camera_of(frame.eyes[0].view), camera_of(frame.eyes[1].view)};
    stage.draw(eyes, {frame.eyes[0].width, frame.eyes[0].height});
    for (std::size_t eye = 0; eye < eyes.size(); ++eye) {
        Target target;
        target.framebuffer = frame.eyes[eye].framebuffer;
        target.width = frame.eyes[eye].width;
        target.height = frame.eyes[eye].height;
        stage.renderer().copy(eye, target);
    }
}

}  // namespace feelem::viewer
