// SPDX-License-Identifier: Apache-2.0
// What some runtimes do to a program's OpenGL, on demand.
#include "runtime.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <epoxy/glx.h>

namespace feelem::xr_runtime {

void play_gl_faults(const Session& session) {
    if (session.is_headless) return;
    if (has_fault("leaves_gl_error")) glEnable(0xFFFFU);
    if (!has_fault("loses_context")) return;
    if (session.graphics.is_egl)
        eglMakeCurrent(session.graphics.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    else
        glXMakeCurrent(static_cast<Display*>(session.graphics.display), 0, nullptr);
}

}  // namespace feelem::xr_runtime
