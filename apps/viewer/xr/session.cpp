// SPDX-License-Identifier: Apache-2.0
// The life of a session, and where things are in it.
#include "viewer/xr/session.hpp"

#include <fmt/format.h>

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <algorithm>
#include <cmath>

namespace feelem::viewer::xr {

namespace {

constexpr float kEyeHeight = 1.6F;  ///< Of a person who stands, where no runtime says where the floor is.

XrSession make_session(const SessionParts& parts) {
    const XrInstance instance = parts.instance->handle;
    const auto ask =
        function_of<PFN_xrGetOpenGLGraphicsRequirementsKHR>(instance, "xrGetOpenGLGraphicsRequirementsKHR");
    auto requirements = typed<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
    // OpenGL 4.5 meets what any runtime wants; the call itself is what the specification insists on.
    must(ask(instance, parts.system.id, &requirements), "xrGetOpenGLGraphicsRequirementsKHR");
    auto info = typed<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
    info.next = parts.gl->binding();
    info.systemId = parts.system.id;
    XrSession session = XR_NULL_HANDLE;
    must(xrCreateSession(instance, &info, &session), "xrCreateSession");
    return session;
}

bool has_stage(XrSession session) {
    const auto types = all_of<XrReferenceSpaceType>(
        "xrEnumerateReferenceSpaces",
        XR_REFERENCE_SPACE_TYPE_VIEW,
        [&](auto capacity, auto* count, auto* out) {
            return xrEnumerateReferenceSpaces(session, capacity, count, out);
        }
    );
    return std::find(types.begin(), types.end(), XR_REFERENCE_SPACE_TYPE_STAGE) != types.end();
}

/// Turned about the vertical alone, to where the pose looks.
glm::quat upright(const glm::quat& orientation) {
    const glm::vec3 ahead = orientation * glm::vec3(0, 0, -1);
    return glm::angleAxis(std::atan2(-ahead.x, -ahead.z), glm::vec3(0, 1, 0));
}

}  // namespace

Space::Space(XrSession session, XrReferenceSpaceType type, const Pose& pose) {
    auto info = typed<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    info.referenceSpaceType = type;
    info.poseInReferenceSpace = to_xr(pose);
    must(xrCreateReferenceSpace(session, &info, &handle_), "xrCreateReferenceSpace");
}

Space::Space(XrSession session, XrAction action, XrPath hand) {
    auto info = typed<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
    info.action = action;
    info.subactionPath = hand;
    info.poseInActionSpace = kNoPose;
    must(xrCreateActionSpace(session, &info, &handle_), "xrCreateActionSpace");
}

Space::~Space() {
    if (handle_ != XR_NULL_HANDLE) xrDestroySpace(handle_);
}

std::optional<Pose> Space::locate(const Space& base, XrTime time) const {
    auto location = typed<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
    must(xrLocateSpace(handle_, base.handle_, time, &location), "xrLocateSpace");
    constexpr XrSpaceLocationFlags both =
        XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
    return (location.locationFlags & both) == both ? std::optional(from_xr(location.pose)) : std::nullopt;
}

OwnedSession::~OwnedSession() {
    if (handle != XR_NULL_HANDLE) xrDestroySession(handle);
    if (gl) gl->restore();
}

Session::Session(const SessionParts& parts) : parts_(parts) {
    owned_.gl = parts.gl;
    owned_.handle = make_session(parts);
    mend("xrCreateSession");
    formats_ = choose_formats(handle());
    local_ = Space(handle(), XR_REFERENCE_SPACE_TYPE_LOCAL);
    view_ = Space(handle(), XR_REFERENCE_SPACE_TYPE_VIEW);
    if (has_stage(handle())) stage_ = Space(handle(), XR_REFERENCE_SPACE_TYPE_STAGE);
    room_in_local_.position.y = -kEyeHeight;
    room_ = Space(handle(), XR_REFERENCE_SPACE_TYPE_LOCAL, room_in_local_);
    parts.actions->attach(handle());
    for (const Side side : {Side::Left, Side::Right}) {
        const auto at = static_cast<std::size_t>(side);
        aim_[at] = Space(handle(), parts.actions->action(Part::Aim), parts.actions->hand(side));
        grip_[at] = Space(handle(), parts.actions->action(Part::Grip), parts.actions->hand(side));
    }
    if (parts.system.has_hands) trackers_ = std::make_unique<HandTrackers>(parts.instance->handle, handle());
    make_eyes();
}

void Session::make_eyes() {
    const XrInstance instance = parts_.instance->handle;
    const auto sizes = all_of<XrViewConfigurationView>(
        "xrEnumerateViewConfigurationViews",
        typed<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW),
        [&](auto capacity, auto* count, auto* out) {
            return xrEnumerateViewConfigurationViews(
                instance, parts_.system.id, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, capacity, count, out
            );
        }
    );
    if (sizes.size() != eyes_.size())
        throw Failure{XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, "xrEnumerateViewConfigurationViews"};
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        PictureInfo info{formats_.colour, false, 0, 0};
        info.width = static_cast<int>(sizes[i].recommendedImageRectWidth);
        info.height = static_cast<int>(sizes[i].recommendedImageRectHeight);
        eyes_[i].colour = std::make_unique<Picture>(handle(), info);
        mend("xrCreateSwapchain");
        eyes_[i].colour->make_framebuffers();
        if (!parts_.instance->enabled.depth || formats_.depth == 0) continue;
        info.format = formats_.depth;
        info.is_depth = true;
        eyes_[i].depth = std::make_unique<Picture>(handle(), info);
        mend("xrCreateSwapchain");
    }
}

