// SPDX-License-Identifier: Apache-2.0
// The probe's OpenXR session and its surfaceless OpenGL, as plain data; every failed call throws.
#pragma once

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#define XR_USE_PLATFORM_EGL
#define XR_USE_GRAPHICS_API_OPENGL
#include <fmt/format.h>
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

namespace feelem::probe {

struct Failed {
    std::string_view call;
    XrResult result;
};

inline void check(XrResult result, std::string_view call) {
    if (XR_FAILED(result)) throw Failed{call, result};
}

/// A line on the standard output, at once.
template <class... Values>
void say(fmt::format_string<Values...> form, Values&&... values) {
    fmt::print("{}\n", fmt::format(form, std::forward<Values>(values)...));
    std::fflush(stdout);
}

/// An OpenXR struct, all zero but for its type.
template <class Struct>
Struct made(XrStructureType type) {
    Struct empty;
    std::memset(&empty, 0, sizeof empty);
    empty.type = type;
    return empty;
}

struct Graphics {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLConfig config = nullptr;
    EGLContext context = EGL_NO_CONTEXT;
    GLuint keepsake = 0;  // A texture of our own: it must outlive the runtime.
    GLuint target = 0;
};

/// False: no OpenGL 4.5 without a window.
bool open(Graphics& gl);
bool keepsake_is_kept(const Graphics& gl);

inline constexpr std::array<const char*, 2> kHandNames{"left", "right"};

struct Eye {
    XrSwapchain chain = XR_NULL_HANDLE;
    std::vector<GLuint> images;
    std::int32_t width = 0, height = 0;
};

struct Hand {
    XrPath path = XR_NULL_PATH;
    XrSpace aim = XR_NULL_HANDLE;
};

struct Session {
    XrInstance instance = XR_NULL_HANDLE;
    XrSystemId system = XR_NULL_SYSTEM_ID;
    XrSession session = XR_NULL_HANDLE;
    XrSpace local = XR_NULL_HANDLE, view = XR_NULL_HANDLE;
    XrActionSet set = XR_NULL_HANDLE;
    XrAction aim = XR_NULL_HANDLE, trigger = XR_NULL_HANDLE, touch = XR_NULL_HANDLE;
    std::array<Hand, 2> hands;
    std::array<Eye, 2> eyes;
    bool runs = false, ended = false, focused = false;
};

void create_instance(Session& xr);
void create_session(Session& xr, const Graphics& gl);
void create_actions(Session& xr);
void create_eyes(Session& xr);

}  // namespace feelem::probe
