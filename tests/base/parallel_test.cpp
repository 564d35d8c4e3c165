// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace feelem {
namespace {

TEST(OrderedChunks, are_taken_in_order_with_a_slot_of_their_own_by_any_number_of_threads) {
    for (const unsigned threads : {1U, 2U, 5U}) {
        set_thread_count(threads);
        std::vector<std::size_t> slots(ordered_slots()), taken;
        ordered_chunks(
            slots.size(),
            500,
            [&](std::size_t i, std::size_t slot) {
                volatile std::size_t idle = 0;
                for (std::size_t k = 0; k < (i % 7) * 1000; ++k) idle = idle + k;
                slots.at(slot) = 3 * i;
            },
            [&](std::size_t i, std::size_t slot) {
                EXPECT_EQ(slots.at(slot), 3 * i) << "another chunk used the slot";
                taken.push_back(i);
            }
        );
        std::vector<std::size_t> all(500);
        std::iota(all.begin(), all.end(), 0U);
        EXPECT_EQ(taken, all);
    }
    set_thread_count(0);
}

TEST(OneThreadFewer, leaves_at_least_one) {
    set_thread_count(2);
    {
        const OneThreadFewer fewer;
        EXPECT_EQ(thread_count(), 1u);
        EXPECT_EQ(ordered_slots(), 1u);
        const OneThreadFewer still;
        EXPECT_EQ(thread_count(), 1u);
    }
    EXPECT_EQ(thread_count(), 2u);
    set_thread_count(0);
}

TEST(OrderedChunks, of_one_slot_stay_in_this_thread_when_another_one_is_given_back) {
    set_thread_count(2);
    auto fewer = std::make_unique<OneThreadFewer>();
    const std::size_t slots = ordered_slots();
    ASSERT_EQ(slots, 1u);
    fewer.reset();
    const std::thread::id here = std::this_thread::get_id();
    ordered_chunks(
        slots,
        200,
        [&](std::size_t, std::size_t slot) {
            EXPECT_EQ(slot, 0u);
            EXPECT_EQ(std::this_thread::get_id(), here);
        },
        [](std::size_t, std::size_t slot) { EXPECT_EQ(slot, 0u); }
    );
    set_thread_count(0);
}

TEST(ParallelChunks, that_are_not_shared_stay_in_this_thread_and_in_order) {
    set_thread_count(2);
    const std::thread::id here = std::this_thread::get_id();
    std::vector<std::size_t> seen;
    parallel_chunks_if(false, 1003, 5, [&](std::size_t first, std::size_t last) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        for (std::size_t i = first; i < last; ++i) seen.push_back(i);
    });
    std::vector<std::size_t> all(1003);
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_EQ(seen, all);
    set_thread_count(0);
}

TEST(OrderedChunks, end_with_what_a_chunk_throws) {
    set_thread_count(3);
    std::size_t taken = 0;
    EXPECT_THROW(
        ordered_chunks(
            ordered_slots(),
            100,
            [](std::size_t, std::size_t) {},
            [&](std::size_t i, std::size_t) {
                if (i == 40) throw std::runtime_error("40");
                ++taken;
            }
        ),
        std::runtime_error
    );
    EXPECT_EQ(taken, 40u);
    ordered_chunks(
        4, 0, [](std::size_t, std::size_t) { FAIL(); }, [](std::size_t, std::size_t) { FAIL(); }
    );
    set_thread_count(0);
}

}  // namespace
}  // namespace feelem
