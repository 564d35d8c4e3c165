// SPDX-License-Identifier: Apache-2.0
// A real window on a virtual screen: its context, its events, and what it says where there is no screen.
#include "viewer/desktop/desk_input.hpp"
#include "viewer/desktop/pad_haptics.hpp"
#include "viewer/desktop/window.hpp"
#include "virtual_screen.hpp"

#include <SDL.h>
#include <epoxy/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <memory>

namespace feelem::viewer {
namespace {

using Kind = DeskEvent::Kind;

class WindowTest : public ::testing::Test {
protected:
    void SetUp() override {
        const std::string& why = test::virtual_screen();
        if (!why.empty()) GTEST_SKIP() << why;
        window = std::make_unique<Window>(WindowOptions{.title = "Boiler", .width = 900, .height = 600});
        window->poll();
    }

    /// What the window makes of events that SDL is told of.
    std::vector<DeskEvent> told(std::vector<SDL_Event> events) {
        for (SDL_Event& event : events) SDL_PushEvent(&event);
        std::vector<DeskEvent> out = window->poll();
        // The server's own events may come in between.
        std::erase_if(out, [](const DeskEvent& event) {
            return event.kind == Kind::FocusGained || event.kind == Kind::FocusLost ||
                   event.kind == Kind::PointerLeft;
        });
        return out;
    }
    static SDL_Event key(Uint32 type, SDL_Keycode code, Uint16 mod = KMOD_NONE) {
        SDL_Event event{};
        event.type = type;
        event.key.keysym.sym = code;
        event.key.keysym.scancode = SDL_GetScancodeFromKey(code);
        event.key.keysym.mod = mod;
        return event;
    }

