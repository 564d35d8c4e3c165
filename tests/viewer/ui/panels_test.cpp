// SPDX-License-Identifier: Apache-2.0
// The panels as they are seen, and what comes of pressing them.
#include "sample_ui.hpp"

namespace feelem::viewer {
namespace {

using namespace tests;  // NOLINT: helpers of this folder.

class PanelsTest : public tests::WithGl {};

TEST_F(PanelsTest, pictures) {
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        UiModel model = boiler_ui();
        model.theme = theme;
        DeskGui gui(1);
        Canvas canvas({1280, 800}, {150, 155, 158});
        for (int i = 0; i < 3; ++i) {
            canvas.clear();
            gui.draw(model, {}, {1280, 800});
        }
        keep_for_people(canvas.read(), theme == Theme::Light ? "desk-light" : "desk-dark");
    }
    const UiModel model = boiler_ui();
    for (const Board board : {Board::Panel, Board::Legend, Board::Card}) {
        BoardTexture texture(board);
        for (int i = 0; i < 3; ++i) texture.draw(model, {});
        keep_for_people(
            read_framebuffer(texture.framebuffer(), size_of(board).pixels),
            "board-" + std::to_string(static_cast<int>(board))
        );
    }
}

}  // namespace
}  // namespace feelem::viewer
