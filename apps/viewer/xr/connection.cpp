// SPDX-License-Identifier: Apache-2.0
// Transitions of the connection.
#include "viewer/xr/connection.hpp"

#include <algorithm>

namespace feelem::viewer::xr {

namespace {

bool is_no_runtime(XrResult result) {
    // A manifest that is missing or broken is as good as none.
    return result == XR_ERROR_RUNTIME_UNAVAILABLE || result == XR_ERROR_FILE_ACCESS_ERROR ||
           result == XR_ERROR_FILE_CONTENTS_INVALID;
}

bool is_about_graphics(XrResult result) {
    return result == XR_ERROR_EXTENSION_NOT_PRESENT || result == XR_ERROR_GRAPHICS_DEVICE_INVALID ||
           result == XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING ||
           result == XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED || result == XR_ERROR_API_VERSION_UNSUPPORTED ||
           result == XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED ||
           result == XR_ERROR_FORM_FACTOR_UNSUPPORTED;
}

void retry_in(Connection& connection, double time, double seconds) {
    connection.next_try = time + seconds;
}

void retry_slower(Connection& connection, double time) {
    retry_in(connection, time, std::min(kRetryLast, kRetryFirst + connection.tries));
    ++connection.tries;
}

/// Who lets go of the instance lets go of the session too, never the other way round.
void owe(Connection& connection, Step step) {
    if (connection.owed != Step::DropInstance) connection.owed = step;
}

void set_trouble(Connection& connection, Trouble trouble, XrResult result) {
    connection.trouble = trouble;
    connection.reason = result;
}

void give_up(Connection& connection, Trouble trouble, XrResult result, double time) {
    set_trouble(connection, trouble, result);
    if (connection.is_required)
        retry_in(connection, time, kRetryLast);
    else
        connection.next_try.reset();
}

void answer_instance(Connection& connection, XrResult result, double time) {
    if (XR_SUCCEEDED(result)) {
        connection.phase = Phase::NoSystem;
        connection.next_try = time;
    } else if (is_no_runtime(result)) {
        give_up(connection, Trouble::NoRuntime, result, time);
    } else if (is_about_graphics(result)) {
        give_up(connection, Trouble::NoGraphics, result, time);
    } else {
        if (connection.trouble != Trouble::ServiceStopped)
            set_trouble(connection, Trouble::NoService, result);
        retry_slower(connection, time);
    }
}

void answer_system(Connection& connection, XrResult result, double time) {
    if (XR_SUCCEEDED(result)) {
        connection.phase = Phase::NoSession;
        connection.next_try = time;
    } else if (result == XR_ERROR_FORM_FACTOR_UNAVAILABLE) {
        set_trouble(connection, Trouble::NoHeadset, result);
        retry_in(connection, time, kHeadsetPoll);
    } else if (is_about_graphics(result)) {
        give_up(connection, Trouble::NoGraphics, result, time);
    } else {
        fail(connection, XR_ERROR_INSTANCE_LOST, time);
    }
}

void answer_session(Connection& connection, XrResult result, double time) {
    if (XR_SUCCEEDED(result)) {
        connection.phase = Phase::Idle;
        connection.shown = XR_SESSION_STATE_IDLE;
        set_trouble(connection, Trouble::None, XR_SUCCESS);
        connection.tries = 0;
        return;
    }
    if (result == XR_ERROR_INSTANCE_LOST) return fail(connection, result, time);
    connection.phase = Phase::NoSystem;
    if (is_about_graphics(result)) return give_up(connection, Trouble::NoGraphics, result, time);
    set_trouble(connection, Trouble::Refused, result);
    retry_slower(connection, time);
}

}  // namespace

Step next_step(const Connection& connection, double time) {
    if (connection.owed != Step::Nothing) return connection.owed;
    const bool is_due = connection.next_try && time >= *connection.next_try;
    switch (connection.phase) {
    case Phase::NoInstance: return is_due ? Step::MakeInstance : Step::Nothing;
    case Phase::NoSystem: return is_due ? Step::FindHeadset : Step::Nothing;
    case Phase::NoSession: return is_due ? Step::MakeSession : Step::Nothing;
    case Phase::Idle: return connection.shown == XR_SESSION_STATE_READY ? Step::BeginSession : Step::Nothing;
    case Phase::Running:
        return connection.shown == XR_SESSION_STATE_STOPPING ? Step::EndSession : Step::Nothing;
    case Phase::Ended: break;
    }
    return Step::Nothing;
}

void answer(Connection& connection, Step step, XrResult result, double time) {
    switch (step) {
    case Step::Nothing: return;
    case Step::MakeInstance: return answer_instance(connection, result, time);
    case Step::FindHeadset: return answer_system(connection, result, time);
    case Step::MakeSession: return answer_session(connection, result, time);
    case Step::BeginSession:
    case Step::EndSession:
        if (XR_FAILED(result)) return fail(connection, result, time);
        connection.phase = step == Step::BeginSession ? Phase::Running : Phase::Idle;
        // What READY and STOPPING asked for is done; the next event says more.
        connection.shown = XR_SESSION_STATE_IDLE;
        return;
    case Step::DropSession:
    case Step::DropInstance:
        connection.owed = Step::Nothing;
        if (connection.phase == Phase::Ended) return;
        connection.phase = step == Step::DropSession ? Phase::NoSystem : Phase::NoInstance;
        connection.shown = XR_SESSION_STATE_UNKNOWN;
        return;
    }
}

void hear(Connection& connection, XrSessionState state, double time) {
    connection.shown = state;
    if (state == XR_SESSION_STATE_EXITING) leave(connection);
    if (state != XR_SESSION_STATE_LOSS_PENDING) return;
    set_trouble(connection, Trouble::LossPending, XR_SESSION_LOSS_PENDING);
    owe(connection, Step::DropSession);
    retry_in(connection, time, kRetryFirst);
}

void hear_loss(Connection& connection, double time) {
    set_trouble(connection, Trouble::LossPending, XR_ERROR_INSTANCE_LOST);
    owe(connection, Step::DropInstance);
    retry_in(connection, time, kRetryFirst);
}

void fail(Connection& connection, XrResult result, double time) {
    const bool is_instance = result == XR_ERROR_INSTANCE_LOST;
    const Trouble trouble = is_instance                       ? Trouble::ServiceStopped
                            : result == XR_ERROR_SESSION_LOST ? Trouble::SessionLost
                                                              : Trouble::Refused;
    set_trouble(connection, trouble, result);
    owe(connection, is_instance ? Step::DropInstance : Step::DropSession);
    retry_slower(connection, time);
}

void leave(Connection& connection) {
    connection.phase = Phase::Ended;
    owe(connection, Step::DropInstance);
    connection.next_try.reset();
}

void enter(Connection& connection, double time) {
    if (connection.phase == Phase::Ended) connection.phase = Phase::NoInstance;
    connection.tries = 0;
    if (connection.phase < Phase::Idle) connection.next_try = time;
}

XrState state_of(const Connection& connection) {
    if (connection.phase == Phase::Ended) return XrState::Ended;
    switch (connection.trouble) {
    case Trouble::NoRuntime: return XrState::NoRuntime;
    case Trouble::NoService:
    case Trouble::ServiceStopped: return XrState::NoService;
    case Trouble::NoHeadset: return XrState::NoHeadset;
    case Trouble::NoGraphics: return XrState::Unusable;
    case Trouble::None:
    case Trouble::Refused:
    case Trouble::SessionLost:
    case Trouble::LossPending: break;
    }
    if (connection.phase != Phase::Running || connection.owed != Step::Nothing) return XrState::Starting;
    switch (connection.shown) {
    case XR_SESSION_STATE_FOCUSED: return XrState::Focused;
    case XR_SESSION_STATE_VISIBLE: return XrState::Visible;
    default: return XrState::Asleep;
    }
}

}  // namespace feelem::viewer::xr
