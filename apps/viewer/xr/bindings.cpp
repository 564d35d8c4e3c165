// SPDX-License-Identifier: Apache-2.0
// The table of controllers. A button that a controller lacks is left out: the menu, which every one has,
// reaches all.
#include "viewer/xr/bindings.hpp"

#include <algorithm>
#include <array>

namespace feelem::viewer::xr {

namespace {

constexpr PartPath kAim{Part::Aim, "input/aim/pose"};
constexpr PartPath kGrip{Part::Grip, "input/grip/pose"};
constexpr PartPath kShake{Part::Shake, "output/haptic"};
constexpr PartPath kTrigger{Part::Trigger, "input/trigger/value"};

constexpr std::array kSimpleBoth{
    kAim,
    kGrip,
    kShake,
    PartPath{Part::Trigger, "input/select/click"},
    PartPath{Part::UpperButton, "input/menu/click"},
};
constexpr std::array kTouchBoth{
    kAim,
    kGrip,
    kShake,
    kTrigger,
    PartPath{Part::Squeeze, "input/squeeze/value"},
    PartPath{Part::Stick, "input/thumbstick"},
    PartPath{Part::StickPressed, "input/thumbstick/click"},
};
constexpr std::array kTouchLeft{
    PartPath{Part::LowerButton, "input/x/click"},
    PartPath{Part::UpperButton, "input/y/click"},
    PartPath{Part::Menu, "input/menu/click"},
};
constexpr std::array kTouchRight{
    PartPath{Part::LowerButton, "input/a/click"},
    PartPath{Part::UpperButton, "input/b/click"},
};
// Whoever holds an Index controller touches its grip: only force means it.
constexpr std::array kIndexBoth{
    kAim,
    kGrip,
    kShake,
    kTrigger,
    PartPath{Part::Squeeze, "input/squeeze/force"},
    PartPath{Part::Stick, "input/thumbstick"},
    PartPath{Part::StickPressed, "input/thumbstick/click"},
    PartPath{Part::LowerButton, "input/a/click"},
    PartPath{Part::UpperButton, "input/b/click"},
};
constexpr std::array kViveBoth{
    kAim,
    kGrip,
    kShake,
    kTrigger,
    PartPath{Part::Squeeze, "input/squeeze/click"},
    PartPath{Part::Stick, "input/trackpad"},
    PartPath{Part::StickPressed, "input/trackpad/click"},
    PartPath{Part::UpperButton, "input/menu/click"},
};
constexpr std::array kMixedBoth{
    kAim,
    kGrip,
    kShake,
    kTrigger,
    PartPath{Part::Squeeze, "input/squeeze/click"},
    PartPath{Part::Stick, "input/thumbstick"},
    PartPath{Part::StickPressed, "input/thumbstick/click"},
    PartPath{Part::LowerButton, "input/trackpad/click"},
    PartPath{Part::UpperButton, "input/menu/click"},
};

constexpr std::array kProfiles{
    Profile{"/interaction_profiles/khr/simple_controller", "simple controllers", kSimpleBoth, {}, {}},
    Profile{
        "/interaction_profiles/oculus/touch_controller",
        "Touch controllers",
        kTouchBoth,
        kTouchLeft,
        kTouchRight},
    Profile{"/interaction_profiles/valve/index_controller", "Index controllers", kIndexBoth, {}, {}},
    Profile{"/interaction_profiles/htc/vive_controller", "Vive wands", kViveBoth, {}, {}, true},
    Profile{
        "/interaction_profiles/microsoft/motion_controller", "Mixed Reality controllers", kMixedBoth, {}, {}},
};

}  // namespace

std::span<const Profile> profiles() {
    return kProfiles;
}

const Profile* find_profile(std::string_view path) {
    const auto found = std::find_if(kProfiles.begin(), kProfiles.end(), [&](const Profile& each) {
        return each.path == path;
    });
    return found == kProfiles.end() ? nullptr : found;
}

}  // namespace feelem::viewer::xr
