// SPDX-License-Identifier: Apache-2.0
// Swapchains as OpenGL sees them.
#include "viewer/xr/picture.hpp"

#include <epoxy/gl.h>

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <algorithm>

namespace feelem::viewer::xr {

namespace {

constexpr XrDuration kLongestWait = 1'000'000'000;

XrSwapchain make_swapchain(XrSession session, const PictureInfo& info) {
    auto create = typed<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
    create.usageFlags = info.is_depth
                            ? XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                            : XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_TRANSFER_DST_BIT |
                                  XR_SWAPCHAIN_USAGE_SAMPLED_BIT;
    create.format = info.format;
    create.sampleCount = create.faceCount = create.arraySize = create.mipCount = 1;
    create.width = static_cast<std::uint32_t>(info.width);
    create.height = static_cast<std::uint32_t>(info.height);
    XrSwapchain swapchain = XR_NULL_HANDLE;
    must(xrCreateSwapchain(session, &create, &swapchain), "xrCreateSwapchain");
    return swapchain;
}

}  // namespace

PictureFormats choose_formats(XrSession session) {
    const auto offered =
        all_of<std::int64_t>("xrEnumerateSwapchainFormats", 0, [&](auto capacity, auto* count, auto* out) {
            return xrEnumerateSwapchainFormats(session, capacity, count, out);
        });
    const auto has = [&](std::int64_t format) {
        return std::find(offered.begin(), offered.end(), format) != offered.end();
    };
    if (!has(GL_SRGB8_ALPHA8))
        throw Failure{XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, "xrEnumerateSwapchainFormats"};
    return {GL_SRGB8_ALPHA8, has(GL_DEPTH_COMPONENT32F) ? GL_DEPTH_COMPONENT32F : 0};
}

Picture::Picture(XrSession session, const PictureInfo& info)
    : info_(info), swapchain_(make_swapchain(session, info)) {
    const auto images = all_of<XrSwapchainImageOpenGLKHR>(
        "xrEnumerateSwapchainImages",
        typed<XrSwapchainImageOpenGLKHR>(XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR),
        [&](auto capacity, auto* count, auto* out) {
            return xrEnumerateSwapchainImages(
                swapchain_, capacity, count, reinterpret_cast<XrSwapchainImageBaseHeader*>(out)
            );
        }
    );
    for (const auto& image : images) textures_.push_back(image.image);
}

void Picture::make_framebuffers() {
    framebuffers_.resize(textures_.size());
    glCreateFramebuffers(static_cast<GLsizei>(framebuffers_.size()), framebuffers_.data());
    for (std::size_t i = 0; i < textures_.size(); ++i)
        glNamedFramebufferTexture(framebuffers_[i], GL_COLOR_ATTACHMENT0, textures_[i], 0);
}

Picture::~Picture() {
    glDeleteFramebuffers(static_cast<GLsizei>(framebuffers_.size()), framebuffers_.data());
    xrDestroySwapchain(swapchain_);
}

void Picture::acquire() {
    std::uint32_t index = 0;
    must(xrAcquireSwapchainImage(swapchain_, nullptr, &index), "xrAcquireSwapchainImage");
    auto info = typed<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
    info.timeout = kLongestWait;
    const XrResult result = must(xrWaitSwapchainImage(swapchain_, &info), "xrWaitSwapchainImage");
    if (result == XR_TIMEOUT_EXPIRED || index >= textures_.size())
        throw Failure{XR_ERROR_RUNTIME_FAILURE, "xrWaitSwapchainImage"};
    at_ = index;
}

void Picture::release() {
    at_.reset();
    must(xrReleaseSwapchainImage(swapchain_, nullptr), "xrReleaseSwapchainImage");
}

XrSwapchainSubImage Picture::whole() const {
    return {swapchain_, {{0, 0}, {info_.width, info_.height}}, 0};
}

void copy_bytes(unsigned texture, int width, int height, const Picture& picture) {
    unsigned from = 0;
    glCreateFramebuffers(1, &from);
    glNamedFramebufferTexture(from, GL_COLOR_ATTACHMENT0, texture, 0);
    // Both ways a blit could convert are off without it.
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_SCISSOR_TEST);
    glBlitNamedFramebuffer(
        from,
        picture.framebuffer(),
        0,
        0,
        width,
        height,
        0,
        0,
        picture.width(),
        picture.height(),
        GL_COLOR_BUFFER_BIT,
        GL_NEAREST
    );
    glDeleteFramebuffers(1, &from);
}

}  // namespace feelem::viewer::xr