    std::unique_ptr<Window> window;
};

TEST_F(WindowTest, has_a_core_context_of_opengl_4_5_and_draws) {
    window->make_current();
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(profile & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_GE(epoxy_gl_version(), 45);
    EXPECT_EQ(window->pixels(), glm::ivec2(900, 600));
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    std::array<std::uint8_t, 4> pixel{};
    glReadPixels(10, 10, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    EXPECT_EQ(pixel[0], 255);
    EXPECT_EQ(pixel[1], 0);
    window->swap();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(WindowTest, a_small_window_asks_for_letters_of_plain_size) {
    EXPECT_EQ(window->density(), 1);
}

TEST_F(WindowTest, keys_are_known_by_name_and_shift) {
    const auto events = told(
        {key(SDL_KEYDOWN, SDLK_p, KMOD_LSHIFT),
         key(SDL_KEYUP, SDLK_p),
         key(SDL_KEYDOWN, SDLK_SPACE),
         key(SDL_KEYDOWN, SDLK_LEFT, KMOD_RCTRL)}
    );
    ASSERT_EQ(events.size(), 4U);
    EXPECT_EQ(events[0].text, "P");
    EXPECT_TRUE(events[0].shift);
    EXPECT_EQ(events[1].kind, Kind::KeyUp);
    EXPECT_EQ(events[2].text, "Space");
    EXPECT_EQ(events[3].text, "Left");
    EXPECT_TRUE(events[3].control);
}

TEST_F(WindowTest, every_key_of_the_table_is_a_key_that_sdl_knows) {
    for (const KeyBinding& binding : key_bindings()) {
        const std::string name(binding.key);
        const SDL_Keycode code = SDL_GetKeyFromName(name.c_str());
        EXPECT_NE(code, SDLK_UNKNOWN) << name;
        EXPECT_EQ(SDL_GetKeyName(code), name);
    }
}

TEST_F(WindowTest, alt_is_left_to_the_desktop) {
    EXPECT_TRUE(told({key(SDL_KEYDOWN, SDLK_TAB, KMOD_LALT)}).empty());
}

TEST_F(WindowTest, mouse_wheel_and_fingers_come_in_pixels_of_the_window) {
    SDL_Event press{};
    press.type = SDL_MOUSEBUTTONDOWN;
    press.button = {};
    press.button.type = SDL_MOUSEBUTTONDOWN;
    press.button.button = SDL_BUTTON_MIDDLE;
    press.button.clicks = 2;
    press.button.x = 300;
    press.button.y = 200;
    SDL_Event wheel{};
    wheel.type = SDL_MOUSEWHEEL;
    wheel.wheel.preciseY = 0.5F;
    wheel.wheel.mouseX = 40;
    wheel.wheel.mouseY = 50;
    SDL_Event finger{};
    finger.type = SDL_FINGERDOWN;
    finger.tfinger.fingerId = 7;
    finger.tfinger.x = 0.5F;
    finger.tfinger.y = 0.25F;
    const auto events = told({press, wheel, finger});
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(events[0].kind, Kind::Pressed);
    EXPECT_EQ(events[0].button, 2);
    EXPECT_EQ(events[0].clicks, 2);
    EXPECT_EQ(events[0].at, glm::vec2(300, 200));
    EXPECT_EQ(events[1].kind, Kind::Wheel);
    EXPECT_EQ(events[1].wheel.y, 0.5F);
    EXPECT_EQ(events[1].at, glm::vec2(40, 50));
    EXPECT_EQ(events[2].kind, Kind::FingerDown);
    EXPECT_EQ(events[2].finger, 7);
    EXPECT_EQ(events[2].at, glm::vec2(450, 150));
}

TEST_F(WindowTest, a_dropped_file_is_a_path) {
    SDL_Event drop{};
    drop.type = SDL_DROPFILE;
    const char* path = "/tmp/a boiler.glb";
    drop.drop.file = static_cast<char*>(SDL_malloc(std::strlen(path) + 1));
    std::strcpy(drop.drop.file, path);
    const auto events = told({drop});
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, Kind::Dropped);
    EXPECT_EQ(events[0].text, path);
}

TEST_F(WindowTest, closing_is_a_wish_and_not_an_end) {
    SDL_Event quit{};
    quit.type = SDL_QUIT;
    const auto events = told({quit});
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, Kind::CloseWanted);
    window->make_current();
    window->swap();
}

TEST_F(WindowTest, text_comes_only_while_a_field_is_typed_into) {
    EXPECT_FALSE(SDL_IsTextInputActive());
    window->set_typing(true);
    EXPECT_TRUE(SDL_IsTextInputActive());
    SDL_Event text{};
    text.type = SDL_TEXTINPUT;
    std::strcpy(text.text.text, "µ");
    const auto events = told({text});
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, Kind::Text);
    EXPECT_EQ(events[0].text, "µ");
    window->set_typing(false);
    EXPECT_FALSE(SDL_IsTextInputActive());
}

TEST_F(WindowTest, another_size_is_seen_at_once) {
    SDL_SetWindowSize(SDL_GL_GetCurrentWindow(), 700, 500);
    for (int i = 0; i < 100 && window->pixels() != glm::ivec2(700, 500); ++i) {
        window->poll();
        SDL_Delay(10);
    }
    EXPECT_EQ(window->pixels(), glm::ivec2(700, 500));
}

/// A gamepad that SDL makes up; what it is told to shake is kept.
struct MadeUpPad {
    static inline std::vector<std::pair<Uint16, Uint16>> shaken;
    int index = -1;
    SDL_Joystick* stick = nullptr;
    MadeUpPad() {
        SDL_VirtualJoystickDesc description{};
        description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
        description.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
        description.naxes = SDL_CONTROLLER_AXIS_MAX;
        description.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
        description.name = "made up";
        description.Rumble = [](void*, Uint16 low, Uint16 high) {
            shaken.emplace_back(low, high);
            return 0;
        };
        index = SDL_JoystickAttachVirtualEx(&description);
        if (index >= 0) stick = SDL_JoystickOpen(index);
    }
    ~MadeUpPad() {
        if (stick) SDL_JoystickClose(stick);
        if (index >= 0) SDL_JoystickDetachVirtual(index);
    }
};

TEST_F(WindowTest, a_gamepad_comes_shakes_presses_and_goes) {
    MadeUpPad::shaken.clear();
    {
        MadeUpPad pad;
        if (!pad.stick) GTEST_SKIP() << "this SDL makes up no gamepads: " << SDL_GetError();
        window->poll();
        PadHaptics haptics(*window);
        EXPECT_TRUE(haptics.pulse(0.5, 35));
        haptics.stop();
        ASSERT_EQ(MadeUpPad::shaken.size(), 2U);
        EXPECT_EQ(MadeUpPad::shaken[0], (std::pair<Uint16, Uint16>(16384, 32768)));
        EXPECT_EQ(MadeUpPad::shaken[1], (std::pair<Uint16, Uint16>(0, 0)));
        SDL_JoystickSetVirtualButton(pad.stick, SDL_CONTROLLER_BUTTON_DPAD_RIGHT, 1);
        SDL_JoystickUpdate();
        bool pressed = false;
        for (const DeskEvent& event : window->poll())
            pressed = pressed || (event.kind == Kind::PadPressed && event.text == "dpright");
        EXPECT_TRUE(pressed || !window->is_focused()) << "a window without focus hears no gamepad";
    }
    window->poll();
    EXPECT_FALSE(window->rumble(1, 1, 10)) << "it is gone";
}

TEST(NoScreen, is_said_in_words_that_help) {
    if (!test::virtual_screen().empty()) GTEST_SKIP() << test::virtual_screen();
    const std::string driver = std::getenv("SDL_VIDEODRIVER");
    const std::string display = std::getenv("DISPLAY");
    setenv("DISPLAY", ":4093", 1);
    try {
        const Window window({});
        ADD_FAILURE() << "a window without a screen";
    } catch (const NoWindow& trouble) {
        EXPECT_THAT(trouble.what(), ::testing::HasSubstr("no screen"));
        EXPECT_THAT(trouble.what(), ::testing::HasSubstr("--screenshot"));
    }
    setenv("DISPLAY", display.c_str(), 1);
    EXPECT_NO_THROW(Window({.hidden = true})) << "and it can be tried again";
}

TEST(NoOpenGl, is_said_in_words_that_help) {
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    try {
        const Window window({});
        ADD_FAILURE() << "OpenGL on a screen that is none";
    } catch (const NoWindow& trouble) {
        EXPECT_THAT(trouble.what(), ::testing::HasSubstr("OpenGL 4.5"));
        EXPECT_THAT(trouble.what(), ::testing::HasSubstr("LIBGL_ALWAYS_SOFTWARE"));
    }
    setenv("SDL_VIDEODRIVER", "x11", 1);
}

}  // namespace
}  // namespace feelem::viewer
