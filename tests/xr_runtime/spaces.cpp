// SPDX-License-Identifier: Apache-2.0
// Where things are: reference and action spaces, the eyes, the joints of a hand.
#include "runtime.hpp"

namespace feelem::xr_runtime {

namespace {

constexpr float kHalfEyes = 0.032F;
constexpr XrSpaceLocationFlags kKnown =
    XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT |
    XR_SPACE_LOCATION_POSITION_TRACKED_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;

XrResult enumerate_references(
    XrSession, std::uint32_t capacity, std::uint32_t* count, XrReferenceSpaceType* out
) {
    std::vector all{XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL};
    if (!has_fault("no_stage")) all.push_back(XR_REFERENCE_SPACE_TYPE_STAGE);
    return give<XrReferenceSpaceType>(all, capacity, count, out);
}

XrResult create_reference(XrSession handle, const XrReferenceSpaceCreateInfo* info, XrSpace* out) {
    const char* call = "xrCreateReferenceSpace";
    const XrResult result = check(runtime().sessions.find(number_of(handle)), call);
    if (result != XR_SUCCESS) return result;
    const XrReferenceSpaceType type = info->referenceSpaceType;
    const bool is_known = type == XR_REFERENCE_SPACE_TYPE_VIEW || type == XR_REFERENCE_SPACE_TYPE_LOCAL ||
                          (type == XR_REFERENCE_SPACE_TYPE_STAGE && !has_fault("no_stage"));
    if (!is_known) return broken(XR_ERROR_REFERENCE_SPACE_UNSUPPORTED, call, "no such space");
    if (!is_pose(info->poseInReferenceSpace)) return broken(XR_ERROR_POSE_INVALID, call, "the pose is none");
    *out = handle_of<XrSpace>(
        runtime().spaces.add({number_of(handle), type, 0, 0, from_xr(info->poseInReferenceSpace)})
    );
    return XR_SUCCESS;
}

XrResult create_action_space(XrSession handle, const XrActionSpaceCreateInfo* info, XrSpace* out) {
    const char* call = "xrCreateActionSpace";
    const XrResult result = check(runtime().sessions.find(number_of(handle)), call);
    if (result != XR_SUCCESS) return result;
    const Action* action = runtime().actions.find(number_of(info->action));
    if (!action || action->type != XR_ACTION_TYPE_POSE_INPUT)
        return broken(XR_ERROR_ACTION_TYPE_MISMATCH, call, "not an action of poses");
    if (!is_pose(info->poseInActionSpace)) return broken(XR_ERROR_POSE_INVALID, call, "the pose is none");
    const std::size_t side = side_of(text_of(info->subactionPath));
    *out = handle_of<XrSpace>(runtime().spaces.add(
        {number_of(handle),
         XR_REFERENCE_SPACE_TYPE_LOCAL,
         number_of(info->action),
         side,
         from_xr(info->poseInActionSpace)}
    ));
    return XR_SUCCESS;
}

XrResult destroy_space(XrSpace handle) {
    const bool is_known = runtime().spaces.erase(number_of(handle));
    return is_known ? XR_SUCCESS : broken(XR_ERROR_HANDLE_INVALID, "xrDestroySpace", "no such space");
}

XrResult locate_space(XrSpace handle, XrSpace base_handle, XrTime time, XrSpaceLocation* out) {
    const Space* space = runtime().spaces.find(number_of(handle));
    const Space* base = runtime().spaces.find(number_of(base_handle));
    if (only_instance()->is_lost) return XR_ERROR_INSTANCE_LOST;
    if (!space || !base) return broken(XR_ERROR_HANDLE_INVALID, "xrLocateSpace", "no such space");
    const Session* session = runtime().sessions.find(space->session);
    if (session->is_lost) return XR_ERROR_SESSION_LOST;
    if (time <= 0) return broken(XR_ERROR_TIME_INVALID, "xrLocateSpace", "no time");
    const auto at = place_of(*space, *session), from = place_of(*base, *session);
    out->locationFlags = at && from ? kKnown : 0;
    out->pose = at && from ? to_xr(inverse(*from) * *at) : to_xr({});
    return XR_SUCCESS;
}

XrResult locate_views(
    XrSession handle,
    const XrViewLocateInfo* info,
    XrViewState* state,
    std::uint32_t capacity,
    std::uint32_t* count,
    XrView* out
) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, "xrLocateViews"); result != XR_SUCCESS) return result;
    const Space* base = runtime().spaces.find(number_of(info->space));
    if (!base) return broken(XR_ERROR_HANDLE_INVALID, "xrLocateViews", "no such space");
    const auto from = place_of(*base, *session);
    const World& world = runtime().world;
    state->viewStateFlags = world.is_head_tracked && from ? kKnown : 0;
    std::array<XrView, 2> views{};
    for (std::size_t eye = 0; eye < views.size(); ++eye) {
        const float side = eye == 0 ? -1.0F : 1.0F;
        const Place place = world.head * Place{{side * kHalfEyes, 0, 0}};
        const float outer = 0.9F, inner = 0.8F;
        views[eye] = {XR_TYPE_VIEW, nullptr, to_xr(from ? inverse(*from) * place : place), {}};
        views[eye].fov = {eye == 0 ? -outer : -inner, eye == 0 ? inner : outer, 0.75F, -0.85F};
    }
    return give<XrView>(views, capacity, count, out);
}

