// SPDX-License-Identifier: Apache-2.0
// A small OpenXR program that says all it sees of a runtime as lines of JSON: the test of the test runtime.
// xr_probe [--seconds S] [--frames N] [--pulses N] [--reconnect]
#include "probe_session.hpp"

#include <chrono>
#include <string>
#include <thread>

namespace feelem::probe {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array<const char*, 9> kStateNames{
    "UNKNOWN", "IDLE", "READY", "SYNCHRONIZED", "VISIBLE", "FOCUSED", "STOPPING", "LOSS_PENDING", "EXITING"};

struct Wishes {
    double seconds = 4;
    int frames = 0;  // Of one session, then it leaves; 0: the time alone counts.
    int pulses = 0;
    bool reconnect = false;
};

void poll_events(Session& xr) {
    auto buffer = made<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
    for (;;) {
        buffer.type = XR_TYPE_EVENT_DATA_BUFFER;
        const XrResult result = xrPollEvent(xr.instance, &buffer);
        check(result, "xrPollEvent");
        if (result == XR_EVENT_UNAVAILABLE) return;
        if (buffer.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) continue;
        XrEventDataSessionStateChanged changed;
        std::memcpy(&changed, &buffer, sizeof changed);
        say(R"({{"event":"state","state":"{}"}})", kStateNames.at(static_cast<std::size_t>(changed.state)));
        xr.focused = changed.state == XR_SESSION_STATE_FOCUSED;
        if (changed.state == XR_SESSION_STATE_READY) {
            auto begin = made<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
            begin.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
            check(xrBeginSession(xr.session, &begin), "xrBeginSession");
            xr.runs = true;
        } else if (changed.state == XR_SESSION_STATE_STOPPING) {
            check(xrEndSession(xr.session), "xrEndSession");
            xr.runs = false;
        } else if (changed.state == XR_SESSION_STATE_EXITING) {
            xr.ended = true;
        }
    }
}

std::string words(const XrSpaceLocation& place) {
    const XrVector3f& p = place.pose.position;
    const XrQuaternionf& q = place.pose.orientation;
    const bool known = (place.locationFlags & XR_SPACE_LOCATION_POSITION_TRACKED_BIT) != 0;
    return fmt::format(
        R"({{"tracked":{},"position":[{},{},{}],"orientation":[{},{},{},{}]}})",
        known,
        p.x,
        p.y,
        p.z,
        q.x,
        q.y,
        q.z,
        q.w
    );
}

XrSpaceLocation locate(XrSpace what, XrSpace in, XrTime when) {
    auto place = made<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
    check(xrLocateSpace(what, in, when, &place), "xrLocateSpace");
    return place;
}

void report_input(const Session& xr, XrTime when, int frame) {
    const XrActiveActionSet active{xr.set, XR_NULL_PATH};
    auto sync = made<XrActionsSyncInfo>(XR_TYPE_ACTIONS_SYNC_INFO);
    sync.countActiveActionSets = 1;
    sync.activeActionSets = &active;
    check(xrSyncActions(xr.session, &sync), "xrSyncActions");
    std::string line =
        fmt::format(R"({{"event":"frame","n":{},"head":{})", frame, words(locate(xr.view, xr.local, when)));
    for (std::size_t i = 0; i < xr.hands.size(); ++i) {
        auto ask = made<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
        ask.action = xr.trigger;
        ask.subactionPath = xr.hands[i].path;
        auto pressed = made<XrActionStateFloat>(XR_TYPE_ACTION_STATE_FLOAT);
        check(xrGetActionStateFloat(xr.session, &ask, &pressed), "xrGetActionStateFloat");
        line += fmt::format(
            R"(,"{}":{},"{}_trigger":{})",
            kHandNames[i],
            words(locate(xr.hands[i].aim, xr.local, when)),
            kHandNames[i],
            pressed.currentState
        );
    }
    say("{}}}", line);
}

void pulse(const Session& xr, std::size_t hand, int n) {
    auto target = made<XrHapticActionInfo>(XR_TYPE_HAPTIC_ACTION_INFO);
    target.action = xr.touch;
    target.subactionPath = xr.hands[hand].path;
    auto shake = made<XrHapticVibration>(XR_TYPE_HAPTIC_VIBRATION);
    shake.amplitude = 0.1F * static_cast<float>(n % 10 + 1);
    shake.frequency = 160;
    shake.duration = (20 + n) * 1'000'000;
    check(
        xrApplyHapticFeedback(xr.session, &target, reinterpret_cast<const XrHapticBaseHeader*>(&shake)),
        "xrApplyHapticFeedback"
    );
    say(R"({{"event":"pulse","hand":"{}","frequency":{},"amplitude":{},"duration":{}}})",
        kHandNames[hand],
        shake.frequency,
        shake.amplitude,
        shake.duration);
}

void paint(const Session& xr, const Graphics& gl, std::size_t which) {
    const Eye& eye = xr.eyes[which];
    std::uint32_t index = 0;
    check(xrAcquireSwapchainImage(eye.chain, nullptr, &index), "xrAcquireSwapchainImage");
    auto wait = made<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
    wait.timeout = XR_INFINITE_DURATION;
    check(xrWaitSwapchainImage(eye.chain, &wait), "xrWaitSwapchainImage");
    eglMakeCurrent(gl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, gl.context);
    glBindFramebuffer(GL_FRAMEBUFFER, gl.target);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, eye.images.at(index), 0);
    glClearColor(0, which == 0 ? 1.0F : 0.0F, which == 0 ? 0.0F : 1.0F, 1);  // Left green, right blue.
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    check(xrReleaseSwapchainImage(eye.chain, nullptr), "xrReleaseSwapchainImage");
}

