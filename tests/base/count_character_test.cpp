// SPDX-License-Identifier: Apache-2.0
#include "base/count_character.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace feelem {
namespace {

TEST(CountCharacter, says_what_looking_at_each_says) {
    std::mt19937 random(8);
    for (int i = 0; i < 400; ++i) {
        std::string text(random() % 10'000, '\n');  // More than a byte counts in each place.
        if (i % 2 == 0) std::ranges::generate(text, [&] { return static_cast<char>(random() % 256); });
        for (const char wanted : {'\n', '\0', '\xFF'})
            EXPECT_EQ(
                count_character(text, wanted), static_cast<std::size_t>(std::ranges::count(text, wanted))
            );
    }
}

}  // namespace
}  // namespace feelem
