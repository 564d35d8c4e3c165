// SPDX-License-Identifier: Apache-2.0
// SDL's window, OpenGL context, events and gamepad.
#include "viewer/desktop/window.hpp"

#include <SDL.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace feelem::viewer {
namespace {

/// Letters of 13 points are readable up to here.
constexpr float kPlainDotsPerInch = 106;
constexpr int kSmallestWidth = 640, kSmallestHeight = 400;

std::string sdl_trouble() {
    const char* text = SDL_GetError();
    return text && *text ? text : "no reason given";
}

void set_hints() {
    // Fingers are fingers, and nothing comes twice.
    SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");
    SDL_SetHint(SDL_HINT_MOUSE_TOUCH_EVENTS, "0");
    SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
}

void ask_for_context(int samples) {
    SDL_GL_ResetAttributes();
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 4);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 5);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLEBUFFERS, samples > 1 ? 1 : 0);
    SDL_GL_SetAttribute(SDL_GL_MULTISAMPLESAMPLES, samples > 1 ? samples : 0);
}

std::string key_name(SDL_Keycode key) {
    return SDL_GetKeyName(key);
}

/// What a keyboard with US letters has there.
std::string place_name(SDL_Scancode place) {
    return SDL_GetScancodeName(place);
}

/// 0 primary, 1 secondary, 2 middle; -1: another.
int button_of(std::uint8_t button) {
    if (button == SDL_BUTTON_LEFT) return 0;
    if (button == SDL_BUTTON_RIGHT) return 1;
    return button == SDL_BUTTON_MIDDLE ? 2 : -1;
}

float stick_of(std::int16_t value) {
    return std::clamp(static_cast<float>(value) / 32767.0F, -1.0F, 1.0F);
}

}  // namespace

struct Window::State {
    SDL_Window* window = nullptr;
    SDL_GLContext context = nullptr;
    SDL_GameController* pad = nullptr;
    bool has_video = false, has_pads = false;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (pad) SDL_GameControllerClose(pad);
        if (context) SDL_GL_DeleteContext(context);
        if (window) SDL_DestroyWindow(window);
        if (has_pads) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
        if (has_video) SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }

    void open(const WindowOptions& options);
    bool open_with(const WindowOptions& options, int samples);
    void open_first_pad();
    glm::vec2 pixels_a_unit() const;
    std::optional<DeskEvent> translate(const SDL_Event& event);
    std::optional<DeskEvent> of_key(const SDL_KeyboardEvent& event) const;
    std::optional<DeskEvent> of_window(const SDL_WindowEvent& event) const;
    std::optional<DeskEvent> of_pad(const SDL_Event& event);
    DeskEvent at(DeskEvent::Kind kind, float x, float y) const;
};

bool Window::State::open_with(const WindowOptions& options, int samples) {
    ask_for_context(samples);
    const Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI |
                         (options.hidden ? SDL_WINDOW_HIDDEN : SDL_WINDOW_SHOWN);
    window = SDL_CreateWindow(
        options.title.c_str(),
        SDL_WINDOWPOS_CENTERED,
        SDL_WINDOWPOS_CENTERED,
        options.width,
        options.height,
        flags
    );
    if (!window) return false;
    context = SDL_GL_CreateContext(window);
    if (context) return true;
    SDL_DestroyWindow(std::exchange(window, nullptr));
    return false;
}

void Window::State::open(const WindowOptions& options) {
    set_hints();
    has_video = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
    if (!has_video)
        throw NoWindow(fmt::format(
            "no screen to open a window on ({}). Start the program in a desktop session, or let it draw "
            "into a file with --screenshot.",
            sdl_trouble()
        ));
    if (!open_with(options, options.samples) && !open_with(options, 0))
        throw NoWindow(fmt::format(
            "this screen has no OpenGL 4.5 core profile ({}). Update the graphics driver, or draw in "
            "software with LIBGL_ALWAYS_SOFTWARE=1.",
            sdl_trouble()
        ));
    SDL_SetWindowMinimumSize(window, kSmallestWidth, kSmallestHeight);
    SDL_EventState(SDL_DROPFILE, SDL_ENABLE);
    SDL_StopTextInput();
    has_pads = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
    if (has_pads) open_first_pad();
}

void Window::State::open_first_pad() {
    for (int i = 0; !pad && i < SDL_NumJoysticks(); ++i)
        if (SDL_IsGameController(i)) pad = SDL_GameControllerOpen(i);
}

