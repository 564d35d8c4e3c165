// SPDX-License-Identifier: Apache-2.0
#include "base/behind.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace feelem {
namespace {

TEST(Behind, does_tasks_in_their_order_on_another_thread) {
    std::vector<int> done;
    std::thread::id where;
    Behind behind(2);
    for (int i = 0; i < 100; ++i) {
        behind.add([&, i] {
            done.push_back(i);
            where = std::this_thread::get_id();
        });
    }
    behind.wait();
    ASSERT_EQ(done.size(), 100U);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
    EXPECT_NE(where, std::this_thread::get_id());
}

TEST(Behind, lets_no_more_wait_than_it_was_told) {
    std::atomic<bool> go = false;
    std::atomic<int> added = 0;
    Behind behind(3);
    std::thread adder([&] {
        for (int i = 0; i < 10; ++i) {
            behind.add([&] {
                while (!go) std::this_thread::yield();
            });
            ++added;
        }
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_LE(added, 4);  // Three wait, one is being done.
    go = true;
    adder.join();
    behind.wait();
    EXPECT_EQ(added, 10);
}

TEST(Behind, gives_back_what_a_task_threw_and_drops_those_behind_it) {
    int done = 0;
    Behind behind(4);
    behind.add([&] { ++done; });
    behind.add([] { throw std::runtime_error("full"); });
    for (int i = 0; i < 10; ++i) behind.add([&] { ++done; });
    EXPECT_THROW(behind.wait(), std::runtime_error);
    EXPECT_EQ(done, 1);
    behind.add([&] { ++done; });
    behind.wait();
    EXPECT_EQ(done, 2);
}

TEST(Behind, ends_after_its_last_task) {
    std::atomic<int> done = 0;
    {
        Behind behind(8);
        for (int i = 0; i < 8; ++i) behind.add([&] { ++done; });
    }
    EXPECT_EQ(done, 8);
    { const Behind never_asked(1); }
}

}  // namespace
}  // namespace feelem
