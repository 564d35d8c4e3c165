// SPDX-License-Identifier: Apache-2.0
// Carries out what the connection asks for, and gives frames while there is a session that runs.
#include "viewer/xr/xr_system.hpp"

#include "viewer/xr/connection.hpp"
#include "viewer/xr/controller_haptics.hpp"
#include "viewer/xr/session.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <future>
#include <utility>

namespace feelem::viewer {

namespace {

constexpr int kMostSteps = 12;  ///< Of the connection in one poll.

}  // namespace

struct XrSystem::Parts {
    XrOptions options;
    xr::Connection connection;
    XrStatus status;
    xr::GlCurrent gl;
    std::future<xr::InstanceTry> coming;  ///< An instance that is being made.
    xr::Instance instance;
    std::unique_ptr<xr::Actions> actions;
    xr::System system;
    std::unique_ptr<xr::Session> session;
    std::array<xr::ControllerHaptics, kSides> haptics;
    std::array<bool, kSides> was_refusal_told{};
    double time = 0;

    void drop_session();
    void drop_instance();
    void listen();
    void fail(const xr::Failure& failure);
    void hear(const XrEventDataBuffer& event);
    /// False: the step is under way, on another thread.
    bool take(xr::Step step);
    XrResult carry_out(xr::Step step);
    bool make_instance();
    void make_session();
    void tell();
    bool is_focused() const {
        return connection.phase == xr::Phase::Running && connection.shown == XR_SESSION_STATE_FOCUSED;
    }
    xr::ShakeWay way() const;
};

void XrSystem::Parts::drop_session() {
    for (auto& each : haptics) each.disconnect();
    session.reset();
    status.input.clear();
}

void XrSystem::Parts::drop_instance() {
    drop_session();
    actions.reset();
    if (instance.handle != XR_NULL_HANDLE) xrDestroyInstance(instance.handle);
    instance = {};
    gl.restore();
}

xr::ShakeWay XrSystem::Parts::way() const {
    if (instance.enabled.parametric && system.has_parametric) return xr::ShakeWay::Parametric;
    return instance.enabled.envelope ? xr::ShakeWay::Envelope : xr::ShakeWay::Vibration;
}

/// Not on this thread: a service that is just starting may keep the call for a while.
bool XrSystem::Parts::make_instance() {
    if (!coming.valid())
        coming = std::async(std::launch::async, xr::make_instance, options.application, gl.is_egl());
    if (coming.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    xr::InstanceTry made = coming.get();
    instance = std::move(made.instance);
    if (XR_SUCCEEDED(made.result)) {
        status.runtime = instance.runtime;
        try {
            actions = std::make_unique<xr::Actions>(instance.handle);
        } catch (const xr::Failure& failure) {
            made.result = failure.result;
            drop_instance();
        }
    }
    xr::answer(connection, xr::Step::MakeInstance, made.result, time);
    return true;
}

void XrSystem::Parts::make_session() {
    session = std::make_unique<xr::Session>(xr::SessionParts{&instance, system, actions.get(), &gl});
    for (const Side side : {Side::Left, Side::Right}) {
        const auto at = static_cast<std::size_t>(side);
        haptics[at].connect({session->handle(), actions->action(xr::Part::Shake), actions->hand(side), way()}
        );
        was_refusal_told[at] = false;
    }
}

XrResult XrSystem::Parts::carry_out(xr::Step step) {
    try {
        switch (step) {
        case xr::Step::Nothing:
        case xr::Step::MakeInstance: break;
        case xr::Step::FindHeadset:
            system = xr::find_headset(instance);
            status.headset = system.headset;
            break;
        case xr::Step::MakeSession: make_session(); break;
        case xr::Step::BeginSession: session->begin(); break;
        case xr::Step::EndSession: session->end(); break;
        case xr::Step::DropSession: drop_session(); break;
        case xr::Step::DropInstance: drop_instance(); break;
        }
    } catch (const xr::Failure& failure) {
        gl.restore();
        return failure.result;
    }
    return XR_SUCCESS;
}

bool XrSystem::Parts::take(xr::Step step) {
    if (step == xr::Step::MakeInstance) return make_instance();
    xr::answer(connection, step, carry_out(step), time);
    return true;
}

void XrSystem::Parts::listen() {
    if (instance.handle == XR_NULL_HANDLE) return;
    for (;;) {
        auto event = xr::typed<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
        const XrResult result = xrPollEvent(instance.handle, &event);
        if (result == XR_EVENT_UNAVAILABLE) return;
        if (XR_FAILED(result)) return xr::fail(connection, result, time);
        try {
            hear(event);
        } catch (const xr::Failure& failure) {
            fail(failure);
        }
    }
}

void XrSystem::Parts::fail(const xr::Failure& failure) {
    gl.restore();  // A call may take the context away and fail all the same.
    xr::fail(connection, failure.result, time);
}

void XrSystem::Parts::hear(const XrEventDataBuffer& event) {
    const auto* base = reinterpret_cast<const XrEventDataBaseHeader*>(&event);
    switch (base->type) {
    case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED: {
        const auto* changed = reinterpret_cast<const XrEventDataSessionStateChanged*>(base);
        // An event may outlive its session.
        if (session && changed->session == session->handle()) xr::hear(connection, changed->state, time);
        break;
    }
    case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING: xr::hear_loss(connection, time); break;
    case XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED:
        if (session) session->profiles_changed();
        break;
    case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING: {
        const auto* changed = reinterpret_cast<const XrEventDataReferenceSpaceChangePending*>(base);
        if (session && changed->referenceSpaceType == XR_REFERENCE_SPACE_TYPE_LOCAL) session->local_changed();
        break;
    }
    default: break;
    }
}

void XrSystem::Parts::tell() {
    xr::put_words(connection, status);
    status.is_asking = coming.valid();
    if (session) {
        status.input = session->input_name();
        session->take_quirks(status.quirks);
    }
    for (const Side side : {Side::Left, Side::Right}) {
        const auto at = static_cast<std::size_t>(side);
        if (!haptics[at].was_refused() || std::exchange(was_refusal_told[at], true)) continue;
        status.quirks.push_back(fmt::format(
            "The {} controller does not vibrate ({} was refused with OpenXR code {}): ticks stand in.",
            side == Side::Left ? "left" : "right",
            word(way()),
            static_cast<int>(haptics[at].refusal())
        ));
    }
}

XrSystem::XrSystem(XrOptions options) : parts_(std::make_unique<Parts>()) {
    // What the loader would print, the status says in words; who sets the variable sees both.
    ::setenv("XR_LOADER_DEBUG", "none", 0);
    parts_->connection.is_required = options.is_required;
    parts_->options = std::move(options);
    parts_->tell();
}

XrSystem::~XrSystem() {
    if (parts_->coming.valid()) parts_->instance = parts_->coming.get().instance;
    parts_->gl.restore();
    parts_->drop_instance();
}

const XrStatus& XrSystem::poll(double time) {
    Parts& parts = *parts_;
    parts.time = time;
    if (!parts.gl.is_there()) parts.gl = xr::GlCurrent::now();
    parts.listen();
    for (int i = 0; i < kMostSteps; ++i) {
        const xr::Step step = xr::next_step(parts.connection, time);
        if (step == xr::Step::Nothing || !parts.take(step)) break;
        parts.listen();
    }
    parts.tell();
    return parts.status;
}

const XrStatus& XrSystem::status() const noexcept {
    return parts_->status;
}

std::optional<XrFrame> XrSystem::begin_frame() {
    Parts& parts = *parts_;
    if (parts.connection.phase != xr::Phase::Running || parts.connection.owed != xr::Step::Nothing) return {};
    if (parts.connection.shown == XR_SESSION_STATE_STOPPING) return {};
    try {
        XrFrame frame = parts.session->begin_frame(parts.is_focused());
        frame.input.time = parts.time;
        for (std::size_t side = 0; side < kSides; ++side)
            frame.input.hands[side].can_vibrate =
                parts.haptics[side].offer(frame.input.hands[side].can_vibrate);
        return frame;
    } catch (const xr::Failure& failure) {
        parts.fail(failure);
        return {};
    }
}

void XrSystem::end_frame(const XrPictures& pictures) {
    if (!parts_->session) return;
    try {
        parts_->session->end_frame(pictures);
    } catch (const xr::Failure& failure) {
        parts_->fail(failure);
    }
}

HapticSink& XrSystem::haptics(Side side) noexcept {
    return parts_->haptics[static_cast<std::size_t>(side)];
}

void XrSystem::recentre() {
    if (parts_->session) parts_->session->recentre();
}

void XrSystem::leave() {
    Parts& parts = *parts_;
    if (parts.connection.phase != xr::Phase::Running) return xr::leave(parts.connection);
    try {
        parts.session->request_exit();
    } catch (const xr::Failure&) {
        xr::leave(parts.connection);  // It cannot be asked: we go.
    }
}

void XrSystem::enter() {
    xr::enter(parts_->connection, parts_->time);
}

}  // namespace feelem::viewer
