// SPDX-License-Identifier: Apache-2.0
// The headset: both eyes' pictures, the boards of the room, and what the hands do.
#pragma once

#include "viewer/app/boards.hpp"
#include "viewer/app/stage.hpp"
#include "viewer/app/wishes.hpp"
#include "viewer/xr/xr_system.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>

namespace feelem::viewer {

class HeadsetScreen {
public:
    explicit HeadsetScreen(const XrOptions& options) : system_(options) {}

    /// Once a frame, first of all: connects, listens, retries. Hands who can shake to the senses.
    const XrStatus& poll(Stage& stage, double time);
    const XrStatus& status() const noexcept { return system_.status(); }
    /// One frame from input to picture, when the headset wants one: `desk_commands` are those of the
    /// keyboard. False: it wants none.
    bool frame(Stage& stage, double time, std::span<const Command> desk_commands);
    /// It shows the model now: the window is a mirror.
    bool is_shown() const noexcept { return is_shown_; }
    void ask_again() { system_.enter(); }
    void leave() { system_.leave(); }

private:
    void draw(Stage& stage, const XrFrame& frame, const PanelInput& panel_input);
    void place(Stage& stage, const Pose& head);

    XrSystem system_;
    std::array<std::unique_ptr<BoardTexture>, kBoards> boards_;
    std::array<BoardPlace, kBoards> places_{};
    BoardPointer pointer_;
    std::optional<float> eye_height_;  ///< When the person took their place.
    std::vector<XrQuad> quads_;
    bool is_shown_ = false;
    bool shows_panel_ = true;  ///< The upper button of the other hand sends it away and brings it back.
};

/// The status in the words of the panels.
UiHeadset words_of(const XrStatus& status);

}  // namespace feelem::viewer
