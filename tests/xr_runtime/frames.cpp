// SPDX-License-Identifier: Apache-2.0
// Waiting for, beginning and ending frames; what is wrong with the layers of one.
#include "runtime.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace feelem::xr_runtime {

namespace {

constexpr const char* kEnd = "xrEndFrame";

XrTime shown_at(std::uint64_t frame) {
    return static_cast<XrTime>(frame + 2) * kPeriod;
}

XrResult wait_frame(XrSession handle, const XrFrameWaitInfo*, XrFrameState* out) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, "xrWaitFrame"); result != XR_SUCCESS) return result;
    if (!session->is_running)
        return broken(XR_ERROR_SESSION_NOT_RUNNING, "xrWaitFrame", "the session does not run");
    if (session->has_waited)
        return broken(
            XR_ERROR_CALL_ORDER_INVALID,
            "xrWaitFrame",
            "the last frame was not begun: this would wait for ever"
        );
    play(*session);
    if (const XrResult result = check(session, "xrWaitFrame"); result != XR_SUCCESS) return result;
    session->has_waited = true;
    const bool is_seen =
        session->state == XR_SESSION_STATE_VISIBLE || session->state == XR_SESSION_STATE_FOCUSED;
    out->predictedDisplayTime = shown_at(runtime().frame);
    out->predictedDisplayPeriod = kPeriod;
    out->shouldRender = is_seen && runtime().world.renders ? XR_TRUE : XR_FALSE;
    return XR_SUCCESS;
}

XrResult begin_frame(XrSession handle, const XrFrameBeginInfo*) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, "xrBeginFrame"); result != XR_SUCCESS) return result;
    if (!session->has_waited)
        return broken(XR_ERROR_CALL_ORDER_INVALID, "xrBeginFrame", "without xrWaitFrame");
    session->has_waited = false;
    const bool discards = session->has_begun;
    session->has_begun = true;
    if (discards) record(R"("violation":"xrBeginFrame","code":9,"why":"the frame before was not ended")");
    return discards ? XR_FRAME_DISCARDED : XR_SUCCESS;
}

/// Red, green, blue and alpha as they stand in the image: bytes for a picture of bytes.
std::array<int, 4> middle_of(const Swapchain& swapchain) {
    std::array<std::uint8_t, 4> bytes{};
    glGetTextureSubImage(
        swapchain.textures[swapchain.released],
        0,
        swapchain.width / 2,
        swapchain.height / 2,
        0,
        1,
        1,
        1,
        GL_RGBA,
        GL_UNSIGNED_BYTE,
        static_cast<GLsizei>(bytes.size()),
        bytes.data()
    );
    return {bytes[0], bytes[1], bytes[2], bytes[3]};
}

/// Why the compositor could not take it; empty: it can.
std::string fault_of(const XrSwapchainSubImage& image) {
    const Swapchain* swapchain = runtime().swapchains.find(number_of(image.swapchain));
    if (!swapchain) return "no such swapchain";
    if (!swapchain->has_released) return "no image was ever released";
    if (swapchain->is_acquired) return "its image was not released";
    const XrRect2Di& rect = image.imageRect;
    const bool is_inside = rect.offset.x >= 0 && rect.offset.y >= 0 && rect.extent.width > 0 &&
                           rect.extent.height > 0 && rect.offset.x + rect.extent.width <= swapchain->width &&
                           rect.offset.y + rect.extent.height <= swapchain->height;
    return is_inside ? "" : "the rectangle is not within the image";
}

std::string fault_of(const XrCompositionLayerDepthInfoKHR& depth) {
    if (!only_instance()->extensions.count(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME))
        return "depth without its extension";
    if (!(depth.nearZ > 0) || !(depth.farZ > 0) || depth.nearZ == depth.farZ) return "near and far";
    return fault_of(depth.subImage);
}

