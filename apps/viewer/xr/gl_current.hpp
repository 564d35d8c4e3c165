// SPDX-License-Identifier: Apache-2.0
// The program's own OpenGL context: what a session is bound to, and what has to be current again after calls
// that change it. The only files of the folder that know EGL and X11.
#pragma once

#include <memory>
#include <string>

namespace feelem::viewer::xr {

class GlCurrent {
public:
    /// Of the calling thread. `is_there()` is false when no context is current.
    static GlCurrent now();

    bool is_there() const noexcept { return kept_ != nullptr; }
    /// XR_MNDX_egl_enable where the context is EGL's; GLX needs none besides XR_KHR_opengl_enable.
    bool is_egl() const noexcept;
    /// To be chained to XrSessionCreateInfo; valid as long as this.
    const void* binding() const noexcept;
    /// Makes it current where it is not. True: it was not.
    bool restore() const;

private:
    struct Kept;
    std::shared_ptr<const Kept> kept_;  ///< Shared, so that a value of this type can be copied.
};

/// Takes all errors that OpenGL holds; how many there were.
int drain_gl_errors();

}  // namespace feelem::viewer::xr
