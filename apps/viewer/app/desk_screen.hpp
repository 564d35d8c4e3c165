// SPDX-License-Identifier: Apache-2.0
// The desk: a window, or the same picture without one, with the model on a stage between panels.
#pragma once

#include "viewer/app/options.hpp"
#include "viewer/app/stage.hpp"
#include "viewer/app/wishes.hpp"
#include "viewer/desktop/desk_input.hpp"
#include "viewer/desktop/pad_haptics.hpp"
#include "viewer/desktop/window.hpp"
#include "viewer/render/composed_picture.hpp"
#include "viewer/render/gl_context.hpp"
#include "viewer/ui/gui.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace feelem::viewer {

/// Made first and gone last: its OpenGL context is everybody's.
class DeskScreen {
public:
    /// Without a window (`has_window` false) it draws for itself alone. Throws NoWindow.
    DeskScreen(const Options& options, bool has_window);
    ~DeskScreen();
    DeskScreen(const DeskScreen&) = delete;
    DeskScreen& operator=(const DeskScreen&) = delete;

    /// What the person did since the last call; `scripted` comes after what really happened.
    DeskFrame poll(Stage& stage, double time, std::span<const DeskEvent> scripted);
    /// Draws the last frame and the panels; what was wished of them is granted. While a headset shows the
    /// model, its left eye's picture is the stage's.
    void draw(Stage& stage, bool headset_shows);
    /// To the window; waits for the screen's beat unless a headset gives it.
    void show(bool headset_gives_beat);
    /// A gamepad's motors, for who has no controller in the hand.
    void lend_motors(SenseOutputs& senses);
    Pixels picture() const { return picture_.read(); }

    glm::ivec2 pixels() const;
    /// Something happened in the last poll(): a key, the mouse, a stick.
    bool was_used() const noexcept { return was_used_; }
    bool has_window() const noexcept { return window_ != nullptr; }
    DeskCamera& camera() noexcept { return input_.camera(); }
    bool wants_headset_again() const noexcept { return wishes_.try_headset; }

private:
    std::array<int, 4> stage_rectangle() const;
    void look_where_wished(Stage& stage);

    std::unique_ptr<Window> window_;
    std::optional<PadHaptics> motors_;
    std::unique_ptr<GlContext> context_;  ///< Where there is no window.
    glm::ivec2 size_{1280, 800};
    ComposedPicture picture_;
    std::unique_ptr<DeskGui> gui_;
    DeskInput input_;
    bool was_used_ = false;
    bool was_mirror_ = false;  ///< A headset showed the model in the last picture.
    PanelInput panel_input_;
    WindowWishes wishes_;
};

}  // namespace feelem::viewer
