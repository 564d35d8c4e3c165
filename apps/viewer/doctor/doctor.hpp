// SPDX-License-Identifier: Apache-2.0
// `feelem-xr doctor`: what of this machine works for the viewer, what does not, and the one thing to do
// first. What must be tried, graphics and headset, is tried by the caller; the rest is read from files.
#pragma once

#include "viewer/doctor/machine.hpp"
#include "viewer/xr/xr_system.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace feelem::viewer {

struct TriedGraphics {
    std::string version,
        renderer;                ///< As OpenGL says them: "4.5 (Core Profile) Mesa 22.3.6", "llvmpipe (...)".
    std::string trouble;         ///< Why there is no OpenGL 4.5; a sentence without its full stop.
    std::string screen_trouble;  ///< Why there is no window, and in further sentences what to do.
};

enum class Health {
    Well,
    Poor,  ///< It works, but not as it should.
    Missing,
};

struct Finding {
    std::string_view what;  ///< "graphics"
    Health health = Health::Well;
    std::string text;
    std::string advice;  ///< What to do, in one sentence; empty: nothing, or nothing that can be done.
};

/// In the order in which things build on each other. `headset`: what it said when it was tried; null: it
/// could not be.
std::vector<Finding> examine(const Machine& machine, const TriedGraphics& graphics, const XrStatus* headset);

struct Verdict {
    bool desk = false, headset = false;
};
Verdict verdict_on(const std::vector<Finding>& findings);

/// All findings, the verdict, and the first advice, for people.
std::string report_of(const std::vector<Finding>& findings);

}  // namespace feelem::viewer
