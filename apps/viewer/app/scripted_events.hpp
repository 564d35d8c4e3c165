// SPDX-License-Identifier: Apache-2.0
// Deeds of a script as what the window would have said.
#pragma once

#include "viewer/app/script.hpp"
#include "viewer/desktop/window.hpp"

#include <span>
#include <string>
#include <vector>

namespace feelem::viewer {

struct ScriptedFrame {
    std::vector<DeskEvent> events;
    std::vector<std::string> screenshots;  ///< Files to be written after the frame.
    bool quits = false;
};

class ScriptedHand {
public:
    /// `pixels`: of the window.
    ScriptedFrame frame(std::span<const ScriptedDeed> deeds, glm::ivec2 pixels);

private:
    glm::vec2 at_{0};
};

}  // namespace feelem::viewer
