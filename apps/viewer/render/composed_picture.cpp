// SPDX-License-Identifier: Apache-2.0
#include "viewer/render/composed_picture.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace feelem::viewer {

ComposedPicture::~ComposedPicture() {
    if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
    if (texture_ != 0) glDeleteTextures(1, &texture_);
}

void ComposedPicture::begin(glm::ivec2 pixels, const Rgb& colour) {
    pixels = {std::max(pixels.x, 1), std::max(pixels.y, 1)};
    if (pixels != pixels_) {
        if (framebuffer_ == 0) glCreateFramebuffers(1, &framebuffer_);
        if (texture_ != 0) glDeleteTextures(1, &texture_);
        glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
        glTextureStorage2D(texture_, 1, GL_RGBA8, pixels.x, pixels.y);
        glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
        pixels_ = pixels;
    }
    constexpr float kWhole = 255.0F;
    const std::array<float, 4> fill{
        static_cast<float>(colour[0]) / kWhole,
        static_cast<float>(colour[1]) / kWhole,
        static_cast<float>(colour[2]) / kWhole,
        1};
    glClearNamedFramebufferfv(framebuffer_, GL_COLOR, 0, fill.data());
    bind();
}

void ComposedPicture::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, pixels_.x, pixels_.y);
}

void ComposedPicture::show() const {
    glBlitNamedFramebuffer(
        framebuffer_,
        0,
        0,
        0,
        pixels_.x,
        pixels_.y,
        0,
        0,
        pixels_.x,
        pixels_.y,
        GL_COLOR_BUFFER_BIT,
        GL_NEAREST
    );
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Pixels ComposedPicture::read() const {
    const auto row = static_cast<std::size_t>(pixels_.x) * 3, rows = static_cast<std::size_t>(pixels_.y);
    Pixels out{pixels_.x, pixels_.y, std::vector<std::uint8_t>(row * rows)};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, pixels_.x, pixels_.y, GL_RGB, GL_UNSIGNED_BYTE, out.rgb.data());
    // OpenGL's first row is the lowest.
    for (std::size_t y = 0; y < rows / 2; ++y) {
        const auto upper = out.rgb.begin() + static_cast<std::ptrdiff_t>(y * row);
        const auto lower = out.rgb.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * row);
        std::swap_ranges(upper, upper + static_cast<std::ptrdiff_t>(row), lower);
    }
    return out;
}

}  // namespace feelem::viewer
