// SPDX-License-Identifier: Apache-2.0
// What points at and types into panels: the mouse and keyboard of a window, or the ray of a hand on a panel
// in the room. Made by desktop, or from a ray, read by ui.
#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace feelem::viewer {

/// Keys that fields of panels know, beside the text that is typed.
enum class PanelKey : std::uint8_t {
    Tab,
    Left,
    Right,
    Up,
    Down,
    Home,
    End,
    Delete,
    Backspace,
    Enter,
    Escape,
    All,  ///< Ctrl A, to be typed over.
};

struct PanelInput {
    std::optional<glm::vec2> at;  ///< Pixels from the upper left corner; empty: points elsewhere.
    std::optional<glm::vec2>
        pointer;  ///< Where it is, also while it belongs to the model: nothing is put there.
    std::array<bool, 3> buttons{};  ///< Primary, secondary, middle. A hand's trigger is the primary one.
    float wheel = 0;                ///< Notches upwards.
    std::string text;               ///< UTF-8 typed since the last frame.
    std::vector<PanelKey> keys;     ///< Pressed since the last frame.
    double seconds = 1.0 / 60.0;    ///< Since the last frame.
};

}  // namespace feelem::viewer
