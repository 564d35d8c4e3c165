// SPDX-License-Identifier: Apache-2.0
// What happens to the scripted headset, by frame.
#pragma once

#include "place.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace feelem::xr_runtime {

/// `FRAME VERB WORDS...`: takes place in the xrWaitFrame of that number, counted from 0 over all sessions.
struct Line {
    std::uint64_t frame = 0;
    std::vector<std::string> words;
};

/// Lines in order of their frames; `#` begins a comment.
std::vector<Line> read_script(const std::string& path);

struct Hand {
    Place place;
    bool is_tracked = true;
    bool is_bare = false;       ///< No controller in it; its joints are seen.
    float pinch = 0, fist = 0;  ///< 0..1, of a bare hand.
    std::string profile = "/interaction_profiles/oculus/touch_controller";
    std::map<std::string, float> inputs;  ///< "trigger/value" -> 0..1
};

struct World {
    Place head{{0, 1.6F, 0}};
    Place local{{0, 1.6F, 0}};  ///< Origin of the LOCAL space.
    bool is_head_tracked = true;
    std::array<Hand, 2> hands{
        Hand{{{-0.2F, 1.2F, -0.3F}}, true, false, 0, 0, "/interaction_profiles/oculus/touch_controller", {}},
        Hand{{{0.2F, 1.2F, -0.3F}}, true, false, 0, 0, "/interaction_profiles/oculus/touch_controller", {}}};
    bool renders = true;
    bool refuses_haptics = false;
};

/// Carries out a line that changes the world alone: pose, tracking, input, profile, hand, render, haptics.
/// False: the line is of another kind.
bool change(World& world, const Line& line);

}  // namespace feelem::xr_runtime