/// Of a screen of high density the window counts in units of several pixels.
glm::vec2 Window::State::pixels_a_unit() const {
    int width = 0;
    int height = 0;
    int wide = 0;
    int high = 0;
    SDL_GetWindowSize(window, &width, &height);
    SDL_GL_GetDrawableSize(window, &wide, &high);
    if (width <= 0 || height <= 0) return glm::vec2(1);
    return {
        static_cast<float>(wide) / static_cast<float>(width),
        static_cast<float>(high) / static_cast<float>(height)};
}

DeskEvent Window::State::at(DeskEvent::Kind kind, float x, float y) const {
    DeskEvent out;
    out.kind = kind;
    out.at = glm::vec2(x, y) * pixels_a_unit();
    return out;
}

std::optional<DeskEvent> Window::State::of_key(const SDL_KeyboardEvent& event) const {
    DeskEvent out;
    out.kind = event.type == SDL_KEYDOWN ? DeskEvent::Kind::KeyDown : DeskEvent::Kind::KeyUp;
    out.text = key_name(event.keysym.sym);
    out.place = place_name(event.keysym.scancode);
    out.shift = (event.keysym.mod & KMOD_SHIFT) != 0;
    out.control = (event.keysym.mod & (KMOD_CTRL | KMOD_GUI)) != 0;
    out.repeated = event.repeat != 0;
    // Alt belongs to the desktop; the right one only writes signs.
    if ((event.keysym.mod & KMOD_LALT) != 0 && out.kind == DeskEvent::Kind::KeyDown) return std::nullopt;
    return out;
}

std::optional<DeskEvent> Window::State::of_window(const SDL_WindowEvent& event) const {
    DeskEvent out;
    switch (event.event) {
    case SDL_WINDOWEVENT_FOCUS_GAINED: out.kind = DeskEvent::Kind::FocusGained; return out;
    case SDL_WINDOWEVENT_FOCUS_LOST: out.kind = DeskEvent::Kind::FocusLost; return out;
    case SDL_WINDOWEVENT_LEAVE: out.kind = DeskEvent::Kind::PointerLeft; return out;
    case SDL_WINDOWEVENT_CLOSE: out.kind = DeskEvent::Kind::CloseWanted; return out;
    default: return std::nullopt;
    }
}

std::optional<DeskEvent> Window::State::of_pad(const SDL_Event& event) {
    if (event.type == SDL_CONTROLLERDEVICEADDED) {
        if (!pad) open_first_pad();
        return std::nullopt;
    }
    if (event.type == SDL_CONTROLLERDEVICEREMOVED) {
        if (pad && !SDL_GameControllerGetAttached(pad)) {
            SDL_GameControllerClose(std::exchange(pad, nullptr));
            open_first_pad();
        }
        return std::nullopt;
    }
    DeskEvent out;
    out.kind =
        event.type == SDL_CONTROLLERBUTTONDOWN ? DeskEvent::Kind::PadPressed : DeskEvent::Kind::PadReleased;
    const char* name =
        SDL_GameControllerGetStringForButton(static_cast<SDL_GameControllerButton>(event.cbutton.button));
    if (!name) return std::nullopt;
    out.text = name;
    return out;
}

std::optional<DeskEvent> Window::State::translate(const SDL_Event& event) {
    using Kind = DeskEvent::Kind;
    switch (event.type) {
    case SDL_KEYDOWN:
    case SDL_KEYUP: return of_key(event.key);
    case SDL_WINDOWEVENT: return of_window(event.window);
    case SDL_CONTROLLERDEVICEADDED:
    case SDL_CONTROLLERDEVICEREMOVED:
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP: return of_pad(event);
    case SDL_MOUSEMOTION:
        return at(Kind::Moved, static_cast<float>(event.motion.x), static_cast<float>(event.motion.y));
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP: {
        DeskEvent out =
            at(event.type == SDL_MOUSEBUTTONDOWN ? Kind::Pressed : Kind::Released,
               static_cast<float>(event.button.x),
               static_cast<float>(event.button.y));
        out.button = button_of(event.button.button);
        out.clicks = event.button.clicks;
        return out;
    }
    case SDL_MOUSEWHEEL: {
        const float side = event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -1.0F : 1.0F;
        DeskEvent out =
            at(Kind::Wheel, static_cast<float>(event.wheel.mouseX), static_cast<float>(event.wheel.mouseY));
        out.wheel = glm::vec2(event.wheel.preciseX, event.wheel.preciseY) * side;
        return out;
    }
    case SDL_FINGERDOWN:
    case SDL_FINGERMOTION:
    case SDL_FINGERUP: {
        int width = 0;
        int height = 0;
        SDL_GetWindowSize(window, &width, &height);
        DeskEvent out =
            at(event.type == SDL_FINGERDOWN ? Kind::FingerDown
               : event.type == SDL_FINGERUP ? Kind::FingerUp
                                            : Kind::FingerMoved,
               event.tfinger.x * static_cast<float>(width),
               event.tfinger.y * static_cast<float>(height));
        out.finger = event.tfinger.fingerId;
        return out;
    }
    case SDL_TEXTINPUT: {
        DeskEvent out;
        out.kind = Kind::Text;
        out.text = event.text.text;
        return out;
    }
    case SDL_DROPFILE: {
        DeskEvent out;
        out.kind = Kind::Dropped;
        if (event.drop.file) out.text = event.drop.file;
        SDL_free(event.drop.file);
        return out;
    }
    case SDL_QUIT: {
        DeskEvent out;
        out.kind = Kind::CloseWanted;
        return out;
    }
    default: return std::nullopt;
    }
}

