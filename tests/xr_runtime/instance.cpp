// SPDX-License-Identifier: Apache-2.0
// Negotiation with the loader, the instance, its system and its paths.
#include "extensions.hpp"
#include "runtime.hpp"

#include <epoxy/egl.h>
#include <fmt/format.h>

#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_EGL
#include <openxr/openxr_platform.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>

namespace feelem::xr_runtime {

namespace {

struct Offer {
    const char* name;
    std::uint32_t version;
    const char* without;  ///< Fault that takes it away.
};
constexpr std::array kOffers{
    Offer{XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, 10, "no_opengl"},
    Offer{XR_MNDX_EGL_ENABLE_EXTENSION_NAME, 1, "no_egl"},
    Offer{XR_MND_HEADLESS_EXTENSION_NAME, 2, "no_headless"},
    Offer{XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME, 5, "no_depth"},
    Offer{XR_EXT_HAND_TRACKING_EXTENSION_NAME, 4, "no_hands"},
    Offer{kEnvelopeName, 1, "no_envelope"},
    Offer{kParametricName, 1, "no_parametric"},
};

bool is_offered(std::string_view name) {
    const auto found =
        std::find_if(kOffers.begin(), kOffers.end(), [&](const Offer& offer) { return name == offer.name; });
    return found != kOffers.end() && !has_fault(found->without);
}

void copy_text(char* out, std::size_t room, std::string_view text) {
    const std::size_t length = std::min(room - 1, text.size());
    std::memcpy(out, text.data(), length);
    out[length] = '\0';
}

XrResult enumerate_extensions(
    const char* layer, std::uint32_t capacity, std::uint32_t* count, XrExtensionProperties* out
) {
    if (layer) return XR_ERROR_API_LAYER_NOT_PRESENT;
    begin_script();
    std::vector<XrExtensionProperties> offered;
    for (const Offer& offer : kOffers) {
        if (has_fault(offer.without)) continue;
        XrExtensionProperties properties{XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, offer.version};
        copy_text(properties.extensionName, sizeof properties.extensionName, offer.name);
        offered.push_back(properties);
    }
    return give<XrExtensionProperties>(offered, capacity, count, out);
}

XrResult create_instance(const XrInstanceCreateInfo* info, XrInstance* out) {
    begin_script();
    Runtime& all = runtime();
    if (has_fault("slow_service")) std::this_thread::sleep_for(std::chrono::milliseconds(500));
    if (has_fault("no_service") || all.refused_creations > 0) {
        all.refused_creations = std::max(0, all.refused_creations - 1);
        record(R"("instance":"refused")");
        return XR_ERROR_RUNTIME_FAILURE;
    }
    if (!info || !out) return broken(XR_ERROR_VALIDATION_FAILURE, "xrCreateInstance", "null");
    if (only_instance()) return broken(XR_ERROR_LIMIT_REACHED, "xrCreateInstance", "one lives already");
    Instance instance;
    for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i) {
        const char* name = info->enabledExtensionNames[i];
        if (!is_offered(name)) return broken(XR_ERROR_EXTENSION_NOT_PRESENT, "xrCreateInstance", name);
        instance.extensions.insert(name);
    }
    *out = handle_of<XrInstance>(all.instances.add(std::move(instance)));
    record(R"("instance":"created")");
    return XR_SUCCESS;
}

XrResult destroy_instance(XrInstance handle) {
    Runtime& all = runtime();
    if (!all.instances.find(number_of(handle)))
        return broken(XR_ERROR_HANDLE_INVALID, "xrDestroyInstance", "no such instance");
    std::vector<std::uint64_t> left;
    for (const auto& [number, session] : all.sessions.all()) left.push_back(number);
    for (const std::uint64_t session : left) forget_children(session);
    record(fmt::format(
        R"("instance":"destroyed","leaked_sessions":{},"leaked_sets":{})", left.size(), all.sets.all().size()
    ));
    all.sessions = {};
    all.sets = {};
    all.actions = {};
    all.instances.erase(number_of(handle));
    return XR_SUCCESS;
}

XrResult get_instance_properties(XrInstance, XrInstanceProperties* out) {
    out->runtimeVersion = XR_MAKE_VERSION(1, 2, 3);
    copy_text(out->runtimeName, sizeof out->runtimeName, "Feelem's scripted runtime");
    return XR_SUCCESS;
}

XrResult poll_event(XrInstance, XrEventDataBuffer* out) {
    Instance* instance = only_instance();
    if (!instance) return XR_ERROR_HANDLE_INVALID;
    if (instance->is_lost) return XR_ERROR_INSTANCE_LOST;
    if (!instance->events.empty()) {
        *out = instance->events.front();
        instance->events.pop_front();
        return XR_SUCCESS;
    }
    for (auto& [number, session] : runtime().sessions.all())
        if (session.state == XR_SESSION_STATE_IDLE && session.polls_to_ready > 0 &&
            --session.polls_to_ready == 0)
            go(session, XR_SESSION_STATE_READY);
    return XR_EVENT_UNAVAILABLE;
}

XrResult result_to_string(XrInstance, XrResult value, char out[XR_MAX_RESULT_STRING_SIZE]) {
    copy_text(out, XR_MAX_RESULT_STRING_SIZE, fmt::format("XR_RESULT_{}", static_cast<int>(value)));
    return XR_SUCCESS;
}

XrResult structure_to_string(XrInstance, XrStructureType value, char out[XR_MAX_STRUCTURE_NAME_SIZE]) {
    copy_text(out, XR_MAX_STRUCTURE_NAME_SIZE, fmt::format("XR_TYPE_{}", static_cast<int>(value)));
    return XR_SUCCESS;
}

XrResult get_system(XrInstance, const XrSystemGetInfo* info, XrSystemId* out) {
    if (only_instance()->is_lost) return XR_ERROR_INSTANCE_LOST;
    if (info->formFactor != XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY) return XR_ERROR_FORM_FACTOR_UNSUPPORTED;
    if (has_fault("no_headset")) return XR_ERROR_FORM_FACTOR_UNAVAILABLE;
    *out = kSystem;
    return XR_SUCCESS;
}

XrResult get_system_properties(XrInstance, XrSystemId system, XrSystemProperties* out) {
    if (system != kSystem) return broken(XR_ERROR_SYSTEM_INVALID, "xrGetSystemProperties", "no such system");
    const auto& extensions = only_instance()->extensions;
    out->systemId = system;
    copy_text(out->systemName, sizeof out->systemName, "Scripted headset");
    out->graphicsProperties = {4096, 4096, 16};
    out->trackingProperties = {XR_TRUE, XR_TRUE};
    for (auto* next = static_cast<XrBaseOutStructure*>(out->next); next; next = next->next) {
        if (next->type == XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT)
            reinterpret_cast<XrSystemHandTrackingPropertiesEXT*>(next)->supportsHandTracking =
                extensions.count(XR_EXT_HAND_TRACKING_EXTENSION_NAME) != 0;
        if (next->type == kSystemParametricType)
            reinterpret_cast<SystemParametricProperties*>(next)->is_supported =
                extensions.count(kParametricName) != 0;
    }
    return XR_SUCCESS;
}

XrResult get_requirements(XrInstance, XrSystemId, XrGraphicsRequirementsOpenGLKHR* out) {
    only_instance()->knows_requirements = true;
    out->minApiVersionSupported = XR_MAKE_VERSION(3, 3, 0);
    out->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
    return XR_SUCCESS;
}

XrResult string_to_path(XrInstance, const char* text, XrPath* out) {
    const std::string_view view = text ? text : "";
    const bool is_well_formed =
        view.size() > 1 && view.front() == '/' && view.back() != '/' &&
        view.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_./") == std::string_view::npos;
    if (!is_well_formed) return broken(XR_ERROR_PATH_FORMAT_INVALID, "xrStringToPath", std::string(view));
    *out = path_of(std::string(view));
    return XR_SUCCESS;
}

XrResult path_to_string(XrInstance, XrPath path, std::uint32_t capacity, std::uint32_t* count, char* out) {
    if (text_of(path).empty()) return broken(XR_ERROR_PATH_INVALID, "xrPathToString", "no such path");
    return give_text(text_of(path), capacity, count, out);
}

}  // namespace

