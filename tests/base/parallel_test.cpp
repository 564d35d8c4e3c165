// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <vector>

namespace feelem {
namespace {

TEST(OrderedChunks, are_taken_in_order_with_a_slot_of_their_own_by_any_number_of_threads) {
    for (const unsigned threads : {1U, 2U, 5U}) {
        set_thread_count(threads);
        std::vector<std::size_t> slots(ordered_slots()), taken;
        ordered_chunks(
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

TEST(OrderedChunks, end_with_what_a_chunk_throws) {
    set_thread_count(3);
    std::size_t taken = 0;
    EXPECT_THROW(
        ordered_chunks(
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
        0, [](std::size_t, std::size_t) { FAIL(); }, [](std::size_t, std::size_t) { FAIL(); }
    );
    set_thread_count(0);
}

}  // namespace
}  // namespace feelem
