// SPDX-License-Identifier: Apache-2.0
// The controllers in both hands, read once a frame.
#pragma once

#include "viewer/core/input.hpp"
#include "viewer/xr/bindings.hpp"
#include "viewer/xr/calls.hpp"

#include <array>

namespace feelem::viewer::xr {

/// Belongs to the instance; a session attaches it.
class Actions {
public:
    explicit Actions(XrInstance instance);
    ~Actions();
    Actions(const Actions&) = delete;
    Actions& operator=(const Actions&) = delete;

    void attach(XrSession session) const;
    /// False: the headset's menu, or another program, has the hands now.
    bool sync(XrSession session) const;
    /// Null: nothing that we know is in that hand.
    const Profile* profile(XrSession session, Side side) const;
    /// Buttons and stick, not the poses; of a hand without a controller, nothing.
    void read(XrSession session, Side side, const Profile* profile, HandInput& hand) const;

    XrAction action(Part part) const { return actions_[static_cast<std::size_t>(part)]; }
    XrPath hand(Side side) const { return hands_[static_cast<std::size_t>(side)]; }

private:
    void suggest(const Profile& profile) const;
    float number(XrSession session, Part part, Side side) const;
    bool pressed(XrSession session, Part part, Side side) const;

    XrInstance instance_;
    XrActionSet set_ = XR_NULL_HANDLE;
    std::array<XrAction, kParts> actions_{};
    std::array<XrPath, kSides> hands_{};
};

/// A pad that is pressed at its rim is a stick, one that is pressed in its middle a pressed stick.
void read_pad_as_stick(HandInput& hand);

}  // namespace feelem::viewer::xr
