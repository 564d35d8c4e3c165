// SPDX-License-Identifier: Apache-2.0
// The picture of a window before it is shown: the model and the panels are put together here, with a window
// or without.
#pragma once

#include "viewer/render/renderer.hpp"

#include <glm/vec2.hpp>

namespace feelem::viewer {

/// RGBA8, sRGB bytes. All calls with the same OpenGL context current.
class ComposedPicture {
public:
    ComposedPicture() = default;
    ~ComposedPicture();
    ComposedPicture(const ComposedPicture&) = delete;
    ComposedPicture& operator=(const ComposedPicture&) = delete;

    /// Of this size from now on, filled with one colour, and bound.
    void begin(glm::ivec2 pixels, const Rgb& colour);
    unsigned framebuffer() const noexcept { return framebuffer_; }
    glm::ivec2 pixels() const noexcept { return pixels_; }
    void bind() const;
    /// Into the window's framebuffer, of the same size.
    void show() const;
    Pixels read() const;

private:
    unsigned framebuffer_ = 0, texture_ = 0;
    glm::ivec2 pixels_{0};
};

}  // namespace feelem::viewer
