// SPDX-License-Identifier: Apache-2.0
// The page's line icons (web/src/ui/icons.ts), 20 by 20, drawn as paths.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <string_view>

namespace feelem::viewer {

enum class Icon : std::uint8_t {
    Eye,
    Ear,
    Ticks,
    Hand,
    Shape,
    Off,
    Play,
    Pause,
    Back,
    Next,
    Fit,
    Mesh,
    Pins,
    Theme,
    Sound,
    Mute,
    Headset,
    Close,
    Plus,
    Glass,
    Target,
    Cut,
    Keys,
    Home,
    Ghost,
};

/// The icon's path as SVG writes it.
std::string_view path_of(Icon icon);
/// In a square of this side.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 corner, float side, ImU32 colour);

}  // namespace feelem::viewer
