// SPDX-License-Identifier: Apache-2.0
// Colours and measures of the panels: those of the page (web/src/style.css), and of its boards in the
// headset.
#pragma once

#include "viewer/ui/ui_model.hpp"

#include <imgui.h>

namespace feelem::viewer {

struct UiColours {
    ImU32 paper = 0, panel = 0, ink = 0, soft = 0, faint = 0, line = 0, accent = 0, accent_soft = 0;
    ImU32 alarm = 0, hover = 0;
};

UiColours desk_colours(Theme theme);
UiColours board_colours();

constexpr ImU32 with_alpha(ImU32 colour, unsigned alpha) {
    return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}
ImU32 colour_of(const Rgb& rgb);

struct UiFonts {
    ImFont* plain = nullptr;
    ImFont* bold = nullptr;
    ImFont* small = nullptr;
    ImFont* title = nullptr;
};
/// Heights of letters' lines in pixels; the fonts stay with the current context.
UiFonts load_fonts(float plain, float small, float title);

/// `unit`: pixels a point.
void apply_style(const UiColours& colours, float unit);

}  // namespace feelem::viewer
