// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/gl_context.hpp"

#include "feelem/error.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace feelem::viewer {
namespace {

constexpr const char* kHint = "on Debian, libegl1 and libgl1-mesa-dri draw without a graphics card";

[[noreturn]] void no_context(std::string_view step) {
    throw Error(
        Code::UnsupportedFormat,
        "OpenGL",
        fmt::format("{} failed (EGL error {:#06x}); {}", step, eglGetError(), kHint)
    );
}

}  // namespace

struct GlContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~State() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        eglTerminate(display);
    }
};

GlContext::GlContext() : state_(std::make_unique<State>()) {
    if (!epoxy_has_egl() || !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        no_context("looking for a platform without a screen");
    state_->display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (state_->display == EGL_NO_DISPLAY) no_context("opening a display without a screen");
    if (!eglInitialize(state_->display, nullptr, nullptr)) no_context("starting EGL");
    if (!eglBindAPI(EGL_OPENGL_API)) no_context("asking for OpenGL");
    constexpr EGLint kAttributes[]{
        EGL_CONTEXT_MAJOR_VERSION,
        4,
        EGL_CONTEXT_MINOR_VERSION,
        5,
        EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
        EGL_NONE};
    state_->context = eglCreateContext(state_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
    if (state_->context == EGL_NO_CONTEXT) no_context("asking for OpenGL 4.5");
    make_current();
}

GlContext::~GlContext() = default;

void GlContext::make_current() const {
    if (!eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context))
        no_context("making OpenGL current");
}

std::string GlContext::renderer() const {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name ? reinterpret_cast<const char*>(name) : "";
}

}  // namespace feelem::viewer
