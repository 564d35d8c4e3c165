// SPDX-License-Identifier: Apache-2.0
// Which panel stands where: in the window round the stage, and on the boards of the room.
#pragma once

#include "viewer/ui/gui.hpp"
#include "viewer/ui/widgets.hpp"

namespace feelem::viewer {

struct UiRect {
    float x = 0, y = 0, width = 0, height = 0;
};
struct DeskRects {
    UiRect top, left, stage, right, bottom;
};
/// Whole pixels.
DeskRects desk_rects(glm::ivec2 pixels, float unit);

void draw_desk(Pen& pen, glm::ivec2 pixels);
void draw_board(Pen& pen, Board board, glm::ivec2 pixels);

}  // namespace feelem::viewer
