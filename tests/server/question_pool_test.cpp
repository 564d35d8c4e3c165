// SPDX-License-Identifier: Apache-2.0
// Who is worked for, who waits, who is sent away, and who is given up.
#include "question_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <thread>

namespace feelem::test {
namespace {

using namespace std::chrono_literals;
using server::PoolLimits;
using server::QuestionPool;
using End = QuestionPool::End;

bool nobody_left() {
    return false;
}

/// Works until it is told to stop or nobody wants it.
struct Slow {
    std::atomic<int> begun = 0;
    std::atomic<bool> may_end = false;

    QuestionPool::Work work() {
        return [this](const QuestionPool::IsCancelled& is_cancelled) {
            ++begun;
            while (!may_end && !is_cancelled()) std::this_thread::sleep_for(1ms);
        };
    }
    void wait_for(int count) const {
        while (begun < count) std::this_thread::sleep_for(1ms);
    }
};

std::future<End> asked(
    QuestionPool& pool,
    Slow& slow,
    const std::string& client = "",
    std::function<bool()> is_gone = nobody_left
) {
    return std::async(std::launch::async, [&pool, work = slow.work(), client, is_gone] {
        return pool.ask(client, work, is_gone);
    });
}

TEST(QuestionPool, works_on_so_many_at_once_and_sends_away_who_finds_the_queue_full) {
    QuestionPool pool({2, 3, 30s});
    Slow slow;
    std::vector<std::future<End>> running;
    for (int i = 0; i < 2; ++i) running.push_back(asked(pool, slow));
    slow.wait_for(2);
    std::vector<std::future<End>> waiting;
    for (int i = 0; i < 20; ++i) waiting.push_back(asked(pool, slow));
    // Of twenty three wait; the others are told at once.
    int busy = 0;
    for (int tries = 0; tries < 500 && busy < 17; ++tries) {
        busy = 0;
        for (auto& one : waiting) busy += one.wait_for(0ms) == std::future_status::ready ? 1 : 0;
        std::this_thread::sleep_for(2ms);
    }
    EXPECT_EQ(busy, 17);
    EXPECT_EQ(slow.begun, 2);
    slow.may_end = true;
    int done = 0;
    for (auto& one : running) done += one.get() == End::Done ? 1 : 0;
    for (auto& one : waiting) done += one.get() == End::Done ? 1 : 0;
    EXPECT_EQ(done, 5);
}

TEST(QuestionPool, gives_up_what_the_same_client_has_asked_before) {
    QuestionPool pool({1, 8, 30s});
    Slow first, second, third, fourth;
    auto running = asked(pool, first, "a");
    first.wait_for(1);
    // Who waits is asked whether somebody is still there: from then on it is in the queue.
    std::atomic<bool> is_queued = false;
    auto other = asked(pool, second, "b", [&] {
        is_queued = true;
        return false;
    });
    while (!is_queued) std::this_thread::sleep_for(1ms);
    auto waiting = asked(pool, third, "a");
    EXPECT_EQ(running.get(), End::Superseded);
    second.wait_for(1);
    auto newest = asked(pool, fourth, "a");
    EXPECT_EQ(waiting.get(), End::Superseded);
    EXPECT_EQ(third.begun, 0) << "what waited and was superseded is not begun";
    second.may_end = fourth.may_end = true;
    EXPECT_EQ(other.get(), End::Done);
    EXPECT_EQ(newest.get(), End::Done);
}

TEST(QuestionPool, gives_up_what_nobody_waits_for) {
    QuestionPool pool({1, 8, 30s});
    Slow slow;
    std::atomic<bool> is_gone = false;
    auto running = asked(pool, slow, "", [&] { return is_gone.load(); });
    slow.wait_for(1);
    auto waiting = asked(pool, slow, "", [&] { return is_gone.load(); });
    is_gone = true;
    EXPECT_EQ(running.get(), End::Gone);
    EXPECT_EQ(waiting.get(), End::Gone);
}

TEST(QuestionPool, has_an_end_of_time) {
    QuestionPool pool({1, 8, 50ms});
    Slow slow;
    EXPECT_EQ(pool.ask("", slow.work(), nobody_left), End::TooLong);
}

TEST(QuestionPool, hands_on_what_is_thrown_and_goes_on) {
    QuestionPool pool({1, 8, 30s});
    const auto bad = [](const QuestionPool::IsCancelled&) { throw std::runtime_error("bad"); };
    EXPECT_THROW(pool.ask("a", bad, nobody_left), std::runtime_error);
    EXPECT_EQ(
        pool.ask(
            "a", [](const auto&) {}, nobody_left
        ),
        End::Done
    );
}

TEST(QuestionPool, ends_with_questions_on_their_way) {
    Slow slow;
    std::vector<std::future<End>> asking;
    {
        QuestionPool pool({1, 8, 30s});
        asking.push_back(asked(pool, slow));
        slow.wait_for(1);
        // The pool outlives those who ask; here they are told to go first, as the front door does.
        slow.may_end = true;
        EXPECT_EQ(asking.front().get(), End::Done);
    }
}

}  // namespace
}  // namespace feelem::test
