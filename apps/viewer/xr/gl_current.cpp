// SPDX-License-Identifier: Apache-2.0
// The context by EGL or by GLX, whichever the window's maker has chosen.
#include "viewer/xr/gl_current.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <epoxy/glx.h>

#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_EGL
#define XR_USE_PLATFORM_XLIB
#include <openxr/openxr_platform.h>

#include <optional>

namespace feelem::viewer::xr {

struct GlCurrent::Kept {
    std::optional<XrGraphicsBindingEGLMNDX> egl;
    EGLSurface draw = nullptr, read = nullptr;
    std::optional<XrGraphicsBindingOpenGLXlibKHR> glx;
};

namespace {

EGLConfig config_of(EGLDisplay display, EGLContext context) {
    EGLint id = 0;
    EGLConfig config = nullptr;
    EGLint count = 0;
    // A context may have been made without any; then there is none to find.
    if (!eglQueryContext(display, context, EGL_CONFIG_ID, &id) || id == 0) return nullptr;
    const EGLint wanted[] = {EGL_CONFIG_ID, id, EGL_NONE};
    return eglChooseConfig(display, wanted, &config, 1, &count) && count == 1 ? config : nullptr;
}

XrGraphicsBindingEGLMNDX bind_egl(EGLDisplay display, EGLContext context) {
    XrGraphicsBindingEGLMNDX binding{};
    binding.type = XR_TYPE_GRAPHICS_BINDING_EGL_MNDX;
    // epoxy's own name is a pointer that may not have been looked up yet.
    binding.getProcAddress = [](const char* name) { return eglGetProcAddress(name); };
    binding.display = display;
    binding.config = config_of(display, context);
    binding.context = context;
    return binding;
}

std::optional<XrGraphicsBindingOpenGLXlibKHR> bind_glx(Display* display, GLXContext context) {
    int id = 0;
    if (glXQueryContext(display, context, GLX_FBCONFIG_ID, &id) != 0) return {};
    const int wanted[] = {GLX_FBCONFIG_ID, id, 0};
    int count = 0;
    GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
    if (!configs) return {};
    XrGraphicsBindingOpenGLXlibKHR binding{};
    binding.type = XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR;
    binding.xDisplay = display;
    binding.glxFBConfig = configs[0];
    binding.glxDrawable = glXGetCurrentDrawable();
    binding.glxContext = context;
    if (XVisualInfo* visual = glXGetVisualFromFBConfig(display, configs[0])) {
        binding.visualid = static_cast<std::uint32_t>(visual->visualid);
        XFree(visual);
    }
    XFree(configs);
    return binding;
}

}  // namespace

GlCurrent GlCurrent::now() {
    auto kept = std::make_shared<Kept>();
    if (const EGLContext context = eglGetCurrentContext(); context != EGL_NO_CONTEXT) {
        kept->egl = bind_egl(eglGetCurrentDisplay(), context);
        kept->draw = eglGetCurrentSurface(EGL_DRAW);
        kept->read = eglGetCurrentSurface(EGL_READ);
    } else if (const GLXContext other = glXGetCurrentContext()) {
        kept->glx = bind_glx(glXGetCurrentDisplay(), other);
    }
    GlCurrent current;
    if (kept->egl || kept->glx) current.kept_ = std::move(kept);
    return current;
}

bool GlCurrent::is_egl() const noexcept {
    return kept_ && kept_->egl.has_value();
}

const void* GlCurrent::binding() const noexcept {
    if (!kept_) return nullptr;
    return kept_->egl ? static_cast<const void*>(&*kept_->egl) : static_cast<const void*>(&*kept_->glx);
}

bool GlCurrent::restore() const {
    if (!kept_) return false;
    if (kept_->egl) {
        const auto& egl = *kept_->egl;
        if (eglGetCurrentContext() == egl.context && eglGetCurrentSurface(EGL_DRAW) == kept_->draw)
            return false;
        eglMakeCurrent(egl.display, kept_->draw, kept_->read, egl.context);
        return true;
    }
    const auto& glx = *kept_->glx;
    if (glXGetCurrentContext() == glx.glxContext && glXGetCurrentDrawable() == glx.glxDrawable) return false;
    glXMakeCurrent(glx.xDisplay, glx.glxDrawable, glx.glxContext);
    return true;
}

int drain_gl_errors() {
    int count = 0;
    // A lost context answers with errors for ever.
    constexpr int most = 32;
    while (count < most && glGetError() != GL_NO_ERROR) ++count;
    return count;
}

}  // namespace feelem::viewer::xr
