// SPDX-License-Identifier: Apache-2.0
// One swapchain and framebuffers for its images.
#pragma once

#include "viewer/xr/calls.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace feelem::viewer::xr {

struct PictureFormats {
    /// GL_SRGB8_ALPHA8, because what we write are sRGB bytes: a compositor takes GL_RGBA8 for linear and
    /// would show every colour too light. Our blits convert nothing, so the bytes arrive as they are.
    std::int64_t colour = 0;
    std::int64_t depth = 0;  ///< GL_DEPTH_COMPONENT32F; 0: not offered.
};
/// Throws Failure(XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED).
PictureFormats choose_formats(XrSession session);

struct PictureInfo {
    std::int64_t format = 0;
    bool is_depth = false;
    int width = 0, height = 0;
};

/// A 2-D image of one eye or panel: array images are refused by some runtimes.
class Picture {
public:
    Picture(XrSession session, const PictureInfo& info);
    ~Picture();
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    /// To be drawn into. Not done when it is made: the runtime may have taken our OpenGL context away
    /// meanwhile.
    void make_framebuffers();
    /// Waits until the compositor lets go of an image, at most a second. Throws Failure.
    void acquire();
    void release();
    bool is_acquired() const { return at_.has_value(); }

    /// Of the image that is acquired.
    unsigned framebuffer() const { return at_ ? framebuffers_[*at_] : 0; }
    unsigned texture() const { return at_ ? textures_[*at_] : 0; }
    int width() const { return info_.width; }
    int height() const { return info_.height; }
    XrSwapchainSubImage whole() const;

private:
    PictureInfo info_;
    XrSwapchain swapchain_ = XR_NULL_HANDLE;
    std::vector<unsigned> textures_, framebuffers_;
    std::optional<std::uint32_t> at_;
};

/// The texture's bytes into the acquired image, as they are.
void copy_bytes(unsigned texture, int width, int height, const Picture& picture);

}  // namespace feelem::viewer::xr
