// SPDX-License-Identifier: Apache-2.0
// A session in the context of a window (GLX), under the validation layer of the OpenXR project where it is
// installed.
#include "support/paths.hpp"
#include "viewer/desktop/virtual_screen.hpp"
#include "viewer/desktop/window.hpp"
#include "viewer/xr/stay.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace feelem::viewer {

namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kLayer =
    "/usr/share/openxr/1/api_layers/explicit.d/XrApiLayer_core_validation.x86_64-linux-gnu.json";

class XrWindow : public testing::Test {
protected:
    void SetUp() override {
        const std::string& why = test::virtual_screen();
        if (!why.empty()) GTEST_SKIP() << why;
        window =
            std::make_unique<Window>(WindowOptions{.title = "XR", .width = 64, .height = 64, .vsync = false});
        window->make_current();
    }
    std::unique_ptr<Window> window;
};

/// All that a session does: frames, a panel, hands, pulses, its end and the next one.
void live(Stay& stay) {
    unsigned texture = texture_of(32, 32, {1, 2, 3, 255});
    XrQuad quad;
    quad.texture = texture;
    quad.width = quad.height = 32;
    stay.draw = [](const XrFrame& frame) { fill_eyes(frame, {{{200, 100, 50, 255}, {10, 20, 30, 255}}}); };
    stay.pictures = [&] { return XrPictures{{&quad, 1}, XrDepth{0.02F, 200}}; };
    ASSERT_TRUE(stay.reach(XrState::Focused));
    ASSERT_TRUE(stay.frames(20));
    EXPECT_TRUE(stay.system->haptics(Side::Left).pulse(0.5, 35));
    stay.system->haptics(Side::Left).stop();
    stay.system->recentre();
    ASSERT_TRUE(stay.frames(20));
    ASSERT_TRUE(stay.reach(XrState::Ended));
    stay.system->enter();
    ASSERT_TRUE(stay.reach(XrState::Focused));
    stay.end();
}

TEST_F(XrWindow, session_lives_in_the_context_of_a_window) {
    Stay stay(Stay::InCurrentContext{}, "0 hand right 0.5 0\n60 exit");
    live(stay);
    EXPECT_EQ(stay.record("graphics").at(0)["graphics"], "glx");
    EXPECT_THAT(stay.record("layers").back()["layers"][0].dump(), HasSubstr("[200,100,50,255]"));
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

/// The layer writes its report where it finds something.
class XrValidation : public XrWindow {
protected:
    void SetUp() override {
        XrWindow::SetUp();
        if (IsSkipped()) return;
        if (!std::filesystem::exists(kLayer))
            GTEST_SKIP() << "package openxr-layer-corevalidation is not installed";
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        report = feelem::test::scratch_folder("viewer_xr/validation_" + name) + "/report.txt";
        environment.set("XR_ENABLE_API_LAYERS", "XR_APILAYER_LUNARG_core_validation");
        environment.set("XR_CORE_VALIDATION_EXPORT_TYPE", "text");
        environment.set("XR_CORE_VALIDATION_FILE_NAME", report);
    }
    std::string report;
    Environment environment;
};

TEST_F(XrValidation, finds_nothing) {
    // The layer of 1.0.20 does not know the younger ways to shake a controller: see the next test.
    Stay stay(Stay::InCurrentContext{}, "0 hand right 0.5 0\n60 exit", "no_parametric no_envelope");
    live(stay);
    EXPECT_FALSE(std::filesystem::exists(report)) << feelem::test::read_file(report);
    EXPECT_THAT(stay.complaints(), IsEmpty());
}

TEST_F(XrValidation, layer_that_refuses_young_extensions_does_not_keep_us_out) {
    Stay stay(Stay::InCurrentContext{}, "");
    EXPECT_TRUE(stay.reach(XrState::Focused));
    EXPECT_TRUE(stay.frames(3));
    stay.end();
    EXPECT_THAT(feelem::test::read_file(report), HasSubstr("VUID-XrSystemProperties-next-next"));
}

}  // namespace

}  // namespace feelem::viewer
