// SPDX-License-Identifier: Apache-2.0
// Which key does what: one table serves the handler, the help panel and docs/native-viewer-keys.md.
#pragma once

#include "viewer/core/input.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace feelem::viewer {

/// What a key does to the window or its camera alone.
enum class DeskAction : std::uint8_t {
    Hold,  ///< As long as it is down: hear and feel.
    TurnLeft,
    TurnRight,
    TurnUp,
    TurnDown,
    MoveLeft,
    MoveRight,
    MoveUp,
    MoveDown,
    Nearer,
    Further,
    ViewX,
    ViewY,
    ViewZ,
    ViewAll,  ///< From the first direction.
    Theme,
    Help,
    FullScreen,
};

struct KeyBinding {
    std::string_view key;  ///< As SDL names it: "F", "Space", "Left".
    bool shift = false, control = false;
    std::string_view shown;  ///< "Shift P"
    std::string_view text;   ///< What it does.
    std::optional<Command> command;
    std::optional<DeskAction> action;
};

std::span<const KeyBinding> key_bindings();
/// nullptr: the key means nothing.
const KeyBinding* find_binding(std::string_view key, bool shift, bool control);

}  // namespace feelem::viewer