Window::Window(const WindowOptions& options) : state_(std::make_unique<State>()) {
    state_->open(options);
    set_vsync(options.vsync);
}

Window::~Window() = default;

std::vector<DeskEvent> Window::poll() {
    std::vector<DeskEvent> out;
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0)
        if (std::optional<DeskEvent> translated = state_->translate(event))
            out.push_back(std::move(*translated));
    return out;
}

PadState Window::pad() const {
    PadState out;
    SDL_GameController* pad = state_->pad;
    if (!pad || !is_focused()) return out;
    const auto axis = [&](SDL_GameControllerAxis which) {
        return stick_of(SDL_GameControllerGetAxis(pad, which));
    };
    out.is_connected = true;
    out.can_rumble = SDL_GameControllerHasRumble(pad) == SDL_TRUE;
    out.left = {axis(SDL_CONTROLLER_AXIS_LEFTX), -axis(SDL_CONTROLLER_AXIS_LEFTY)};
    out.right = {axis(SDL_CONTROLLER_AXIS_RIGHTX), -axis(SDL_CONTROLLER_AXIS_RIGHTY)};
    out.left_trigger = std::max(axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT), 0.0F);
    out.right_trigger = std::max(axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT), 0.0F);
    return out;
}

glm::ivec2 Window::pixels() const {
    glm::ivec2 out{0};
    SDL_GL_GetDrawableSize(state_->window, &out.x, &out.y);
    return out;
}

float Window::density() const {
    const float by_units = state_->pixels_a_unit().y;
    if (by_units > 1) return by_units;
    // X11 counts in pixels whatever the screen: then its size in inches tells.
    float inch = 0;
    const int display = SDL_GetWindowDisplayIndex(state_->window);
    if (display < 0 || SDL_GetDisplayDPI(display, &inch, nullptr, nullptr) != 0) return 1;
    return std::clamp(std::floor(inch / kPlainDotsPerInch * 2) / 2, 1.0F, 3.0F);
}

bool Window::is_focused() const {
    return (SDL_GetWindowFlags(state_->window) & SDL_WINDOW_INPUT_FOCUS) != 0;
}

bool Window::is_shown() const {
    return (SDL_GetWindowFlags(state_->window) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) == 0;
}

void Window::make_current() {
    SDL_GL_MakeCurrent(state_->window, state_->context);
}

void Window::swap() {
    SDL_GL_SwapWindow(state_->window);
}

void Window::set_vsync(bool on) {
    if (!on) {
        SDL_GL_SetSwapInterval(0);
        return;
    }
    // Late pictures are shown at once where the driver can, rather than a whole beat later.
    if (SDL_GL_SetSwapInterval(-1) != 0) SDL_GL_SetSwapInterval(1);
}

void Window::set_title(const std::string& title) {
    SDL_SetWindowTitle(state_->window, title.c_str());
}

void Window::set_full_screen(bool on) {
    SDL_SetWindowFullscreen(state_->window, on ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

bool Window::is_full_screen() const {
    return (SDL_GetWindowFlags(state_->window) & SDL_WINDOW_FULLSCREEN_DESKTOP) ==
           SDL_WINDOW_FULLSCREEN_DESKTOP;
}

void Window::set_typing(bool on) {
    if (on == (SDL_IsTextInputActive() == SDL_TRUE)) return;
    if (on)
        SDL_StartTextInput();
    else
        SDL_StopTextInput();
}

bool Window::rumble(float low, float high, std::uint32_t milliseconds) {
    if (!state_->pad) return false;
    const auto strength = [](float share) {
        return static_cast<Uint16>(std::lround(std::clamp(share, 0.0F, 1.0F) * 65535.0F));
    };
    return SDL_GameControllerRumble(state_->pad, strength(low), strength(high), milliseconds) == 0;
}

}  // namespace feelem::viewer
