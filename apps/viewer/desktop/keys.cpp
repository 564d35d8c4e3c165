// SPDX-License-Identifier: Apache-2.0
// The keys, as on the page where the page has the same function.
#include "viewer/desktop/keys.hpp"

#include <algorithm>
#include <array>

namespace feelem::viewer {
namespace {

constexpr KeyBinding bound(
    std::string_view key, std::string_view shown, std::string_view text, Command command, bool shift = false
) {
    return {.key = key, .shift = shift, .shown = shown, .text = text, .command = command, .action = {}};
}

struct Chord {
    std::string_view key;
    bool shift = false, control = false;
};
constexpr KeyBinding bound(Chord chord, std::string_view shown, std::string_view text, DeskAction action) {
    return {chord.key, chord.shift, chord.control, shown, text, {}, action};
}
constexpr KeyBinding bound(Chord chord, std::string_view shown, std::string_view text, Command command) {
    return {chord.key, chord.shift, chord.control, shown, text, command, {}};
}

constexpr std::array kBindings{
    bound(Chord{"S"}, "S", "hold: hear and feel", DeskAction::Hold),
    bound("Space", "Space", "play, pause", Command::PlaySteps),
    bound("Space", "Shift Space", "let the mode swing, or not", Command::AnimateMode, true),
    bound(",", ",", "step before", Command::PreviousStep),
    bound(".", ".", "step after", Command::NextStep),
    bound("F", "F", "fit", Command::Fit),
    bound("Home", "Home", "first view", Command::Home),
    bound("1", "1", "true deformation", Command::TrueDeformation),
    bound("0", "0", "undeformed", Command::NoDeformation),
    bound("1", "Shift 1", "model in its true size", Command::TrueScale, true),
    bound("Tab", "Tab", "next result is seen", Command::NextResult),
    bound("M", "M", "mute", Command::ToggleMute),
    bound("V", "V", "touch on, off", Command::ToggleStill),
    bound("Z", "Z", "find the largest value by ear", Command::ToggleGuide),
    bound("C", "C", "cut the model, or not", Command::ToggleClip),
    bound("[", "[", "plane back", Command::ClipBack),
    bound("]", "]", "plane ahead", Command::ClipForward),
    bound("E", "E", "element edges", Command::ToggleEdges),
    bound("O", "O", "lines between bands", Command::ToggleIsolines),
    bound("U", "U", "undeformed shape as lines", Command::ToggleGhost),
    bound("P", "P", "note at this place", Command::PlaceMarker),
    bound("P", "Shift P", "remove all notes", Command::RemoveMarkers, true),
    bound("N", "N", "to the next hot spot", Command::NextHotSpot),
    bound("B", "B", "to the hot spot before", Command::PreviousHotSpot),
    bound(
        Chord{"S", false, true}, "Ctrl S", "save the presentation beside the scene", Command::SavePresentation
    ),
    bound("Escape", "Esc", "let go of the place, leave", Command::Leave),
    bound(Chord{"Left", true}, "Shift ←", "turn left", DeskAction::TurnLeft),
    bound(Chord{"Right", true}, "Shift →", "turn right", DeskAction::TurnRight),
    bound(Chord{"Up", true}, "Shift ↑", "turn up", DeskAction::TurnUp),
    bound(Chord{"Down", true}, "Shift ↓", "turn down", DeskAction::TurnDown),
    bound(Chord{"Left", false, true}, "Ctrl ←", "move left", DeskAction::MoveLeft),
    bound(Chord{"Right", false, true}, "Ctrl →", "move right", DeskAction::MoveRight),
    bound(Chord{"Up", false, true}, "Ctrl ↑", "move up", DeskAction::MoveUp),
    bound(Chord{"Down", false, true}, "Ctrl ↓", "move down", DeskAction::MoveDown),
    bound(Chord{"PageUp"}, "PgUp", "nearer", DeskAction::Nearer),
    bound(Chord{"PageDown"}, "PgDn", "further", DeskAction::Further),
    bound(Chord{"X", true}, "Shift X", "look along x", DeskAction::ViewX),
    bound(Chord{"Y", true}, "Shift Y", "look along y", DeskAction::ViewY),
    bound(Chord{"Z", true}, "Shift Z", "look along z", DeskAction::ViewZ),
    bound(Chord{"I", true}, "Shift I", "look at an angle", DeskAction::ViewAll),
    bound(Chord{"T"}, "T", "dark, light", DeskAction::Theme),
    bound(Chord{"F1"}, "F1", "keys", DeskAction::Help),
    bound(Chord{"F11"}, "F11", "full screen", DeskAction::FullScreen),
};

}  // namespace

std::span<const KeyBinding> key_bindings() {
    return kBindings;
}

const KeyBinding* find_binding(std::string_view key, bool shift, bool control) {
    const auto* const found = std::ranges::find_if(kBindings, [&](const KeyBinding& b) {
        return b.key == key && b.shift == shift && b.control == control;
    });
    return found == kBindings.end() ? nullptr : found;
}

}  // namespace feelem::viewer
