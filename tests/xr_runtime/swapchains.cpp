// SPDX-License-Identifier: Apache-2.0
// Swapchains: textures in the program's own context, handed out in turn.
#include "runtime.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_EGL
#include <openxr/openxr_platform.h>

#include <algorithm>

namespace feelem::xr_runtime {

namespace {

constexpr const char* kCreate = "xrCreateSwapchain";
constexpr std::uint32_t kImages = 3;

std::vector<std::int64_t> formats() {
    std::vector<std::int64_t> all{GL_RGBA16F, GL_RGBA8, GL_DEPTH_COMPONENT32F, GL_DEPTH24_STENCIL8};
    if (!has_fault("no_srgb")) all.insert(all.begin() + 1, GL_SRGB8_ALPHA8);
    return all;
}

XrResult enumerate_formats(
    XrSession handle, std::uint32_t capacity, std::uint32_t* count, std::int64_t* out
) {
    const XrResult result = check(runtime().sessions.find(number_of(handle)), "xrEnumerateSwapchainFormats");
    return result == XR_SUCCESS ? give<std::int64_t>(formats(), capacity, count, out) : result;
}

XrResult fault_of(const XrSwapchainCreateInfo& info) {
    const auto known = formats();
    if (std::find(known.begin(), known.end(), info.format) == known.end())
        return broken(XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, kCreate, "no such format");
    if (info.arraySize != 1 && has_fault("no_array")) return XR_ERROR_FEATURE_UNSUPPORTED;
    const bool is_plain = info.faceCount == 1 && info.mipCount == 1 && info.sampleCount == 1 &&
                          info.arraySize == 1 && info.width > 0 && info.height > 0;
    return is_plain ? XR_SUCCESS : broken(XR_ERROR_VALIDATION_FAILURE, kCreate, "not a plain 2-D image");
}

XrResult create_swapchain(XrSession handle, const XrSwapchainCreateInfo* info, XrSwapchain* out) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, kCreate); result != XR_SUCCESS) return result;
    if (session->is_headless) return broken(XR_ERROR_GRAPHICS_DEVICE_INVALID, kCreate, "headless");
    if (const XrResult result = fault_of(*info); result != XR_SUCCESS) {
        play_gl_faults(*session);
        return result;
    }
    Swapchain swapchain;
    swapchain.session = number_of(handle);
    swapchain.width = static_cast<std::int32_t>(info->width);
    swapchain.height = static_cast<std::int32_t>(info->height);
    swapchain.format = info->format;
    swapchain.textures.resize(kImages);
    glCreateTextures(GL_TEXTURE_2D, kImages, swapchain.textures.data());
    for (const std::uint32_t texture : swapchain.textures)
        glTextureStorage2D(texture, 1, static_cast<GLenum>(info->format), swapchain.width, swapchain.height);
    *out = handle_of<XrSwapchain>(runtime().swapchains.add(std::move(swapchain)));
    play_gl_faults(*session);
    return XR_SUCCESS;
}

XrResult destroy_swapchain(XrSwapchain handle) {
    const Swapchain* swapchain = runtime().swapchains.find(number_of(handle));
    if (!swapchain) return broken(XR_ERROR_HANDLE_INVALID, "xrDestroySwapchain", "no such swapchain");
    glDeleteTextures(kImages, swapchain->textures.data());
    runtime().swapchains.erase(number_of(handle));
    return XR_SUCCESS;
}

XrResult enumerate_images(
    XrSwapchain handle, std::uint32_t capacity, std::uint32_t* count, XrSwapchainImageBaseHeader* out
) {
    const Swapchain* swapchain = runtime().swapchains.find(number_of(handle));
    if (!swapchain) return broken(XR_ERROR_HANDLE_INVALID, "xrEnumerateSwapchainImages", "no such swapchain");
    *count = kImages;
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < kImages) return XR_ERROR_SIZE_INSUFFICIENT;
    auto* images = reinterpret_cast<XrSwapchainImageOpenGLKHR*>(out);
    for (std::size_t i = 0; i < kImages; ++i) {
        if (images[i].type != XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR)
            return broken(XR_ERROR_VALIDATION_FAILURE, "xrEnumerateSwapchainImages", "not images of OpenGL");
        images[i].image = swapchain->textures[i];
    }
    return XR_SUCCESS;
}

/// The swapchain, when its session lives.
XrResult find(XrSwapchain handle, const char* call, Swapchain** out) {
    *out = runtime().swapchains.find(number_of(handle));
    const Instance* instance = only_instance();
    if (instance && instance->is_lost) return XR_ERROR_INSTANCE_LOST;
    if (!*out) return broken(XR_ERROR_HANDLE_INVALID, call, "no such swapchain");
    return check(runtime().sessions.find((*out)->session), call);
}

XrResult acquire(XrSwapchain handle, const XrSwapchainImageAcquireInfo*, std::uint32_t* index) {
    Swapchain* swapchain = nullptr;
    const char* call = "xrAcquireSwapchainImage";
    if (const XrResult result = find(handle, call, &swapchain); result != XR_SUCCESS) return result;
    if (swapchain->is_acquired)
        return broken(XR_ERROR_CALL_ORDER_INVALID, call, "the last one is still held");
    *index = swapchain->next;
    swapchain->next = (swapchain->next + 1) % kImages;
    swapchain->is_acquired = true;
    swapchain->is_waited = false;
    return XR_SUCCESS;
}

XrResult wait_image(XrSwapchain handle, const XrSwapchainImageWaitInfo*) {
    Swapchain* swapchain = nullptr;
    const char* call = "xrWaitSwapchainImage";
    if (const XrResult result = find(handle, call, &swapchain); result != XR_SUCCESS) return result;
    if (!swapchain->is_acquired || swapchain->is_waited)
        return broken(XR_ERROR_CALL_ORDER_INVALID, call, "nothing to wait for");
    swapchain->is_waited = true;
    return XR_SUCCESS;
}

XrResult release(XrSwapchain handle, const XrSwapchainImageReleaseInfo*) {
    Swapchain* swapchain = nullptr;
    const char* call = "xrReleaseSwapchainImage";
    if (const XrResult result = find(handle, call, &swapchain); result != XR_SUCCESS) return result;
    if (!swapchain->is_acquired || !swapchain->is_waited)
        return broken(XR_ERROR_CALL_ORDER_INVALID, call, "not acquired and waited for");
    swapchain->is_acquired = false;
    swapchain->has_released = true;
    swapchain->released = (swapchain->next + kImages - 1) % kImages;
    return XR_SUCCESS;
}

}  // namespace

std::span<const Entry> swapchain_calls() {
    static const std::array kCalls{
        entry<PFN_xrEnumerateSwapchainFormats>("xrEnumerateSwapchainFormats", enumerate_formats),
        entry<PFN_xrCreateSwapchain>(kCreate, create_swapchain),
        entry<PFN_xrDestroySwapchain>("xrDestroySwapchain", destroy_swapchain),
        entry<PFN_xrEnumerateSwapchainImages>("xrEnumerateSwapchainImages", enumerate_images),
        entry<PFN_xrAcquireSwapchainImage>("xrAcquireSwapchainImage", acquire),
        entry<PFN_xrWaitSwapchainImage>("xrWaitSwapchainImage", wait_image),
        entry<PFN_xrReleaseSwapchainImage>("xrReleaseSwapchainImage", release),
    };
    return kCalls;
}

}  // namespace feelem::xr_runtime