void Session::begin() {
    auto info = typed<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
    info.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    must(xrBeginSession(handle(), &info), "xrBeginSession");
    mend("xrBeginSession");
}

void Session::end() {
    must(xrEndSession(handle()), "xrEndSession");
    mend("xrEndSession");
    has_begun_frame_ = false;
}

void Session::request_exit() {
    must(xrRequestExitSession(handle()), "xrRequestExitSession");
}

void Session::local_changed() {
    floor_.reset();
    room_in_local_ = {{0, -kEyeHeight, 0}};
    room_ = Space(handle(), XR_REFERENCE_SPACE_TYPE_LOCAL, room_in_local_);
}

void Session::place_room(XrTime time) {
    Pose wanted = room_in_local_;
    if (!floor_ && stage_.handle() != XR_NULL_HANDLE)
        if (const auto stage = stage_.locate(local_, time)) {
            floor_ = stage->position.y;
            wanted.position.y = *floor_;
        }
    if (wants_recentre_)
        if (const auto head = view_.locate(local_, time)) {
            wants_recentre_ = false;
            wanted.position.x = head->position.x;
            wanted.position.z = head->position.z;
            wanted.orientation = upright(head->orientation);
        }
    if (wanted.position == room_in_local_.position && wanted.orientation == room_in_local_.orientation)
        return;
    room_in_local_ = wanted;
    room_ = Space(handle(), XR_REFERENCE_SPACE_TYPE_LOCAL, wanted);
}

std::string Session::input_name() const {
    std::array<std::string, kSides> names;
    for (std::size_t side = 0; side < kSides; ++side) {
        if (profiles_[side])
            names[side] = profiles_[side]->name;
        else if (hands_[side].is_tracked && hands_[side].is_bare)
            names[side] = "bare hands";
    }
    if (names[0] == names[1] || names[1].empty()) return names[0];
    return names[0].empty() ? names[1] : names[0] + " and " + names[1];
}

void Session::take_quirks(std::vector<std::string>& quirks) {
    for (const std::string& quirk : quirks_) quirks.push_back(quirk);
    quirks_.clear();
}

void Session::mend(const char* call) {
    const bool was_taken = parts_.gl->restore();
    const int errors = drain_gl_errors();
    if (was_taken && told_.insert(std::string("context ") + call).second)
        quirks_.insert(fmt::format("{} takes away our OpenGL context: it is given back.", call));
    if (errors > 0 && told_.insert(std::string("error ") + call).second)
        quirks_.insert(fmt::format("{} leaves an OpenGL error behind: it is cleared.", call));
}

}  // namespace feelem::viewer::xr
