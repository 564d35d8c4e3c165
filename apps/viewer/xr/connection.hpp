// SPDX-License-Identifier: Apache-2.0
// How one comes to a headset and loses it again, as a state machine that calls nothing: it says what to do
// next, and is told what came of it.
#pragma once

#include "viewer/xr/xr_system.hpp"

#include <openxr/openxr.h>

namespace feelem::viewer::xr {

enum class Phase : std::uint8_t {
    NoInstance,
    NoSystem,
    NoSession,
    Idle,  ///< There is a session; it does not want frames.
    Running,
    Ended,
};

enum class Trouble : std::uint8_t {
    None,
    NoRuntime,
    NoService,
    ServiceStopped,
    NoHeadset,
    NoGraphics,  ///< Neither of our ways to draw, or no format that we can draw to.
    Refused,     ///< The session could not be made, for a reason of the runtime's.
    SessionLost,
    LossPending,
};

enum class Step : std::uint8_t {
    Nothing,
    MakeInstance,
    FindHeadset,
    MakeSession,
    BeginSession,
    EndSession,
    DropSession,
    DropInstance,  ///< With the session, if there is one.
};

struct Connection {
    Phase phase = Phase::NoInstance;
    Trouble trouble = Trouble::None;
    XrSessionState shown = XR_SESSION_STATE_UNKNOWN;  ///< As the last event had it.
    XrResult reason = XR_SUCCESS;                     ///< Of the trouble.
    std::optional<double> next_try = 0.0;             ///< Seconds; empty: not by itself.
    int tries = 0;
    bool is_required = false;
    Step owed = Step::Nothing;  ///< DropSession or DropInstance, before anything else.
};

inline constexpr double kRetryFirst = 2, kRetryLast = 5;  ///< Seconds; a second longer each time.
inline constexpr double kHeadsetPoll = 2;

Step next_step(const Connection& connection, double time);
/// What came of the step that next_step() gave.
void answer(Connection& connection, Step step, XrResult result, double time);
/// The runtime says so by an event.
void hear(Connection& connection, XrSessionState state, double time);
void hear_loss(Connection& connection, double time);
/// Any other call failed.
void fail(Connection& connection, XrResult result, double time);
/// The person wishes it: nothing is connected until enter().
void leave(Connection& connection);
void enter(Connection& connection, double time);

XrState state_of(const Connection& connection);
/// Sentences for people.
void put_words(const Connection& connection, XrStatus& status);

}  // namespace feelem::viewer::xr
