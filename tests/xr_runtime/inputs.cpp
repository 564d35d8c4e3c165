// SPDX-License-Identifier: Apache-2.0
// What the hands do, as the program's actions see it after xrSyncActions.
#include "runtime.hpp"

#include <fmt/format.h>

namespace feelem::xr_runtime {

namespace {

XrResult sync(XrSession handle, const XrActionsSyncInfo* info) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, "xrSyncActions"); result != XR_SUCCESS) return result;
    for (std::uint32_t i = 0; i < info->countActiveActionSets; ++i) {
        const ActionSet* set = runtime().sets.find(number_of(info->activeActionSets[i].actionSet));
        if (!set || !set->is_attached)
            return broken(XR_ERROR_ACTIONSET_NOT_ATTACHED, "xrSyncActions", "the set is not attached");
    }
    session->is_synced = session->state == XR_SESSION_STATE_FOCUSED;
    if (!session->is_synced) return XR_SESSION_NOT_FOCUSED;
    session->hands = runtime().world.hands;
    return XR_SUCCESS;
}

struct Reading {
    bool is_active = false;
    float value = 0;
    XrVector2f pair{0, 0};
};

float input(const Hand& hand, const std::string& name) {
    const auto found = hand.inputs.find(name);
    return found == hand.inputs.end() ? 0 : found->second;
}

/// XR_SUCCESS and what the action is worth, over all that is bound to it in the hands that are asked for.
XrResult read(
    XrSession handle, const XrActionStateGetInfo& info, XrActionType type, const char* call, Reading& out
) {
    Session* session = runtime().sessions.find(number_of(handle));
    if (const XrResult result = check(session, call); result != XR_SUCCESS) return result;
    const Action* action = runtime().actions.find(number_of(info.action));
    if (!action) return broken(XR_ERROR_HANDLE_INVALID, call, "no such action");
    if (action->type != type) return broken(XR_ERROR_ACTION_TYPE_MISMATCH, call, action->name);
    for (std::size_t side = 0; session->is_synced && side < 2; ++side) {
        if (info.subactionPath != XR_NULL_PATH && side_of(text_of(info.subactionPath)) != side) continue;
        const std::string profile = active_profile(side);
        if (profile.empty()) continue;
        for (const Binding& binding : only_instance()->suggested[profile]) {
            if (binding.action != number_of(info.action) || side_of(binding.path) != side) continue;
            const std::string name = binding.path.substr(binding.path.find("/input/") + 7);
            const Hand& hand = session->hands[side];
            out.is_active = true;
            out.value = std::max(out.value, input(hand, name));
            out.pair = {input(hand, name + "/x"), input(hand, name + "/y")};
        }
    }
    return XR_SUCCESS;
}

XrResult get_boolean(XrSession session, const XrActionStateGetInfo* info, XrActionStateBoolean* out) {
    Reading reading;
    const XrResult result =
        read(session, *info, XR_ACTION_TYPE_BOOLEAN_INPUT, "xrGetActionStateBoolean", reading);
    out->isActive = reading.is_active;
    out->currentState = reading.value > 0.5F;
    return result;
}

XrResult get_float(XrSession session, const XrActionStateGetInfo* info, XrActionStateFloat* out) {
    Reading reading;
    const XrResult result =
        read(session, *info, XR_ACTION_TYPE_FLOAT_INPUT, "xrGetActionStateFloat", reading);
    out->isActive = reading.is_active;
    out->currentState = reading.value;
    return result;
}

XrResult get_pair(XrSession session, const XrActionStateGetInfo* info, XrActionStateVector2f* out) {
    Reading reading;
    const XrResult result =
        read(session, *info, XR_ACTION_TYPE_VECTOR2F_INPUT, "xrGetActionStateVector2f", reading);
    out->isActive = reading.is_active;
    out->currentState = reading.pair;
    return result;
}

XrResult get_pose(XrSession session, const XrActionStateGetInfo* info, XrActionStatePose* out) {
    Reading reading;
    const XrResult result = read(session, *info, XR_ACTION_TYPE_POSE_INPUT, "xrGetActionStatePose", reading);
    out->isActive = reading.is_active;
    return result;
}

XrResult get_profile(XrSession handle, XrPath hand, XrInteractionProfileState* out) {
    Session* session = runtime().sessions.find(number_of(handle));
    const char* call = "xrGetCurrentInteractionProfile";
    if (const XrResult result = check(session, call); result != XR_SUCCESS) return result;
    const std::size_t side = side_of(text_of(hand));
    if (side > 1) return broken(XR_ERROR_PATH_UNSUPPORTED, call, text_of(hand));
    const std::string& profile = session->profiles[side];
    out->interactionProfile = profile.empty() ? XR_NULL_PATH : path_of(profile);
    return XR_SUCCESS;
}

XrResult enumerate_sources(
    XrSession handle,
    const XrBoundSourcesForActionEnumerateInfo* info,
    std::uint32_t capacity,
    std::uint32_t* count,
    XrPath* out
) {
    const XrResult result =
        check(runtime().sessions.find(number_of(handle)), "xrEnumerateBoundSourcesForAction");
    if (result != XR_SUCCESS) return result;
    std::vector<XrPath> paths;
    for (std::size_t side = 0; side < 2; ++side)
        for (const Binding& binding : only_instance()->suggested[active_profile(side)])
            if (binding.action == number_of(info->action) && side_of(binding.path) == side)
                paths.push_back(path_of(binding.path));
    return give<XrPath>(paths, capacity, count, out);
}

XrResult source_name(
    XrSession,
    const XrInputSourceLocalizedNameGetInfo* info,
    std::uint32_t capacity,
    std::uint32_t* count,
    char* out
) {
    return give_text(text_of(info->sourcePath), capacity, count, out);
}

}  // namespace

std::span<const Entry> input_calls() {
    static const std::array kCalls{
        entry<PFN_xrSyncActions>("xrSyncActions", sync),
        entry<PFN_xrGetActionStateBoolean>("xrGetActionStateBoolean", get_boolean),
        entry<PFN_xrGetActionStateFloat>("xrGetActionStateFloat", get_float),
        entry<PFN_xrGetActionStateVector2f>("xrGetActionStateVector2f", get_pair),
        entry<PFN_xrGetActionStatePose>("xrGetActionStatePose", get_pose),
        entry<PFN_xrGetCurrentInteractionProfile>("xrGetCurrentInteractionProfile", get_profile),
        entry<PFN_xrEnumerateBoundSourcesForAction>("xrEnumerateBoundSourcesForAction", enumerate_sources),
        entry<PFN_xrGetInputSourceLocalizedName>("xrGetInputSourceLocalizedName", source_name),
    };
    return kCalls;
}

}  // namespace feelem::xr_runtime
