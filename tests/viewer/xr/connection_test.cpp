// SPDX-License-Identifier: Apache-2.0
// The connection's transitions, without any runtime.
#include "viewer/xr/connection.hpp"

#include <gtest/gtest.h>

namespace feelem::viewer::xr {

namespace {

/// As after a stay has begun.
Connection running() {
    Connection connection;
    for (const Step step : {Step::MakeInstance, Step::FindHeadset, Step::MakeSession})
        answer(connection, step, XR_SUCCESS, 0);
    hear(connection, XR_SESSION_STATE_READY, 0);
    answer(connection, Step::BeginSession, XR_SUCCESS, 0);
    hear(connection, XR_SESSION_STATE_FOCUSED, 0);
    return connection;
}

TEST(XrConnection, leads_from_nothing_to_a_running_session) {
    Connection connection;
    EXPECT_EQ(state_of(connection), XrState::Starting);
    for (const Step step : {Step::MakeInstance, Step::FindHeadset, Step::MakeSession}) {
        ASSERT_EQ(next_step(connection, 0), step);
        answer(connection, step, XR_SUCCESS, 0);
    }
    EXPECT_EQ(next_step(connection, 0), Step::Nothing) << "the headset says when";
    hear(connection, XR_SESSION_STATE_READY, 0);
    ASSERT_EQ(next_step(connection, 0), Step::BeginSession);
    answer(connection, Step::BeginSession, XR_SUCCESS, 0);
    EXPECT_EQ(connection.phase, Phase::Running);
    EXPECT_EQ(next_step(connection, 0), Step::Nothing) << "it is begun once";
    EXPECT_EQ(state_of(running()), XrState::Focused);
}

TEST(XrConnection, waits_longer_each_time_up_to_five_seconds) {
    Connection connection;
    double time = 10;
    for (const double pause : {2.0, 3.0, 4.0, 5.0, 5.0}) {
        answer(connection, Step::MakeInstance, XR_ERROR_RUNTIME_FAILURE, time);
        EXPECT_EQ(next_step(connection, time + pause - 0.01), Step::Nothing) << pause;
        EXPECT_EQ(next_step(connection, time + pause), Step::MakeInstance) << pause;
        time += pause;
    }
}

TEST(XrConnection, asks_for_a_missing_runtime_only_where_a_headset_is_required) {
    for (const bool is_required : {false, true}) {
        Connection connection;
        connection.is_required = is_required;
        answer(connection, Step::MakeInstance, XR_ERROR_RUNTIME_UNAVAILABLE, 0);
        EXPECT_EQ(state_of(connection), XrState::NoRuntime);
        EXPECT_EQ(next_step(connection, 1000), is_required ? Step::MakeInstance : Step::Nothing);
    }
}

TEST(XrConnection, lets_go_of_what_is_lost_before_anything_else) {
    Connection session = running(), instance = running();
    fail(session, XR_ERROR_SESSION_LOST, 5);
    fail(instance, XR_ERROR_INSTANCE_LOST, 5);
    EXPECT_EQ(next_step(session, 5), Step::DropSession);
    EXPECT_EQ(next_step(instance, 5), Step::DropInstance);

    answer(session, Step::DropSession, XR_SUCCESS, 5);
    answer(instance, Step::DropInstance, XR_SUCCESS, 5);
    EXPECT_EQ(next_step(session, 6.9), Step::Nothing);
    EXPECT_EQ(next_step(session, 7), Step::FindHeadset);
    EXPECT_EQ(next_step(instance, 7), Step::MakeInstance);
    EXPECT_EQ(state_of(instance), XrState::NoService);
}

TEST(XrConnection, call_that_fails_for_another_reason_costs_the_session_not_the_runtime) {
    Connection connection = running();
    fail(connection, XR_ERROR_RUNTIME_FAILURE, 5);
    EXPECT_EQ(next_step(connection, 5), Step::DropSession);
    EXPECT_EQ(state_of(connection), XrState::Starting) << "but not focused";
}

TEST(XrConnection, instance_that_dies_while_the_headset_is_looked_for_is_let_go) {
    Connection connection;
    answer(connection, Step::MakeInstance, XR_SUCCESS, 0);
    answer(connection, Step::FindHeadset, XR_ERROR_INSTANCE_LOST, 0);
    EXPECT_EQ(next_step(connection, 0), Step::DropInstance);
}

TEST(XrConnection, who_leaves_stays_out_until_entering) {
    Connection connection = running();
    hear(connection, XR_SESSION_STATE_EXITING, 5);
    EXPECT_EQ(next_step(connection, 5), Step::DropInstance);
    answer(connection, Step::DropInstance, XR_SUCCESS, 5);
    EXPECT_EQ(next_step(connection, 1000), Step::Nothing);
    EXPECT_EQ(state_of(connection), XrState::Ended);

    enter(connection, 1000);
    EXPECT_EQ(next_step(connection, 1000), Step::MakeInstance);
}

TEST(XrConnection, instance_that_has_to_go_goes_though_the_session_is_lost_too) {
    Connection left = running(), ended = running();
    hear(left, XR_SESSION_STATE_EXITING, 5);
    hear(left, XR_SESSION_STATE_LOSS_PENDING, 5);
    EXPECT_EQ(next_step(left, 5), Step::DropInstance) << "else nobody would ever let go of it";
    hear_loss(ended, 5);
    fail(ended, XR_ERROR_SESSION_LOST, 5);
    EXPECT_EQ(next_step(ended, 5), Step::DropInstance);
}

TEST(XrConnection, entering_while_inside_changes_nothing) {
    Connection connection = running();
    enter(connection, 5);
    EXPECT_EQ(next_step(connection, 5), Step::Nothing);
    EXPECT_EQ(state_of(connection), XrState::Focused);
}

TEST(XrConnection, every_state_is_put_into_words) {
    for (const Trouble trouble :
         {Trouble::None,
          Trouble::NoRuntime,
          Trouble::NoService,
          Trouble::ServiceStopped,
          Trouble::NoHeadset,
          Trouble::NoGraphics,
          Trouble::Refused,
          Trouble::SessionLost,
          Trouble::LossPending}) {
        Connection connection;
        connection.trouble = trouble;
        XrStatus status;
        put_words(connection, status);
        EXPECT_FALSE(status.what.empty());
        EXPECT_EQ(status.what.back(), '.');
        EXPECT_EQ(status.why.empty(), trouble == Trouble::None);
        EXPECT_EQ(status.hint.empty(), trouble == Trouble::None);
        EXPECT_FALSE(word(status.state).empty());
    }
}

}  // namespace

}  // namespace feelem::viewer::xr
