// SPDX-License-Identifier: Apache-2.0
// The boards of the room: panel, legend and card, where they stand, what is on them, and which hand means
// them.
#pragma once

#include "viewer/core/viewer.hpp"
#include "viewer/ui/gui.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace feelem::viewer {

struct BoardPlace {
    Pose pose;          ///< Of its middle, its front along +Z.
    glm::vec2 size{0};  ///< Metres.
    bool is_shown = false;
};

/// Panel and legend stand to the sides of the person's place, the other way round for the left-handed; the
/// card above what is pointed at, as large for the eyes at any distance.
std::array<BoardPlace, kBoards> place_boards(
    const Stand& stand,
    float eye_height,
    bool left_handed,
    const Snapshot& snapshot,
    const Look& look,
    const glm::vec3& eye
);

/// The board that a hand's ray meets first, of those that can be pressed.
struct PointedBoard {
    Board board = Board::Panel;
    BoardHit hit;
};
std::optional<PointedBoard> pointed_board(const Ray& ray, std::span<const BoardPlace, kBoards> places);

/// Sets HandInput::panel_distance of both hands, and gives what the hands do to the panel: the hand that
/// pulled its trigger last is the one that counts, the right one at first. A trigger that was pulled
/// elsewhere presses nothing: who sweeps the model may come across a board.
class BoardPointer {
public:
    PanelInput point(FrameInput& input, std::span<const BoardPlace, kBoards> places);

private:
    std::size_t hand_ = 1;
    std::array<bool, kSides> is_pulled_{}, presses_{};  ///< Its trigger; and that on the panel.
    double time_ = 0;
};

}  // namespace feelem::viewer
