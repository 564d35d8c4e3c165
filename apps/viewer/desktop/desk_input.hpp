// SPDX-License-Identifier: Apache-2.0
// Events of the window -> what the person does: pointer and commands for core, the camera, the panels. No
// SDL.
#pragma once

#include "viewer/core/input.hpp"
#include "viewer/core/panel_input.hpp"
#include "viewer/desktop/camera.hpp"
#include "viewer/desktop/keys.hpp"
#include "viewer/desktop/window.hpp"

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace feelem::viewer {

/// What must be known of the rest to read events.
struct DeskSituation {
    double time = 0;  ///< Seconds.
    glm::ivec2 pixels{1280, 800};
    PadState pad;
    bool over_panel = false;  ///< A panel wants the mouse (Gui::wants_pointer).
    bool is_typing = false;   ///< A panel's field wants the keys (Gui::wants_keys).
    WorldBox box;             ///< Of the drawn model.
    /// Where a ray meets the drawn model (world); empty: beside it.
    std::function<std::optional<glm::vec3>(const Ray&)> hit;
};

struct DeskFrame {
    FrameInput input;  ///< Head, pointer, hold, commands.
    PanelInput panel;
    std::vector<DeskAction> actions;   ///< Theme, Help, FullScreen: not the camera's.
    std::vector<std::string> dropped;  ///< Paths.
    bool close_wanted = false;
};

/// Keeps what is pressed between frames, and the camera. Fit and Home move it, and are handed on as commands
/// too.
class DeskInput {
public:
    DeskFrame step(std::span<const DeskEvent> events, const DeskSituation& situation);
    DeskCamera& camera() noexcept { return camera_; }
    const DeskCamera& camera() const noexcept { return camera_; }

private:
    enum class Drag : std::uint8_t {
        None,
        Probe,
        Turn,
        Pan,
        Pinch,
        Panel,
    };
    struct Step;
    void take(const DeskEvent& event, Step& step);
    void take_key(const DeskEvent& event, Step& step);
    void take_press(const DeskEvent& event, Step& step);
    void take_move(const DeskEvent& event, Step& step);
    void take_finger(const DeskEvent& event, Step& step);
    void take_pad(const DeskEvent& event, Step& step);
    void act(DeskAction action, Step& step);
    void command(Command command, Step& step);
    void move_by_pad(Step& step);
    void let_go();

    DeskCamera camera_;
    Drag drag_ = Drag::None;
    std::optional<glm::vec2> at_;  ///< Of the mouse or the only finger, pixels.
    std::array<bool, 3> buttons_{};
    std::map<std::int64_t, glm::vec2> fingers_;
    bool shift_ = false, holds_key_ = false, holds_pad_ = false, is_focused_ = true, is_placed_ = false;
    double time_ = 0;
    glm::ivec2 pixels_{0};
};

}  // namespace feelem::viewer