std::string view_text(const XrCompositionLayerProjectionView& view, std::string& fault) {
    fault = fault_of(view.subImage);
    if (fault.empty() && !is_pose(view.pose)) fault = "the pose is none";
    if (fault.empty() && view.fov.angleRight <= view.fov.angleLeft) fault = "the field of view is empty";
    bool has_depth = false;
    for (auto* next = static_cast<const XrBaseInStructure*>(view.next); fault.empty() && next;
         next = next->next)
        if (next->type == XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR) {
            has_depth = true;
            fault = fault_of(*reinterpret_cast<const XrCompositionLayerDepthInfoKHR*>(next));
        }
    if (!fault.empty()) return {};
    const Swapchain& swapchain = *runtime().swapchains.find(number_of(view.subImage.swapchain));
    return fmt::format(
        R"({{"x":{:.4f},"depth":{},"format":{},"middle":[{}]}})",
        view.pose.position.x,
        has_depth,
        swapchain.format,
        fmt::join(middle_of(swapchain), ",")
    );
}

std::string layer_text(const XrCompositionLayerBaseHeader& layer, std::string& fault) {
    if (!runtime().spaces.find(number_of(layer.space))) fault = "no such space";
    if (layer.type == XR_TYPE_COMPOSITION_LAYER_PROJECTION) {
        const auto& projection = reinterpret_cast<const XrCompositionLayerProjection&>(layer);
        if (projection.viewCount != 2) fault = "not two views";
        std::vector<std::string> views;
        for (std::uint32_t i = 0; fault.empty() && i < projection.viewCount; ++i)
            views.push_back(view_text(projection.views[i], fault));
        return fmt::format(R"({{"kind":"projection","views":[{}]}})", fmt::join(views, ","));
    }
    if (layer.type == XR_TYPE_COMPOSITION_LAYER_QUAD) {
        const auto& quad = reinterpret_cast<const XrCompositionLayerQuad&>(layer);
        if (fault.empty()) fault = fault_of(quad.subImage);
        if (fault.empty() && !is_pose(quad.pose)) fault = "the pose is none";
        if (fault.empty() && !(quad.size.width > 0 && quad.size.height > 0)) fault = "the quad has no size";
        if (!fault.empty()) return {};
        const Swapchain& swapchain = *runtime().swapchains.find(number_of(quad.subImage.swapchain));
        return fmt::format(R"({{"kind":"quad","middle":[{}]}})", fmt::join(middle_of(swapchain), ","));
    }
    fault = "a layer of a kind that is not offered";
    return {};
}

XrResult end_frame(XrSession handle, const XrFrameEndInfo* info) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, kEnd); result != XR_SUCCESS) return result;
    if (!session->has_begun) return broken(XR_ERROR_CALL_ORDER_INVALID, kEnd, "without xrBeginFrame");
    if (info->displayTime != shown_at(runtime().frame))
        return broken(XR_ERROR_TIME_INVALID, kEnd, "not the time that xrWaitFrame gave");
    if (info->environmentBlendMode != XR_ENVIRONMENT_BLEND_MODE_OPAQUE)
        return broken(XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED, kEnd, "not opaque");
    std::vector<std::string> layers;
    for (std::uint32_t i = 0; i < info->layerCount; ++i) {
        std::string fault;
        layers.push_back(layer_text(*info->layers[i], fault));
        if (!fault.empty()) return broken(XR_ERROR_LAYER_INVALID, kEnd, fault);
    }
    record(fmt::format(R"("layers":[{}])", fmt::join(layers, ",")));
    session->has_begun = false;
    ++runtime().frame;
    step_towards_target(*session);
    play_gl_faults(*session);
    return XR_SUCCESS;
}

}  // namespace

std::span<const Entry> frame_calls() {
    static const std::array kCalls{
        entry<PFN_xrWaitFrame>("xrWaitFrame", wait_frame),
        entry<PFN_xrBeginFrame>("xrBeginFrame", begin_frame),
        entry<PFN_xrEndFrame>(kEnd, end_frame),
    };
    return kCalls;
}

}  // namespace feelem::xr_runtime
