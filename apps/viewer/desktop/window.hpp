// SPDX-License-Identifier: Apache-2.0
// The window: an OpenGL 4.5 core context, and what mouse, keyboard, fingers and gamepad did. SDL stays behind
// it.
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace feelem::viewer {

struct DeskEvent {
    enum class Kind : std::uint8_t {
        KeyDown,
        KeyUp,
        Text,
        Moved,    ///< Mouse.
        Pressed,  ///< Mouse button.
        Released,
        Wheel,
        PointerLeft,
        FingerDown,
        FingerMoved,
        FingerUp,
        PadPressed,
        PadReleased,
        FocusGained,
        FocusLost,
        Dropped,
        CloseWanted,
    } kind = Kind::Moved;
    std::string text;   ///< Key or pad button by name, text typed (UTF-8), or the path that was dropped.
    std::string place;  ///< Name of the key that a US keyboard has there.
    bool shift = false, control = false, repeated = false;
    glm::vec2 at{0};     ///< Pixels from the upper left corner.
    glm::vec2 wheel{0};  ///< Notches right and up.
    int button = 0;      ///< 0 primary, 1 secondary, 2 middle.
    int clicks = 1;      ///< 2: the second press of a double one.
    std::int64_t finger = 0;
};

/// The first gamepad. Sticks -1..1, right and up; triggers 0..1.
struct PadState {
    bool is_connected = false, can_rumble = false;
    glm::vec2 left{0}, right{0};
    float left_trigger = 0, right_trigger = 0;
};

struct WindowOptions {
    std::string title = "Feelem";
    int width = 1280, height = 800;  ///< Points: more pixels on a screen of high density.
    int samples = 4;                 ///< Of a pixel; fewer where the driver has none.
    bool vsync = true;               ///< False while a headset gives the beat.
    bool hidden = false;
};

/// There is no screen, or no OpenGL 4.5 on it. what() says so in words for people, with what to do.
class NoWindow : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Throws NoWindow. One at a time; main thread.
class Window {
public:
    explicit Window(const WindowOptions& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// What happened since the last call, in its order.
    std::vector<DeskEvent> poll();
    PadState pad() const;
    glm::ivec2 pixels() const;
    /// Pixels a point: 2 on a screen of high density. Sizes of letters are times this.
    float density() const;
    bool is_focused() const;
    bool is_shown() const;  ///< Not minimised.
    void make_current();
    void swap();
    void set_vsync(bool on);
    void set_title(const std::string& title);
    void set_full_screen(bool on);
    bool is_full_screen() const;
    /// Fields of panels want text: opens the keyboard of a screen without keys, too.
    void set_typing(bool on);
    /// Low and high motor, 0..1, for so long; replaces what runs. False: no gamepad, or it has no motor.
    bool rumble(float low, float high, std::uint32_t milliseconds);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace feelem::viewer