XrPath path_of(const std::string& text) {
    auto& paths = only_instance()->paths;
    auto found = std::find(paths.begin(), paths.end(), text);
    if (found == paths.end()) found = paths.insert(paths.end(), text);
    return static_cast<XrPath>(found - paths.begin()) + 1;
}

const std::string& text_of(XrPath path) {
    static const std::string none;
    const auto& paths = only_instance()->paths;
    return path >= 1 && path <= paths.size() ? paths[path - 1] : none;
}

std::span<const Entry> instance_calls() {
    static const std::array kCalls{
        entry<PFN_xrEnumerateInstanceExtensionProperties>(
            "xrEnumerateInstanceExtensionProperties", enumerate_extensions
        ),
        entry<PFN_xrCreateInstance>("xrCreateInstance", create_instance),
        entry<PFN_xrDestroyInstance>("xrDestroyInstance", destroy_instance),
        entry<PFN_xrGetInstanceProperties>("xrGetInstanceProperties", get_instance_properties),
        entry<PFN_xrPollEvent>("xrPollEvent", poll_event),
        entry<PFN_xrResultToString>("xrResultToString", result_to_string),
        entry<PFN_xrStructureTypeToString>("xrStructureTypeToString", structure_to_string),
        entry<PFN_xrGetSystem>("xrGetSystem", get_system),
        entry<PFN_xrGetSystemProperties>("xrGetSystemProperties", get_system_properties),
        entry<PFN_xrGetOpenGLGraphicsRequirementsKHR>("xrGetOpenGLGraphicsRequirementsKHR", get_requirements),
        entry<PFN_xrStringToPath>("xrStringToPath", string_to_path),
        entry<PFN_xrPathToString>("xrPathToString", path_to_string),
    };
    return kCalls;
}

}  // namespace feelem::xr_runtime
