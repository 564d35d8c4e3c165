// SPDX-License-Identifier: Apache-2.0
// One action set, bound for every controller of the table.
#include "viewer/xr/actions.hpp"

#include <glm/geometric.hpp>

#include <string>

namespace feelem::viewer::xr {

namespace {

struct PartAction {
    Part part;
    XrActionType type;
    const char *name, *title;
};

constexpr std::array<PartAction, kParts> kActions{{
    {Part::Aim, XR_ACTION_TYPE_POSE_INPUT, "aim", "Point"},
    {Part::Grip, XR_ACTION_TYPE_POSE_INPUT, "grip", "Hand"},
    {Part::Trigger, XR_ACTION_TYPE_FLOAT_INPUT, "trigger", "Hear and feel"},
    {Part::Squeeze, XR_ACTION_TYPE_FLOAT_INPUT, "squeeze", "Carry the model"},
    {Part::Stick, XR_ACTION_TYPE_VECTOR2F_INPUT, "stick", "Turn and go"},
    {Part::StickPressed, XR_ACTION_TYPE_BOOLEAN_INPUT, "stick_pressed", "Home or mute"},
    {Part::LowerButton, XR_ACTION_TYPE_BOOLEAN_INPUT, "lower_button", "Note or cut"},
    {Part::UpperButton, XR_ACTION_TYPE_BOOLEAN_INPUT, "upper_button", "Menu or next result"},
    {Part::Menu, XR_ACTION_TYPE_BOOLEAN_INPUT, "menu", "Panel"},
    {Part::Shake, XR_ACTION_TYPE_VIBRATION_OUTPUT, "shake", "Vibration"},
}};

constexpr std::array kHands{"/user/hand/left", "/user/hand/right"};

XrPath path_of(XrInstance instance, const std::string& text) {
    XrPath path = XR_NULL_PATH;
    must(xrStringToPath(instance, text.c_str(), &path), "xrStringToPath");
    return path;
}

std::string text_of(XrInstance instance, XrPath path) {
    const auto text = all_of<char>("xrPathToString", '\0', [&](auto capacity, auto* count, auto* out) {
        return xrPathToString(instance, path, capacity, count, out);
    });
    return {text.data()};
}

}  // namespace

Actions::Actions(XrInstance instance) : instance_(instance) {
    auto info = typed<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
    std::string_view("feelem").copy(info.actionSetName, XR_MAX_ACTION_SET_NAME_SIZE - 1);
    std::string_view("Feelem").copy(info.localizedActionSetName, XR_MAX_LOCALIZED_ACTION_SET_NAME_SIZE - 1);
    for (std::size_t side = 0; side < kSides; ++side) hands_[side] = path_of(instance, kHands[side]);
    must(xrCreateActionSet(instance, &info, &set_), "xrCreateActionSet");
    for (const PartAction& each : kActions) {
        auto action = typed<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
        action.actionType = each.type;
        std::string_view(each.name).copy(action.actionName, XR_MAX_ACTION_NAME_SIZE - 1);
        std::string_view(each.title).copy(action.localizedActionName, XR_MAX_LOCALIZED_ACTION_NAME_SIZE - 1);
        action.countSubactionPaths = kSides;
        action.subactionPaths = hands_.data();
        must(xrCreateAction(set_, &action, &actions_[static_cast<std::size_t>(each.part)]), "xrCreateAction");
    }
    for (const Profile& profile : profiles()) suggest(profile);
}

Actions::~Actions() {
    if (set_ != XR_NULL_HANDLE) xrDestroyActionSet(set_);
}

void Actions::suggest(const Profile& profile) const {
    std::vector<XrActionSuggestedBinding> bindings;
    const auto add = [&](std::span<const PartPath> parts, std::size_t side) {
        for (const PartPath& each : parts)
            bindings.push_back(
                {action(each.part),
                 path_of(instance_, std::string(kHands[side]) + "/" + std::string(each.path))}
            );
    };
    for (std::size_t side = 0; side < kSides; ++side) {
        add(profile.both, side);
        add(side == 0 ? profile.left : profile.right, side);
    }
    auto info = typed<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    info.interactionProfile = path_of(instance_, std::string(profile.path));
    info.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    info.suggestedBindings = bindings.data();
    const XrResult result = xrSuggestInteractionProfileBindings(instance_, &info);
    // A runtime may know fewer controllers than the specification has.
    if (result != XR_ERROR_PATH_UNSUPPORTED) must(result, "xrSuggestInteractionProfileBindings");
}

void Actions::attach(XrSession session) const {
    auto info = typed<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
    info.countActionSets = 1;
    info.actionSets = &set_;
    must(xrAttachSessionActionSets(session, &info), "xrAttachSessionActionSets");
}

bool Actions::sync(XrSession session) const {
    const XrActiveActionSet active{set_, XR_NULL_PATH};
    auto info = typed<XrActionsSyncInfo>(XR_TYPE_ACTIONS_SYNC_INFO);
    info.countActiveActionSets = 1;
    info.activeActionSets = &active;
    return must(xrSyncActions(session, &info), "xrSyncActions") != XR_SESSION_NOT_FOCUSED;
}

const Profile* Actions::profile(XrSession session, Side side) const {
    auto state = typed<XrInteractionProfileState>(XR_TYPE_INTERACTION_PROFILE_STATE);
    must(xrGetCurrentInteractionProfile(session, hand(side), &state), "xrGetCurrentInteractionProfile");
    return state.interactionProfile == XR_NULL_PATH
               ? nullptr
               : find_profile(text_of(instance_, state.interactionProfile));
}

float Actions::number(XrSession session, Part part, Side side) const {
    auto info = typed<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
    info.action = action(part);
    info.subactionPath = hand(side);
    auto state = typed<XrActionStateFloat>(XR_TYPE_ACTION_STATE_FLOAT);
    must(xrGetActionStateFloat(session, &info, &state), "xrGetActionStateFloat");
    return state.isActive ? state.currentState : 0;
}

bool Actions::pressed(XrSession session, Part part, Side side) const {
    auto info = typed<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
    info.action = action(part);
    info.subactionPath = hand(side);
    auto state = typed<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
    must(xrGetActionStateBoolean(session, &info, &state), "xrGetActionStateBoolean");
    return state.isActive && state.currentState;
}

void Actions::read(XrSession session, Side side, const Profile* profile, HandInput& hand_input) const {
    auto info = typed<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
    info.action = action(Part::Stick);
    info.subactionPath = hand(side);
    auto stick = typed<XrActionStateVector2f>(XR_TYPE_ACTION_STATE_VECTOR2F);
    must(xrGetActionStateVector2f(session, &info, &stick), "xrGetActionStateVector2f");
    hand_input.trigger = number(session, Part::Trigger, side);
    hand_input.squeeze = number(session, Part::Squeeze, side);
    hand_input.stick = stick.isActive ? glm::vec2(stick.currentState.x, stick.currentState.y) : glm::vec2(0);
    hand_input.stick_pressed = pressed(session, Part::StickPressed, side);
    hand_input.lower_button = pressed(session, Part::LowerButton, side);
    hand_input.upper_button = pressed(session, Part::UpperButton, side);
    hand_input.menu = pressed(session, Part::Menu, side);
    if (profile && profile->has_pad_for_stick) read_pad_as_stick(hand_input);
}

void read_pad_as_stick(HandInput& hand) {
    constexpr float middle = 0.5F;
    const bool is_rim = glm::length(hand.stick) > middle;
    if (!hand.stick_pressed || !is_rim) hand.stick = glm::vec2(0);
    hand.stick_pressed = hand.stick_pressed && !is_rim;
}

}  // namespace feelem::viewer::xr
