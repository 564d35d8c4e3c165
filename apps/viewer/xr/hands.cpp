// SPDX-License-Identifier: Apache-2.0
// Joints to input.
#include "viewer/xr/hands.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace feelem::viewer::xr {

namespace {

/// 1 at `closed` and nearer, 0 at `open` and farther, metres.
float closeness(float distance, float closed, float open) {
    return std::clamp((open - distance) / (open - closed), 0.0F, 1.0F);
}

constexpr float kPinchClosed = 0.012F, kPinchOpen = 0.05F;
constexpr float kFistClosed = 0.05F, kFistOpen = 0.075F;

/// Below and beside the head, turned with it about the vertical alone.
glm::vec3 shoulder_of(const Pose& head, Side side) {
    glm::vec3 right = head.orientation * glm::vec3(1, 0, 0);
    right.y = 0;
    const float length = glm::length(right);
    right = length > 1e-3F ? right / length : glm::vec3(1, 0, 0);
    const float way = side == Side::Left ? -1.0F : 1.0F;
    return head.position + glm::vec3(0, -0.22F, 0) + way * 0.17F * right;
}

/// -Z along `ahead`, upright.
glm::quat looking(const glm::vec3& ahead) {
    const glm::vec3 up = std::abs(ahead.y) < 0.99F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    return glm::normalize(glm::quatLookAt(ahead, up));
}

}  // namespace

void read_joints(const Joints& joints, const Pose& head, Side side, HandInput& hand) {
    const auto at = [&](XrHandJointEXT joint) { return joints[static_cast<std::size_t>(joint)].position; };
    const glm::vec3 thumb = at(XR_HAND_JOINT_THUMB_TIP_EXT), index = at(XR_HAND_JOINT_INDEX_TIP_EXT);
    const glm::vec3 palm = at(XR_HAND_JOINT_PALM_EXT);
    hand.is_tracked = true;
    hand.is_bare = true;
    hand.can_vibrate = false;
    hand.fingertip = index;
    hand.grip = joints[XR_HAND_JOINT_PALM_EXT];
    hand.trigger = closeness(glm::distance(thumb, index), kPinchClosed, kPinchOpen);
    // The index finger is left out: it pinches while the others may be closed.
    const std::array tips{
        XR_HAND_JOINT_MIDDLE_TIP_EXT, XR_HAND_JOINT_RING_TIP_EXT, XR_HAND_JOINT_LITTLE_TIP_EXT};
    float sum = 0;
    for (const auto tip : tips) sum += glm::distance(at(tip), palm);
    hand.squeeze = closeness(sum / static_cast<float>(tips.size()), kFistClosed, kFistOpen);
    hand.aim.position = (thumb + index) / 2.0F;
    const glm::vec3 ahead = hand.aim.position - shoulder_of(head, side);
    const float reach = glm::length(ahead);
    if (reach > 0.05F) hand.aim.orientation = looking(ahead / reach);
}

HandTrackers::HandTrackers(XrInstance instance, XrSession session)
    : destroy_(function_of<PFN_xrDestroyHandTrackerEXT>(instance, "xrDestroyHandTrackerEXT")),
      locate_(function_of<PFN_xrLocateHandJointsEXT>(instance, "xrLocateHandJointsEXT")) {
    const auto create = function_of<PFN_xrCreateHandTrackerEXT>(instance, "xrCreateHandTrackerEXT");
    for (std::size_t side = 0; side < kSides; ++side) {
        auto info = typed<XrHandTrackerCreateInfoEXT>(XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT);
        info.hand = side == 0 ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT;
        info.handJointSet = XR_HAND_JOINT_SET_DEFAULT_EXT;
        // A headset may offer hands and yet refuse them now: the controllers remain.
        if (XR_FAILED(create(session, &info, &trackers_[side]))) trackers_[side] = XR_NULL_HANDLE;
    }
}

HandTrackers::~HandTrackers() {
    for (const XrHandTrackerEXT tracker : trackers_)
        if (tracker != XR_NULL_HANDLE) destroy_(tracker);
}

std::optional<Joints> HandTrackers::locate(Side side, XrSpace space, XrTime time) const {
    const XrHandTrackerEXT tracker = trackers_[static_cast<std::size_t>(side)];
    if (tracker == XR_NULL_HANDLE) return {};
    std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> places{};
    auto locations = typed<XrHandJointLocationsEXT>(XR_TYPE_HAND_JOINT_LOCATIONS_EXT);
    locations.jointCount = XR_HAND_JOINT_COUNT_EXT;
    locations.jointLocations = places.data();
    auto info = typed<XrHandJointsLocateInfoEXT>(XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT);
    info.baseSpace = space;
    info.time = time;
    must(locate_(tracker, &info, &locations), "xrLocateHandJointsEXT");
    if (!locations.isActive) return {};
    constexpr XrSpaceLocationFlags both =
        XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
    Joints joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if ((places[i].locationFlags & both) != both) return {};
        joints[i] = from_xr(places[i].pose);
    }
    return joints;
}

}  // namespace feelem::viewer::xr