void end_frame(const Session& xr, const XrFrameState& state, bool painted) {
    std::array<XrView, 2> views{made<XrView>(XR_TYPE_VIEW), made<XrView>(XR_TYPE_VIEW)};
    auto ask = made<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
    ask.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    ask.displayTime = state.predictedDisplayTime;
    ask.space = xr.local;
    auto found = made<XrViewState>(XR_TYPE_VIEW_STATE);
    std::uint32_t count = 0;
    check(xrLocateViews(xr.session, &ask, &found, 2, &count, views.data()), "xrLocateViews");
    std::array<XrCompositionLayerProjectionView, 2> projected{};
    for (std::size_t i = 0; i < projected.size(); ++i) {
        projected[i].type = XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW;
        projected[i].pose = views[i].pose;
        projected[i].fov = views[i].fov;
        projected[i].subImage = {xr.eyes[i].chain, {{0, 0}, {xr.eyes[i].width, xr.eyes[i].height}}, 0};
    }
    auto layer = made<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
    layer.space = xr.local;
    layer.viewCount = projected.size();
    layer.views = projected.data();
    const std::array<const XrCompositionLayerBaseHeader*, 1> layers{
        reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer)};
    auto end = made<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
    end.displayTime = state.predictedDisplayTime;
    end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    end.layerCount = painted ? 1 : 0;
    end.layers = layers.data();
    check(xrEndFrame(xr.session, &end), "xrEndFrame");
}

struct Progress {
    int frames = 0, painted = 0, pulses = 0;
};

void run_frame(const Session& xr, const Graphics& gl, const Wishes& wishes, Progress& done) {
    auto state = made<XrFrameState>(XR_TYPE_FRAME_STATE);
    check(xrWaitFrame(xr.session, nullptr, &state), "xrWaitFrame");
    check(xrBeginFrame(xr.session, nullptr), "xrBeginFrame");
    report_input(xr, state.predictedDisplayTime, done.frames++);
    if (xr.focused && done.pulses < wishes.pulses && done.frames % 3 == 0) {
        pulse(xr, static_cast<std::size_t>(done.pulses % 2), done.pulses);
        ++done.pulses;
    }
    const bool painted = state.shouldRender == XR_TRUE;
    if (painted) {
        for (std::size_t i = 0; i < xr.eyes.size(); ++i) paint(xr, gl, i);
        ++done.painted;
    }
    end_frame(xr, state, painted);
}

/// Until the time is over or the runtime is lost, which throws.
void run_session(Session& xr, const Graphics& gl, const Wishes& wishes, Clock::time_point end) {
    create_instance(xr);
    create_session(xr, gl);
    create_actions(xr);
    create_eyes(xr);
    Progress done;
    bool asked_to_leave = false;
    while (!xr.ended && Clock::now() < end + std::chrono::seconds(5)) {
        poll_events(xr);
        if (xr.runs) {
            run_frame(xr, gl, wishes, done);
            const bool is_enough =
                wishes.frames > 0 && done.frames >= wishes.frames && done.pulses == wishes.pulses;
            if (!asked_to_leave && (is_enough || Clock::now() > end)) {
                check(xrRequestExitSession(xr.session), "xrRequestExitSession");
                asked_to_leave = true;
            }
        } else {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    say(R"({{"event":"end","frames":{},"painted":{},"pulses":{},"gl_error":{}}})",
        done.frames,
        done.painted,
        done.pulses,
        glGetError());
}

Wishes wishes_of(int count, char** words) {
    Wishes wishes;
    for (int i = 1; i < count; ++i) {
        const std::string_view word = words[i];
        if (word == "--reconnect") wishes.reconnect = true;
        if (word == "--seconds" && i + 1 < count) wishes.seconds = std::stod(words[++i]);
        if (word == "--frames" && i + 1 < count) wishes.frames = std::stoi(words[++i]);
        if (word == "--pulses" && i + 1 < count) wishes.pulses = std::stoi(words[++i]);
    }
    return wishes;
}

/// Exit code: 0 the runtime let go of the session, 1 the time was over first, 2 a call failed.
int run(const Wishes& wishes) {
    Graphics gl;
    if (!open(gl)) {
        say(R"({{"event":"failed","call":"EGL","result":{}}})", eglGetError());
        return 1;
    }
    const Clock::time_point end =
        Clock::now() + std::chrono::milliseconds(static_cast<long>(wishes.seconds * 1000));
    for (;;) {
        Session xr;
        try {
            run_session(xr, gl, wishes, end);
            xrDestroyInstance(xr.instance);
            say(R"({{"event":"bye","keepsake":{}}})", keepsake_is_kept(gl));
            return xr.ended ? 0 : 1;
        } catch (const Failed& failed) {
            say(R"({{"event":"failed","call":"{}","result":{},"keepsake":{}}})",
                failed.call,
                static_cast<int>(failed.result),
                keepsake_is_kept(gl));
            if (xr.instance != XR_NULL_HANDLE) xrDestroyInstance(xr.instance);
            if (!wishes.reconnect || Clock::now() > end) return 2;
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
        }
    }
}

}  // namespace
}  // namespace feelem::probe

int main(int count, char** words) {
    return feelem::probe::run(feelem::probe::wishes_of(count, words));
}
