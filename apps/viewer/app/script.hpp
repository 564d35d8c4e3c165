// SPDX-License-Identifier: Apache-2.0
// What a person would do at the desk, written down: for tests, pictures and talks.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feelem::viewer {

enum class Deed {
    Move,   ///< The mouse, to a place of the window.
    Press,  ///< A button of it: left, middle or right.
    Release,
    Wheel,    ///< So many notches towards the model.
    Key,      ///< Pressed and let go.
    HoldKey,  ///< Until LeaveKey.
    LeaveKey,
    Screenshot,  ///< Of the window, into a PNG file.
    Quit,
};

struct ScriptedDeed {
    double at = 0;  ///< Seconds from the first picture.
    Deed deed = Deed::Quit;
    double x = 0, y = 0;  ///< Move: fractions of the window, from its upper left corner. Wheel: `y` notches.
    std::string word;     ///< The button, the key's name, or the file.
};

/// One deed a line, "SECONDS WORD ARGUMENTS"; '#' begins a remark. "glide X1 Y1 X2 Y2 SECONDS" becomes moves,
/// sixty a second. In order of time, of equal times in that of the file. Throws Error(BadOption) with the
/// line.
std::vector<ScriptedDeed> parse_script(std::string_view text, const std::string& name);

/// Those due in the time from the last call up to and with `now`.
class ScriptPlayer {
public:
    explicit ScriptPlayer(std::vector<ScriptedDeed> deeds) : deeds_(std::move(deeds)) {}
    std::span<const ScriptedDeed> due(double now);
    bool is_done() const noexcept { return next_ == deeds_.size(); }

private:
    std::vector<ScriptedDeed> deeds_;
    std::size_t next_ = 0;
};

}  // namespace feelem::viewer
