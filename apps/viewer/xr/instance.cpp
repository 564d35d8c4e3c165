// SPDX-License-Identifier: Apache-2.0
// Making the instance with the extensions that there are.
#include "viewer/xr/instance.hpp"

#include "viewer/xr/extensions.hpp"

#include <fmt/format.h>

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <algorithm>
#include <string_view>

namespace feelem::viewer::xr {

namespace {

constexpr const char* kEglExtension = "XR_MNDX_egl_enable";

Instance make(const std::string& application, bool is_egl) {
    const auto offered = all_of<XrExtensionProperties>(
        "xrEnumerateInstanceExtensionProperties",
        typed<XrExtensionProperties>(XR_TYPE_EXTENSION_PROPERTIES),
        [](auto capacity, auto* count, auto* out) {
            return xrEnumerateInstanceExtensionProperties(nullptr, capacity, count, out);
        }
    );
    std::vector<const char*> names{XR_KHR_OPENGL_ENABLE_EXTENSION_NAME};
    if (is_egl) names.push_back(kEglExtension);
    const auto enable = [&](std::string_view name) {
        const auto found =
            std::find_if(offered.begin(), offered.end(), [&](const XrExtensionProperties& each) {
                return name == each.extensionName;
            });
        if (found != offered.end()) names.push_back(found->extensionName);
        return found != offered.end();
    };
    Instance instance;
    instance.enabled.depth = enable(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME);
    instance.enabled.hands = enable(XR_EXT_HAND_TRACKING_EXTENSION_NAME);
    instance.enabled.envelope = enable(kEnvelopeExtension);
    instance.enabled.parametric = enable(kParametricExtension);
    auto info = typed<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
    application.copy(info.applicationInfo.applicationName, XR_MAX_APPLICATION_NAME_SIZE - 1);
    std::string_view("Feelem").copy(info.applicationInfo.engineName, XR_MAX_ENGINE_NAME_SIZE - 1);
    info.applicationInfo.applicationVersion = 1;
    // 1.0 is what every runtime knows, also those of 1.1.
    info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 20);
    info.enabledExtensionCount = static_cast<std::uint32_t>(names.size());
    info.enabledExtensionNames = names.data();
    must(xrCreateInstance(&info, &instance.handle), "xrCreateInstance");
    auto properties = typed<XrInstanceProperties>(XR_TYPE_INSTANCE_PROPERTIES);
    if (XR_SUCCEEDED(xrGetInstanceProperties(instance.handle, &properties))) {
        const XrVersion version = properties.runtimeVersion;
        instance.runtime = fmt::format(
            "{} {}.{}.{}",
            properties.runtimeName,
            XR_VERSION_MAJOR(version),
            XR_VERSION_MINOR(version),
            XR_VERSION_PATCH(version)
        );
    }
    return instance;
}

}  // namespace

InstanceTry make_instance(const std::string& application, bool is_egl) {
    try {
        return {XR_SUCCESS, make(application, is_egl)};
    } catch (const Failure& failure) {
        return {failure.result, {}};
    }
}

System find_headset(const Instance& instance) {
    auto info = typed<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
    info.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    System system;
    must(xrGetSystem(instance.handle, &info, &system.id), "xrGetSystem");
    auto properties = typed<XrSystemProperties>(XR_TYPE_SYSTEM_PROPERTIES);
    auto hands = typed<XrSystemHandTrackingPropertiesEXT>(XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT);
    SystemHapticParametric parametric;
    if (instance.enabled.hands) properties.next = &hands;
    if (instance.enabled.parametric) {
        parametric.next = properties.next;
        properties.next = &parametric;
    }
    if (XR_FAILED(xrGetSystemProperties(instance.handle, system.id, &properties))) {
        // A layer that is older than the extensions refuses the question, not the headset.
        properties.next = nullptr;
        must(xrGetSystemProperties(instance.handle, system.id, &properties), "xrGetSystemProperties");
    }
    system.headset = properties.systemName;
    system.has_hands = hands.supportsHandTracking == XR_TRUE;
    system.has_parametric = parametric.supportsParametricHaptics == XR_TRUE;
    return system;
}

}  // namespace feelem::viewer::xr
