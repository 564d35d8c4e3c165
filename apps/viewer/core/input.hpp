// SPDX-License-Identifier: Apache-2.0
// What the person does in one frame, whatever the device. Made by xr or desktop, read by core; time is handed
// in.
#pragma once

#include "viewer/core/space.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace feelem::viewer {

enum class Side : std::uint8_t {
    Left,
    Right
};
inline constexpr std::size_t kSides = 2;

/// A controller, or a bare hand, whose pinch is the trigger and whose fist is the squeeze.
struct HandInput {
    bool is_tracked = false;
    bool is_bare = false;
    Pose aim, grip;
    std::optional<glm::vec3> fingertip;  ///< Of a bare hand: end of the index finger.
    float trigger = 0, squeeze = 0;      ///< 0..1
    glm::vec2 stick{0};                  ///< -1..1: right, ahead.
    bool stick_pressed = false;
    bool lower_button = false,
         upper_button = false;  ///< A and B, X and Y, or what the profile has in their place.
    bool menu = false;
    bool can_vibrate = false;
    /// Its ray meets a panel so far away, metres: it means that, not the model.
    std::optional<float> panel_distance{};
};

/// The mouse (or a finger) on the window.
struct PointerInput {
    std::optional<Ray> ray;  ///< Empty: outside the window, or over a panel.
    bool primary = false, middle = false, secondary = false;
    bool shift = false;
    glm::vec2 moved{0};        ///< Since the last frame, fractions of the window's height; x right, y down.
    float wheel = 0;           ///< Notches towards the model.
    bool can_vibrate = false;  ///< A gamepad is in the other hand.
};

/// Wishes that have a key, a button or an item of a panel. They are named, so that each has one meaning
/// everywhere.
enum class Command : std::uint8_t {
    Home,
    Fit,
    TrueScale,
    NoDeformation,
    TrueDeformation,
    NextStep,
    PreviousStep,
    PlaySteps,
    NextResult,
    ToggleMute,
    ToggleStill,  ///< No vibration.
    ToggleGuide,  ///< Find the largest value by ear.
    ToggleClip,
    ClipForward,
    ClipBack,
    ToggleEdges,
    ToggleIsolines,
    ToggleGhost,
    AnimateMode,
    PlaceMarker,
    RemoveMarkers,
    NextHotSpot,
    PreviousHotSpot,
    SavePresentation,
    Leave,
};

struct FrameInput {
    double time = 0;         ///< Seconds of a clock that never goes back.
    bool is_focused = true;  ///< False: the headset's menu, a window without focus; nothing sounds or shakes.
    Pose head;               ///< Of the headset, or of the desk's camera.
    bool is_headset = false;
    std::array<HandInput, kSides> hands;
    PointerInput pointer;
    bool hold = false;  ///< Key S, as a pressed mouse: hear and feel.
    std::vector<Command> commands;
};

}  // namespace feelem::viewer
