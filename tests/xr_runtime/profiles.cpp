// SPDX-License-Identifier: Apache-2.0
// The table of controllers (OpenXR 1.0, 6.4). Written down apart from the viewer's own, so that each finds
// out the other's mistakes.
#include "profiles.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace feelem::xr_runtime {

namespace {

struct Profile {
    std::string_view name;
    std::string_view both, left, right;  ///< Words, each with a blank before and after it.
};

constexpr std::string_view kHands = "/user/hand/";
constexpr std::array kProfiles{
    Profile{
        "/interaction_profiles/khr/simple_controller",
        " input/select/click input/menu/click input/grip/pose input/aim/pose output/haptic ",
        "",
        ""},
    Profile{
        "/interaction_profiles/oculus/touch_controller",
        " input/squeeze/value input/trigger/value input/trigger/touch input/thumbstick/x input/thumbstick/y "
        "input/thumbstick/click input/thumbstick/touch input/thumbrest/touch input/grip/pose input/aim/pose "
        "output/haptic ",
        " input/x/click input/x/touch input/y/click input/y/touch input/menu/click ",
        " input/a/click input/a/touch input/b/click input/b/touch input/system/click "},
    Profile{
        "/interaction_profiles/valve/index_controller",
        " input/system/click input/system/touch input/a/click input/a/touch input/b/click input/b/touch "
        "input/squeeze/value input/squeeze/force input/trigger/click input/trigger/value input/trigger/touch "
        "input/thumbstick/x input/thumbstick/y input/thumbstick/click input/thumbstick/touch "
        "input/trackpad/x "
        "input/trackpad/y input/trackpad/force input/trackpad/touch input/grip/pose input/aim/pose "
        "output/haptic ",
        "",
        ""},
    Profile{
        "/interaction_profiles/htc/vive_controller",
        " input/system/click input/squeeze/click input/menu/click input/trigger/click input/trigger/value "
        "input/trackpad/x input/trackpad/y input/trackpad/click input/trackpad/touch input/grip/pose "
        "input/aim/pose "
        "output/haptic ",
        "",
        ""},
    Profile{
        "/interaction_profiles/microsoft/motion_controller",
        " input/menu/click input/squeeze/click input/trigger/value input/thumbstick/x input/thumbstick/y "
        "input/thumbstick/click input/trackpad/x input/trackpad/y input/trackpad/click input/trackpad/touch "
        "input/grip/pose input/aim/pose output/haptic ",
        "",
        ""},
};

const Profile* find(const std::string& name) {
    const auto found = std::find_if(kProfiles.begin(), kProfiles.end(), [&](const Profile& each) {
        return each.name == name;
    });
    return found == kProfiles.end() ? nullptr : found;
}

}  // namespace

bool is_profile(const std::string& profile) {
    return find(profile) != nullptr;
}

bool has_path(const std::string& profile, const std::string& path) {
    const Profile* known = find(profile);
    if (!known || path.rfind(kHands, 0) != 0) return false;
    const bool is_left = path.rfind("/user/hand/left/", 0) == 0;
    if (!is_left && path.rfind("/user/hand/right/", 0) != 0) return false;
    const std::string inner = path.substr(kHands.size() + (is_left ? 5 : 6));
    const auto has = [&](std::string_view words) {
        // `input/thumbstick` stands for the pair of its x and y.
        return words.find(" " + inner + " ") != std::string_view::npos ||
               words.find(" " + inner + "/x ") != std::string_view::npos;
    };
    return has(known->both) || has(is_left ? known->left : known->right);
}

}  // namespace feelem::xr_runtime
