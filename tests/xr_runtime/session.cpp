// SPDX-License-Identifier: Apache-2.0
// The session and its life.
#include "runtime.hpp"

#include <epoxy/egl.h>
#include <epoxy/glx.h>
#include <fmt/format.h>

#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_EGL
#define XR_USE_PLATFORM_XLIB
#include <openxr/openxr_platform.h>

namespace feelem::xr_runtime {

namespace {

constexpr const char* kCreate = "xrCreateSession";

/// Empty: no binding that we know, or one that is not whole.
std::optional<ContextKept> graphics_of(const XrSessionCreateInfo& info) {
    for (auto* next = static_cast<const XrBaseInStructure*>(info.next); next; next = next->next) {
        if (next->type == XR_TYPE_GRAPHICS_BINDING_EGL_MNDX) {
            const auto* egl = reinterpret_cast<const XrGraphicsBindingEGLMNDX*>(next);
            if (!egl->getProcAddress || !egl->display || !egl->context) return {};
            return ContextKept{egl->display, egl->context, true};
        }
        if (next->type == XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR) {
            const auto* glx = reinterpret_cast<const XrGraphicsBindingOpenGLXlibKHR*>(next);
            if (!glx->xDisplay || !glx->glxContext || !glx->glxFBConfig || !glx->visualid) return {};
            return ContextKept{glx->xDisplay, glx->glxContext, false};
        }
    }
    return {};
}

XrResult create_session(XrInstance, const XrSessionCreateInfo* info, XrSession* out) {
    Instance* instance = only_instance();
    if (instance->is_lost) return XR_ERROR_INSTANCE_LOST;
    if (info->systemId != kSystem) return broken(XR_ERROR_SYSTEM_INVALID, kCreate, "no such system");
    if (!runtime().sessions.all().empty())
        return broken(XR_ERROR_LIMIT_REACHED, kCreate, "one lives already");
    Session session;
    session.is_headless = !info->next && instance->extensions.count(XR_MND_HEADLESS_EXTENSION_NAME);
    if (!session.is_headless) {
        if (!instance->knows_requirements)
            return broken(
                XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING, kCreate, "requirements were not asked for"
            );
        const auto graphics = graphics_of(*info);
        if (!graphics) return broken(XR_ERROR_GRAPHICS_DEVICE_INVALID, kCreate, "no whole graphics binding");
        session.graphics = *graphics;
    }
    const std::uint64_t number = runtime().sessions.add(session);
    *out = handle_of<XrSession>(number);
    Session& made = *runtime().sessions.find(number);
    record(fmt::format(
        R"("session":"created","graphics":"{}")",
        session.is_headless       ? "none"
        : session.graphics.is_egl ? "egl"
                                  : "glx"
    ));
    go(made, XR_SESSION_STATE_IDLE);
    go(made, XR_SESSION_STATE_READY);
    play_gl_faults(made);
    return XR_SUCCESS;
}

XrResult destroy_session(XrSession handle) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (!session) return broken(XR_ERROR_HANDLE_INVALID, "xrDestroySession", "no such session");
    forget_children(number_of(handle));
    runtime().sessions.erase(number_of(handle));
    record(R"("session":"destroyed")");
    return XR_SUCCESS;
}

XrResult begin_session(XrSession handle, const XrSessionBeginInfo* info) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, "xrBeginSession"); result != XR_SUCCESS) return result;
    if (session->is_running) return broken(XR_ERROR_SESSION_RUNNING, "xrBeginSession", "it runs already");
    if (session->state != XR_SESSION_STATE_READY)
        return broken(XR_ERROR_SESSION_NOT_READY, "xrBeginSession", word(session->state));
    if (info->primaryViewConfigurationType != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO)
        return broken(XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, "xrBeginSession", "not stereo");
    session->is_running = true;
    session->target = XR_SESSION_STATE_FOCUSED;
    session->has_waited = session->has_begun = false;
    go(*session, XR_SESSION_STATE_SYNCHRONIZED);
    return XR_SUCCESS;
}

