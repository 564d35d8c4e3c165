// SPDX-License-Identifier: Apache-2.0
// OpenGL 4.5 without a window, for the probe.
#include "probe_session.hpp"

namespace feelem::probe {
namespace {
constexpr std::array<GLubyte, 4> kKeepsake{11, 22, 33, 44};
}  // namespace

bool open(Graphics& gl) {
    gl.display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (eglInitialize(gl.display, nullptr, nullptr) == EGL_FALSE || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE)
        return false;
    const std::array<EGLint, 5> wanted{
        EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLint count = 0;
    if (eglChooseConfig(gl.display, wanted.data(), &gl.config, 1, &count) == EGL_FALSE || count == 0)
        return false;
    const std::array<EGLint, 7> attributes{
        EGL_CONTEXT_MAJOR_VERSION,
        4,
        EGL_CONTEXT_MINOR_VERSION,
        5,
        EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
        EGL_NONE};
    gl.context = eglCreateContext(gl.display, gl.config, EGL_NO_CONTEXT, attributes.data());
    if (eglMakeCurrent(gl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, gl.context) == EGL_FALSE) return false;
    glGenFramebuffers(1, &gl.target);
    glGenTextures(1, &gl.keepsake);
    glBindTexture(GL_TEXTURE_2D, gl.keepsake);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kKeepsake.data());
    say(R"({{"event":"graphics","renderer":"{}"}})", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    return true;
}

bool keepsake_is_kept(const Graphics& gl) {
    std::array<GLubyte, 4> now{};
    eglMakeCurrent(gl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, gl.context);
    glBindTexture(GL_TEXTURE_2D, gl.keepsake);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, now.data());
    return now == kKeepsake;
}

}  // namespace feelem::probe