XrResult bounds(XrSession, XrReferenceSpaceType, XrExtent2Df* out) {
    *out = {0, 0};
    return XR_SPACE_BOUNDS_UNAVAILABLE;
}

XrResult create_tracker(XrSession handle, const XrHandTrackerCreateInfoEXT* info, XrHandTrackerEXT* out) {
    const XrResult result = check(runtime().sessions.find(number_of(handle)), "xrCreateHandTrackerEXT");
    if (result != XR_SUCCESS) return result;
    const std::size_t side = info->hand == XR_HAND_LEFT_EXT ? 0 : 1;
    *out = handle_of<XrHandTrackerEXT>(runtime().trackers.add({number_of(handle), side}));
    return XR_SUCCESS;
}

XrResult destroy_tracker(XrHandTrackerEXT handle) {
    const bool is_known = runtime().trackers.erase(number_of(handle));
    return is_known ? XR_SUCCESS
                    : broken(XR_ERROR_HANDLE_INVALID, "xrDestroyHandTrackerEXT", "no such tracker");
}

/// In the axes of the palm: -Z to the fingers, +Y out of the back. Tips come to the palm in a fist, the tips
/// of thumb and index finger to each other in a pinch.
glm::vec3 joint_place(int joint, const Hand& hand) {
    if (joint == XR_HAND_JOINT_PALM_EXT) return {0, 0, 0};
    if (joint == XR_HAND_JOINT_WRIST_EXT) return {0, 0, 0.08F};
    const glm::vec3 meeting{-0.02F, -0.03F, -0.08F};
    const float open = (1 - hand.pinch) * 0.03F;
    if (joint == XR_HAND_JOINT_THUMB_TIP_EXT) return meeting + glm::vec3(-open, 0, 0);
    if (joint == XR_HAND_JOINT_INDEX_TIP_EXT) return meeting + glm::vec3(open, 0, 0);
    if (joint < XR_HAND_JOINT_INDEX_METACARPAL_EXT) return {-0.03F, 0, 0.02F};
    const int finger = (joint - XR_HAND_JOINT_INDEX_METACARPAL_EXT) / 5;
    const int along = (joint - XR_HAND_JOINT_INDEX_METACARPAL_EXT) % 5;
    const float side = -0.02F + 0.02F * static_cast<float>(finger);
    const float reach = along < 2 ? 0.03F : 0.11F - 0.08F * hand.fist;
    return {side, along < 2 ? 0 : -0.02F * hand.fist, along == 0 ? 0.03F : -reach};
}

