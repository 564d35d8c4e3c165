// SPDX-License-Identifier: Apache-2.0
// Opens the probe's session: headset, hands, a picture for each eye.
#include "probe_session.hpp"

#include <string>

namespace feelem::probe {
namespace {
XrPath path_of(const Session& xr, const std::string& text) {
    XrPath path = XR_NULL_PATH;
    check(xrStringToPath(xr.instance, text.c_str(), &path), "xrStringToPath");
    return path;
}

XrAction create_action(const Session& xr, const char* name, XrActionType type) {
    auto create = made<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
    std::strcpy(create.actionName, name);
    std::strcpy(create.localizedActionName, name);
    create.actionType = type;
    const std::array<XrPath, 2> hands{xr.hands[0].path, xr.hands[1].path};
    create.countSubactionPaths = hands.size();
    create.subactionPaths = hands.data();
    XrAction action = XR_NULL_HANDLE;
    check(xrCreateAction(xr.set, &create, &action), "xrCreateAction");
    return action;
}

void bind(const Session& xr, const std::string& profile, const char* trigger) {
    std::vector<XrActionSuggestedBinding> bindings;
    for (const char* hand : kHandNames) {
        const std::string at = fmt::format("/user/hand/{}/", hand);
        bindings.push_back({xr.aim, path_of(xr, at + "input/aim/pose")});
        bindings.push_back({xr.trigger, path_of(xr, at + trigger)});
        bindings.push_back({xr.touch, path_of(xr, at + "output/haptic")});
    }
    auto suggest = made<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    suggest.interactionProfile = path_of(xr, profile);
    suggest.suggestedBindings = bindings.data();
    suggest.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    check(xrSuggestInteractionProfileBindings(xr.instance, &suggest), "xrSuggestInteractionProfileBindings");
}
}  // namespace

void create_instance(Session& xr) {
    const std::array<const char*, 2> extensions{
        XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, XR_MNDX_EGL_ENABLE_EXTENSION_NAME};
    auto create = made<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
    std::strcpy(create.applicationInfo.applicationName, "xr_probe");
    create.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
    create.enabledExtensionCount = extensions.size();
    create.enabledExtensionNames = extensions.data();
    check(xrCreateInstance(&create, &xr.instance), "xrCreateInstance");
    auto about = made<XrInstanceProperties>(XR_TYPE_INSTANCE_PROPERTIES);
    check(xrGetInstanceProperties(xr.instance, &about), "xrGetInstanceProperties");
    auto wanted = made<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
    wanted.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    check(xrGetSystem(xr.instance, &wanted, &xr.system), "xrGetSystem");
    auto system = made<XrSystemProperties>(XR_TYPE_SYSTEM_PROPERTIES);
    check(xrGetSystemProperties(xr.instance, xr.system, &system), "xrGetSystemProperties");
    say(R"({{"event":"runtime","name":"{}","system":"{}"}})", about.runtimeName, system.systemName);
}

void create_session(Session& xr, const Graphics& gl) {
    PFN_xrGetOpenGLGraphicsRequirementsKHR requirements = nullptr;
    check(
        xrGetInstanceProcAddr(
            xr.instance,
            "xrGetOpenGLGraphicsRequirementsKHR",
            reinterpret_cast<PFN_xrVoidFunction*>(&requirements)
        ),
        "xrGetInstanceProcAddr"
    );
    auto needs = made<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
    check(requirements(xr.instance, xr.system, &needs), "xrGetOpenGLGraphicsRequirementsKHR");
    auto binding = made<XrGraphicsBindingEGLMNDX>(XR_TYPE_GRAPHICS_BINDING_EGL_MNDX);
    binding.getProcAddress = eglGetProcAddress;
    binding.display = gl.display;
    binding.config = gl.config;
    binding.context = gl.context;
    auto create = made<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
    create.next = &binding;
    create.systemId = xr.system;
    check(xrCreateSession(xr.instance, &create, &xr.session), "xrCreateSession");
    auto space = made<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    space.poseInReferenceSpace.orientation.w = 1;
    space.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_STAGE;
    check(xrCreateReferenceSpace(xr.session, &space, &xr.local), "xrCreateReferenceSpace");
    space.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_VIEW;
    check(xrCreateReferenceSpace(xr.session, &space, &xr.view), "xrCreateReferenceSpace");
}

void create_actions(Session& xr) {
    auto create = made<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
    std::strcpy(create.actionSetName, "probe");
    std::strcpy(create.localizedActionSetName, "probe");
    check(xrCreateActionSet(xr.instance, &create, &xr.set), "xrCreateActionSet");
    for (std::size_t i = 0; i < xr.hands.size(); ++i) {
        xr.hands[i].path = path_of(xr, fmt::format("/user/hand/{}", kHandNames[i]));
    }
    xr.aim = create_action(xr, "aim", XR_ACTION_TYPE_POSE_INPUT);
    xr.trigger = create_action(xr, "trigger", XR_ACTION_TYPE_FLOAT_INPUT);
    xr.touch = create_action(xr, "touch", XR_ACTION_TYPE_VIBRATION_OUTPUT);
    bind(xr, "/interaction_profiles/khr/simple_controller", "input/select/click");
    bind(xr, "/interaction_profiles/valve/index_controller", "input/trigger/value");
    bind(xr, "/interaction_profiles/microsoft/motion_controller", "input/trigger/value");
    auto attach = made<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
    attach.countActionSets = 1;
    attach.actionSets = &xr.set;
    check(xrAttachSessionActionSets(xr.session, &attach), "xrAttachSessionActionSets");
    for (Hand& hand : xr.hands) {
        auto space = made<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
        space.action = xr.aim;
        space.subactionPath = hand.path;
        space.poseInActionSpace.orientation.w = 1;
        check(xrCreateActionSpace(xr.session, &space, &hand.aim), "xrCreateActionSpace");
    }
}

void create_eyes(Session& xr) {
    std::array<XrViewConfigurationView, 2> views{};
    for (XrViewConfigurationView& view : views) view.type = XR_TYPE_VIEW_CONFIGURATION_VIEW;
    std::uint32_t count = 0;
    check(
        xrEnumerateViewConfigurationViews(
            xr.instance, xr.system, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, 2, &count, views.data()
        ),
        "xrEnumerateViewConfigurationViews"
    );
    for (std::size_t i = 0; i < xr.eyes.size(); ++i) {
        Eye& eye = xr.eyes[i];
        eye.width = static_cast<std::int32_t>(views[i].recommendedImageRectWidth);
        eye.height = static_cast<std::int32_t>(views[i].recommendedImageRectHeight);
        auto create = made<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
        create.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT | XR_SWAPCHAIN_USAGE_SAMPLED_BIT;
        create.format = GL_SRGB8_ALPHA8;
        create.sampleCount = create.faceCount = create.arraySize = create.mipCount = 1;
        create.width = views[i].recommendedImageRectWidth;
        create.height = views[i].recommendedImageRectHeight;
        check(xrCreateSwapchain(xr.session, &create, &eye.chain), "xrCreateSwapchain");
        check(xrEnumerateSwapchainImages(eye.chain, 0, &count, nullptr), "xrEnumerateSwapchainImages");
        std::vector<XrSwapchainImageOpenGLKHR> images(
            count, made<XrSwapchainImageOpenGLKHR>(XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR)
        );
        check(
            xrEnumerateSwapchainImages(
                eye.chain, count, &count, reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())
            ),
            "xrEnumerateSwapchainImages"
        );
        for (const XrSwapchainImageOpenGLKHR& image : images) eye.images.push_back(image.image);
    }
    say(R"({{"event":"eyes","width":{},"height":{}}})", xr.eyes[0].width, xr.eyes[0].height);
}

}  // namespace feelem::probe
