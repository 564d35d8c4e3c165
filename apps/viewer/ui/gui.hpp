// SPDX-License-Identifier: Apache-2.0
// One surface with panels: the window, or a board in the room. Holds Dear ImGui's context, fonts and GL
// objects.
#pragma once

#include "viewer/core/panel_input.hpp"
#include "viewer/core/space.hpp"
#include "viewer/ui/ui_model.hpp"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace feelem::viewer {

/// Something of a panel that can be pressed, in pixels of its surface; what is out of sight is not listed.
struct UiTarget {
    std::string name;  ///< "results/stress/pulses"
    glm::vec2 low{0}, high{0};
};

/// Needs a current OpenGL 4.5 context, the same one in every call. Several may live side by side.
class DeskGui {
public:
    /// `density`: pixels a point (Window::density).
    explicit DeskGui(float density);
    ~DeskGui();
    DeskGui(const DeskGui&) = delete;
    DeskGui& operator=(const DeskGui&) = delete;

    /// Draws over what stands in the bound framebuffer of this size; viewport and state come back as they
    /// were.
    UiWishes draw(const UiModel& model, const PanelInput& input, glm::ivec2 pixels);
    /// The stage between the panels, where the model is seen: x, y (from above), width, height in pixels.
    std::array<int, 4> stage(glm::ivec2 pixels) const;
    bool wants_pointer() const;  ///< The mouse is over a panel, or holds something of it.
    bool wants_keys() const;     ///< A field is typed into.
    /// Of the last picture.
    const std::vector<UiTarget>& targets() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

enum class Board : std::uint8_t {
    Panel,  ///< Tabs: results, steps, parts, section, places, senses, about.
    Legend,
    Card,
};
inline constexpr std::size_t kBoards = 3;

struct BoardSize {
    glm::ivec2 pixels{0};
    glm::vec2 metres{0};  ///< At this size letters are half a degree high at 1.2 m.
};
BoardSize size_of(Board board);

/// A board as a texture for a quad layer: RGBA8, sRGB, premultiplied alpha, first row lowest.
class BoardTexture {
public:
    explicit BoardTexture(Board board);
    ~BoardTexture();
    BoardTexture(const BoardTexture&) = delete;
    BoardTexture& operator=(const BoardTexture&) = delete;

    UiWishes draw(const UiModel& model, const PanelInput& input);
    std::uint32_t texture() const;      ///< GL name.
    std::uint32_t framebuffer() const;  ///< To blit from.
    bool wants_pointer() const;         ///< Something of it is held, or pointed at.
    const std::vector<UiTarget>& targets() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Where a ray meets a board whose middle is `pose` (its front looks along the pose's +Z): pixels from the
/// upper left corner, for PanelInput::at, and how far it is. Empty: beside it, or from behind.
struct BoardHit {
    glm::vec2 at{0};
    float metres = 0;
};
std::optional<BoardHit> hit_board(const Ray& ray, const Pose& pose, const BoardSize& size);

}  // namespace feelem::viewer
