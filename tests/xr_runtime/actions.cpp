// SPDX-License-Identifier: Apache-2.0
// Action sets, actions, and the bindings that a program suggests for them.
#include "profiles.hpp"
#include "runtime.hpp"

#include <algorithm>

namespace feelem::xr_runtime {

namespace {

constexpr const char* kSuggest = "xrSuggestInteractionProfileBindings";

bool is_name(std::string_view name) {
    return !name.empty() &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_.") == std::string_view::npos;
}

XrResult create_set(XrInstance, const XrActionSetCreateInfo* info, XrActionSet* out) {
    const char* call = "xrCreateActionSet";
    if (only_instance()->is_lost) return XR_ERROR_INSTANCE_LOST;
    if (!is_name(info->actionSetName)) return broken(XR_ERROR_PATH_FORMAT_INVALID, call, info->actionSetName);
    if (info->localizedActionSetName[0] == '\0')
        return broken(XR_ERROR_LOCALIZED_NAME_INVALID, call, "no name for people");
    for (const auto& [number, set] : runtime().sets.all())
        if (set.name == info->actionSetName) return broken(XR_ERROR_NAME_DUPLICATED, call, set.name);
    *out = handle_of<XrActionSet>(runtime().sets.add({info->actionSetName, false}));
    return XR_SUCCESS;
}

XrResult destroy_set(XrActionSet handle) {
    const bool is_known = runtime().sets.erase(number_of(handle));
    if (!is_known) return broken(XR_ERROR_HANDLE_INVALID, "xrDestroyActionSet", "no such set");
    std::erase_if(runtime().actions.all(), [&](const auto& each) {
        return each.second.set == number_of(handle);
    });
    return XR_SUCCESS;
}

XrResult create_action(XrActionSet handle, const XrActionCreateInfo* info, XrAction* out) {
    const char* call = "xrCreateAction";
    const ActionSet* set = runtime().sets.find(number_of(handle));
    if (!set) return broken(XR_ERROR_HANDLE_INVALID, call, "no such set");
    if (set->is_attached) return broken(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, call, "the set is attached");
    if (!is_name(info->actionName)) return broken(XR_ERROR_PATH_FORMAT_INVALID, call, info->actionName);
    if (info->localizedActionName[0] == '\0')
        return broken(XR_ERROR_LOCALIZED_NAME_INVALID, call, "no name for people");
    Action action{number_of(handle), info->actionName, info->actionType, {}};
    for (const auto& [number, each] : runtime().actions.all())
        if (each.set == action.set && each.name == action.name)
            return broken(XR_ERROR_NAME_DUPLICATED, call, action.name);
    for (std::uint32_t i = 0; i < info->countSubactionPaths; ++i) {
        if (side_of(text_of(info->subactionPaths[i])) > 1)
            return broken(XR_ERROR_PATH_UNSUPPORTED, call, text_of(info->subactionPaths[i]));
        action.subactions.push_back(info->subactionPaths[i]);
    }
    *out = handle_of<XrAction>(runtime().actions.add(std::move(action)));
    return XR_SUCCESS;
}

XrResult destroy_action(XrAction handle) {
    const bool is_known = runtime().actions.erase(number_of(handle));
    return is_known ? XR_SUCCESS : broken(XR_ERROR_HANDLE_INVALID, "xrDestroyAction", "no such action");
}

bool suits(XrActionType type, const std::string& path) {
    const bool is_pose = path.size() > 5 && path.compare(path.size() - 5, 5, "/pose") == 0;
    const bool is_output = path.find("/output/") != std::string::npos;
    if (type == XR_ACTION_TYPE_POSE_INPUT) return is_pose;
    if (type == XR_ACTION_TYPE_VIBRATION_OUTPUT) return is_output;
    return !is_pose && !is_output;
}

XrResult suggest(XrInstance, const XrInteractionProfileSuggestedBinding* info) {
    Instance& instance = *only_instance();
    if (instance.is_lost) return XR_ERROR_INSTANCE_LOST;
    if (instance.has_attached) return broken(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, kSuggest, "too late");
    const std::string profile = text_of(info->interactionProfile);
    if (!is_profile(profile)) return broken(XR_ERROR_PATH_UNSUPPORTED, kSuggest, profile);
    std::vector<Binding> bindings;
    for (std::uint32_t i = 0; i < info->countSuggestedBindings; ++i) {
        const XrActionSuggestedBinding& each = info->suggestedBindings[i];
        const Action* action = runtime().actions.find(number_of(each.action));
        const std::string path = text_of(each.binding);
        if (!action) return broken(XR_ERROR_HANDLE_INVALID, kSuggest, "no such action");
        if (!has_path(profile, path) || !suits(action->type, path))
            return broken(XR_ERROR_PATH_UNSUPPORTED, kSuggest, profile + " " + path);
        bindings.push_back({number_of(each.action), path});
    }
    instance.suggested[profile] = std::move(bindings);
    return XR_SUCCESS;
}

XrResult attach(XrSession handle, const XrSessionActionSetsAttachInfo* info) {
    Session* session = runtime().sessions.find(number_of(handle));
    const char* call = "xrAttachSessionActionSets";
    if (const XrResult result = check(session, call); result != XR_SUCCESS) return result;
    if (only_instance()->has_attached && !session->profiles[0].empty())
        return broken(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, call, "twice");
    for (std::uint32_t i = 0; i < info->countActionSets; ++i) {
        ActionSet* set = runtime().sets.find(number_of(info->actionSets[i]));
        if (!set) return broken(XR_ERROR_HANDLE_INVALID, call, "no such set");
        set->is_attached = true;
    }
    only_instance()->has_attached = true;
    tell_changed_profiles(*session);
    return XR_SUCCESS;
}

}  // namespace

std::size_t side_of(const std::string& path) {
    if (path.rfind("/user/hand/left", 0) == 0) return 0;
    return path.rfind("/user/hand/right", 0) == 0 ? 1 : 2;
}

std::string active_profile(std::size_t side) {
    if (side > 1) return {};
    const Instance& instance = *only_instance();
    const Hand& hand = runtime().world.hands[side];
    const bool is_held = instance.has_attached && !hand.is_bare && instance.suggested.count(hand.profile);
    return is_held ? hand.profile : std::string();
}

void tell_changed_profiles(Session& session) {
    bool has_changed = false;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::string now = active_profile(side);
        has_changed |= now != session.profiles[side];
        session.profiles[side] = now;
    }
    if (!has_changed) return;
    XrEventDataInteractionProfileChanged event{};
    event.type = XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED;
    event.session = handle_of<XrSession>(runtime().sessions.all().begin()->first);
    post(&event, sizeof event);
}

std::span<const Entry> action_calls() {
    static const std::array kCalls{
        entry<PFN_xrCreateActionSet>("xrCreateActionSet", create_set),
        entry<PFN_xrDestroyActionSet>("xrDestroyActionSet", destroy_set),
        entry<PFN_xrCreateAction>("xrCreateAction", create_action),
        entry<PFN_xrDestroyAction>("xrDestroyAction", destroy_action),
        entry<PFN_xrSuggestInteractionProfileBindings>(kSuggest, suggest),
        entry<PFN_xrAttachSessionActionSets>("xrAttachSessionActionSets", attach),
    };
    return kCalls;
}

}  // namespace feelem::xr_runtime