XrResult locate_joints(
    XrHandTrackerEXT handle, const XrHandJointsLocateInfoEXT* info, XrHandJointLocationsEXT* out
) {
    const HandTracker* tracker = runtime().trackers.find(number_of(handle));
    const Space* base = runtime().spaces.find(number_of(info->baseSpace));
    if (only_instance()->is_lost) return XR_ERROR_INSTANCE_LOST;
    if (!tracker || !base) return broken(XR_ERROR_HANDLE_INVALID, "xrLocateHandJointsEXT", "no such handle");
    if (out->jointCount != XR_HAND_JOINT_COUNT_EXT)
        return broken(XR_ERROR_VALIDATION_FAILURE, "xrLocateHandJointsEXT", "not 26 joints");
    const Session& session = *runtime().sessions.find(tracker->session);
    if (session.is_lost) return XR_ERROR_SESSION_LOST;
    const Hand& hand = runtime().world.hands[tracker->side];
    const auto from = place_of(*base, session);
    out->isActive = hand.is_bare && hand.is_tracked && from ? XR_TRUE : XR_FALSE;
    for (int joint = 0; joint < XR_HAND_JOINT_COUNT_EXT; ++joint) {
        XrHandJointLocationEXT& location = out->jointLocations[joint];
        location = {out->isActive ? kKnown : 0, to_xr({}), 0.008F};
        if (out->isActive)
            location.pose = to_xr(inverse(*from) * (hand.place * Place{joint_place(joint, hand)}));
    }
    return XR_SUCCESS;
}

}  // namespace

std::optional<Place> place_of(const Space& space, const Session& session) {
    const World& world = runtime().world;
    if (space.action != 0) {
        const Hand& hand = world.hands[space.side];
        const bool is_known = session.is_synced && session.state == XR_SESSION_STATE_FOCUSED &&
                              hand.is_tracked && !active_profile(space.side).empty();
        // The grip lies 5 cm behind the point that the controller points from.
        const bool is_grip = runtime().actions.find(space.action)->name.find("grip") != std::string::npos;
        const Place own{{0, 0, is_grip ? 0.05F : 0}};
        return is_known ? std::optional(hand.place * own * space.offset) : std::nullopt;
    }
    if (space.reference == XR_REFERENCE_SPACE_TYPE_STAGE) return space.offset;
    if (space.reference == XR_REFERENCE_SPACE_TYPE_LOCAL) return world.local * space.offset;
    return world.is_head_tracked ? std::optional(world.head * space.offset) : std::nullopt;
}

std::span<const Entry> space_calls() {
    static const std::array kCalls{
        entry<PFN_xrEnumerateReferenceSpaces>("xrEnumerateReferenceSpaces", enumerate_references),
        entry<PFN_xrCreateReferenceSpace>("xrCreateReferenceSpace", create_reference),
        entry<PFN_xrCreateActionSpace>("xrCreateActionSpace", create_action_space),
        entry<PFN_xrGetReferenceSpaceBoundsRect>("xrGetReferenceSpaceBoundsRect", bounds),
        entry<PFN_xrDestroySpace>("xrDestroySpace", destroy_space),
        entry<PFN_xrLocateSpace>("xrLocateSpace", locate_space),
        entry<PFN_xrLocateViews>("xrLocateViews", locate_views),
        entry<PFN_xrCreateHandTrackerEXT>("xrCreateHandTrackerEXT", create_tracker),
        entry<PFN_xrDestroyHandTrackerEXT>("xrDestroyHandTrackerEXT", destroy_tracker),
        entry<PFN_xrLocateHandJointsEXT>("xrLocateHandJointsEXT", locate_joints),
    };
    return kCalls;
}

}  // namespace feelem::xr_runtime
