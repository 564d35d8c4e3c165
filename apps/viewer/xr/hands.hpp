// SPDX-License-Identifier: Apache-2.0
// Bare hands: what pinch, fist and direction are, from the joints that the headset sees.
#pragma once

#include "viewer/core/input.hpp"
#include "viewer/xr/calls.hpp"

#include <array>
#include <optional>

namespace feelem::viewer::xr {

using Joints = std::array<Pose, XR_HAND_JOINT_COUNT_EXT>;

/// Fills the hand from its joints. The ray goes from the shoulder, as it must be for that head, through the
/// place where thumb and index finger meet: it stays when they close.
void read_joints(const Joints& joints, const Pose& head, Side side, HandInput& hand);

/// Trackers of both hands; destroyed with it.
class HandTrackers {
public:
    HandTrackers(XrInstance instance, XrSession session);
    ~HandTrackers();
    HandTrackers(const HandTrackers&) = delete;
    HandTrackers& operator=(const HandTrackers&) = delete;

    /// Empty: the hand is not seen.
    std::optional<Joints> locate(Side side, XrSpace space, XrTime time) const;

private:
    PFN_xrDestroyHandTrackerEXT destroy_ = nullptr;
    PFN_xrLocateHandJointsEXT locate_ = nullptr;
    std::array<XrHandTrackerEXT, kSides> trackers_{};
};

}  // namespace feelem::viewer::xr