XrResult end_session(XrSession handle) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, "xrEndSession"); result != XR_SUCCESS) return result;
    if (!session->is_running) return broken(XR_ERROR_SESSION_NOT_RUNNING, "xrEndSession", "it does not run");
    if (session->state != XR_SESSION_STATE_STOPPING)
        return broken(XR_ERROR_SESSION_NOT_STOPPING, "xrEndSession", word(session->state));
    session->is_running = false;
    go(*session, XR_SESSION_STATE_IDLE);
    if (session->exits) go(*session, XR_SESSION_STATE_EXITING);
    return XR_SUCCESS;
}

XrResult request_exit(XrSession handle) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, "xrRequestExitSession"); result != XR_SUCCESS) return result;
    if (!session->is_running)
        return broken(XR_ERROR_SESSION_NOT_RUNNING, "xrRequestExitSession", "it does not run");
    session->exits = true;
    session->target = XR_SESSION_STATE_SYNCHRONIZED;
    while (session->state != session->target) step_towards_target(*session);
    go(*session, XR_SESSION_STATE_STOPPING);
    return XR_SUCCESS;
}

XrResult enumerate_view_configurations(
    XrInstance, XrSystemId, std::uint32_t capacity, std::uint32_t* count, XrViewConfigurationType* out
) {
    static constexpr std::array kOnly{XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO};
    return give<XrViewConfigurationType>(kOnly, capacity, count, out);
}

XrResult get_view_configuration(
    XrInstance, XrSystemId, XrViewConfigurationType type, XrViewConfigurationProperties* out
) {
    out->viewConfigurationType = type;
    out->fovMutable = XR_TRUE;
    return XR_SUCCESS;
}

XrResult enumerate_views(
    XrInstance,
    XrSystemId,
    XrViewConfigurationType type,
    std::uint32_t capacity,
    std::uint32_t* count,
    XrViewConfigurationView* out
) {
    if (type != XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO)
        return broken(
            XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, "xrEnumerateViewConfigurationViews", "not stereo"
        );
    const XrViewConfigurationView view{
        XR_TYPE_VIEW_CONFIGURATION_VIEW, nullptr, kEyeWidth, 4096, kEyeHeight, 4096, 1, 4};
    const std::array views{view, view};
    return give<XrViewConfigurationView>(views, capacity, count, out);
}

XrResult enumerate_blend_modes(
    XrInstance,
    XrSystemId,
    XrViewConfigurationType,
    std::uint32_t capacity,
    std::uint32_t* count,
    XrEnvironmentBlendMode* out
) {
    static constexpr std::array kOnly{XR_ENVIRONMENT_BLEND_MODE_OPAQUE};
    return give<XrEnvironmentBlendMode>(kOnly, capacity, count, out);
}

}  // namespace

void forget_children(std::uint64_t session) {
    Runtime& all = runtime();
    const auto forget = [&](auto& table) {
        return std::erase_if(table.all(), [&](const auto& each) { return each.second.session == session; });
    };
    const auto swapchains = forget(all.swapchains);
    const auto spaces = forget(all.spaces);
    const auto trackers = forget(all.trackers);
    record(fmt::format(
        R"("leaked_swapchains":{},"leaked_spaces":{},"leaked_trackers":{})", swapchains, spaces, trackers
    ));
}

std::span<const Entry> session_calls() {
    static const std::array kCalls{
        entry<PFN_xrCreateSession>(kCreate, create_session),
        entry<PFN_xrDestroySession>("xrDestroySession", destroy_session),
        entry<PFN_xrBeginSession>("xrBeginSession", begin_session),
        entry<PFN_xrEndSession>("xrEndSession", end_session),
        entry<PFN_xrRequestExitSession>("xrRequestExitSession", request_exit),
        entry<PFN_xrEnumerateViewConfigurations>(
            "xrEnumerateViewConfigurations", enumerate_view_configurations
        ),
        entry<PFN_xrGetViewConfigurationProperties>(
            "xrGetViewConfigurationProperties", get_view_configuration
        ),
        entry<PFN_xrEnumerateViewConfigurationViews>("xrEnumerateViewConfigurationViews", enumerate_views),
        entry<PFN_xrEnumerateEnvironmentBlendModes>(
            "xrEnumerateEnvironmentBlendModes", enumerate_blend_modes
        ),
    };
    return kCalls;
}

}  // namespace feelem::xr_runtime
