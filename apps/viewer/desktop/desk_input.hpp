// SPDX-License-Identifier: Apache-2.0
// Events of the window -> what the person does: pointer and commands for core, the camera, the panels. No
// SDL.
#pragma once

#include "viewer/core/input.hpp"
#include "viewer/core/panel_input.hpp"
#include "viewer/desktop/camera.hpp"
#include "viewer/desktop/keys.hpp"
#include "viewer/desktop/window.hpp"

#include <glm/mat3x3.hpp>

#include <array>
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
    float density = 1;  ///< Window::density.
    /// Where the model is drawn in the window: x, y from above, width, height in pixels (DeskGui::stage).
    /// Empty: in the whole window.
    std::optional<std::array<int, 4>> stage;
    PadState pad;
    bool over_panel = false;  ///< A panel wants the mouse (DeskGui::wants_pointer).
    bool is_typing = false;   ///< A panel's field wants the keys (DeskGui::wants_keys).
    WorldBox box;             ///< Of the drawn model.
    glm::mat3 to_world{1};    ///< Model axes -> world axes (scale does not matter).
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

/// Keeps what is pressed between frames, and the camera, which it moves. Fit and Home are handed on as
/// commands too. The first call fits the model into the stage.
class DeskInput {
public:
    DeskFrame step(std::span<const DeskEvent> events, const DeskSituation& situation);
    DeskCamera& camera() noexcept { return camera_; }
    const DeskCamera& camera() const noexcept { return camera_; }

private:
    /// What a button of the mouse, or fingers, do while they are down.
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
    void take_button(const DeskEvent& event, Step& step);
    void take_finger(const DeskEvent& event, Step& step);
    void take_pad(const DeskEvent& event, Step& step);
    void press(int button, Step& step);
    void release(int button);
    void move_to(glm::vec2 at, Step& step);
    void pinch_from(const std::map<std::int64_t, glm::vec2>& before, Step& step);
    void act(DeskAction action, bool is_repeated, Step& step);
    void view(const glm::vec3& direction, Step& step);
    void command(Command command, Step& step);
    void move_by_pad(Step& step);
    void let_go();
    void finish(Step& step);

    DeskCamera camera_;
    Drag drag_ = Drag::None;
    std::optional<glm::vec2> at_;  ///< Of the mouse or the only finger, pixels.
    std::array<bool, 3> buttons_{}, pressed_now_{}, let_go_later_{};
    std::map<std::int64_t, glm::vec2> fingers_;
    bool shift_ = false, holds_key_ = false, holds_pad_ = false, is_focused_ = true;
    bool pad_points_ = false;  ///< The gamepad was used last: the middle of the stage is pointed at.
    bool by_finger_ = false, lifted_ = false;
    int fits_ = 1;  ///< So many frames to come fit the model, unless the person moves the camera.
    float aspect_ = 0;
    std::optional<double> time_;
};

}  // namespace feelem::viewer
