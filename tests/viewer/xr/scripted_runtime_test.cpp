// SPDX-License-Identifier: Apache-2.0
// The scripted runtime itself: that it finds what a program does wrong, so that silence means something.
#include "viewer/xr/stay.hpp"

#include <gmock/gmock.h>
#include <openxr/openxr.h>

namespace feelem::viewer {

namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

template <class Structure>
Structure typed(XrStructureType type) {
    Structure structure{};
    structure.type = type;
    return structure;
}

/// A program without pictures that makes its calls by hand.
class ScriptedRuntime : public NeedsOpenGl {
protected:
    void SetUp() override {
        NeedsOpenGl::SetUp();
        if (IsSkipped()) return;
        stay.emplace("");
        stay->end();
        const char* extension = "XR_MND_headless";
        auto info = typed<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
        std::string("test").copy(info.applicationInfo.applicationName, 16);
        info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 20);
        info.enabledExtensionCount = 1;
        info.enabledExtensionNames = &extension;
        ASSERT_EQ(xrCreateInstance(&info, &instance), XR_SUCCESS);
        auto get = typed<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
        get.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
        auto create = typed<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
        ASSERT_EQ(xrGetSystem(instance, &get, &create.systemId), XR_SUCCESS);
        ASSERT_EQ(xrCreateSession(instance, &create, &session), XR_SUCCESS);
    }

    void TearDown() override {
        if (instance != XR_NULL_HANDLE) xrDestroyInstance(instance);
    }

    void begin() {
        auto info = typed<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
        info.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
        ASSERT_EQ(xrBeginSession(session, &info), XR_SUCCESS);
    }

    std::optional<Stay> stay;
    XrInstance instance = XR_NULL_HANDLE;
    XrSession session = XR_NULL_HANDLE;
};

TEST_F(ScriptedRuntime, finds_calls_out_of_order) {
    auto state = typed<XrFrameState>(XR_TYPE_FRAME_STATE);
    EXPECT_EQ(xrWaitFrame(session, nullptr, &state), XR_ERROR_SESSION_NOT_RUNNING);
    begin();
    EXPECT_EQ(xrBeginFrame(session, nullptr), XR_ERROR_CALL_ORDER_INVALID);
    auto end = typed<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
    EXPECT_EQ(xrEndFrame(session, &end), XR_ERROR_CALL_ORDER_INVALID);
    ASSERT_EQ(xrWaitFrame(session, nullptr, &state), XR_SUCCESS);
    ASSERT_EQ(xrBeginFrame(session, nullptr), XR_SUCCESS);
    end.displayTime = state.predictedDisplayTime;
    EXPECT_EQ(xrEndFrame(session, &end), XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED);
    end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    EXPECT_EQ(xrEndFrame(session, &end), XR_SUCCESS);
    EXPECT_EQ(xrEndSession(session), XR_ERROR_SESSION_NOT_STOPPING);

    EXPECT_EQ(stay->complaints().size(), 5U);
}

TEST_F(ScriptedRuntime, finds_what_is_left_behind) {
    auto info = typed<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
    XrSpace space = XR_NULL_HANDLE;
    EXPECT_EQ(xrCreateReferenceSpace(session, &info, &space), XR_ERROR_POSE_INVALID) << "no quaternion";
    info.poseInReferenceSpace.orientation.w = 1;
    ASSERT_EQ(xrCreateReferenceSpace(session, &info, &space), XR_SUCCESS);

    xrDestroyInstance(std::exchange(instance, XR_NULL_HANDLE));

    EXPECT_THAT(stay->complaints(), Contains(HasSubstr(R"("leaked_spaces":1)")));
    EXPECT_THAT(stay->complaints(), Contains(HasSubstr(R"("leaked_sessions":1)")));
}

TEST_F(ScriptedRuntime, refuses_a_binding_that_the_controller_has_not) {
    auto set_info = typed<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
    std::string("set").copy(set_info.actionSetName, 16);
    std::string("Set").copy(set_info.localizedActionSetName, 16);
    XrActionSet set = XR_NULL_HANDLE;
    ASSERT_EQ(xrCreateActionSet(instance, &set_info, &set), XR_SUCCESS);
    auto action_info = typed<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
    std::string("press").copy(action_info.actionName, 16);
    std::string("Press").copy(action_info.localizedActionName, 16);
    action_info.actionType = XR_ACTION_TYPE_BOOLEAN_INPUT;
    XrActionSuggestedBinding binding{};
    ASSERT_EQ(xrCreateAction(set, &action_info, &binding.action), XR_SUCCESS);
    auto suggestion =
        typed<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    xrStringToPath(instance, "/interaction_profiles/khr/simple_controller", &suggestion.interactionProfile);
    suggestion.countSuggestedBindings = 1;
    suggestion.suggestedBindings = &binding;

    xrStringToPath(instance, "/user/hand/left/input/select/click", &binding.binding);
    EXPECT_EQ(xrSuggestInteractionProfileBindings(instance, &suggestion), XR_SUCCESS);
    EXPECT_THAT(stay->complaints(), IsEmpty());
    xrStringToPath(instance, "/user/hand/left/input/trigger/value", &binding.binding);
    EXPECT_EQ(xrSuggestInteractionProfileBindings(instance, &suggestion), XR_ERROR_PATH_UNSUPPORTED);
    EXPECT_THAT(stay->complaints(), Not(IsEmpty()));
    xrDestroyActionSet(set);
    xrDestroySession(session);
}

TEST_F(ScriptedRuntime, says_what_line_of_a_script_it_does_not_know) {
    xrDestroyInstance(std::exchange(instance, XR_NULL_HANDLE));
    stay.emplace("3 dance left");
    ASSERT_TRUE(stay->frames(6));
    stay->end();
    EXPECT_THAT(stay->complaints(), Contains(HasSubstr("no verb 'dance'")));
}

}  // namespace

}  // namespace feelem::viewer
