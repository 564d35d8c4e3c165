// SPDX-License-Identifier: Apache-2.0
// Fields of a text at once say what one after the other says, on any processor.
#include "base/number.hpp"
#include "base/text_fields.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {
namespace {

const std::string kBefore(kFieldReach, '9');

TEST(TextFields, ends_are_commas_and_line_ends) {
    std::mt19937 random(2);
    constexpr std::string_view kCharacters = "0123456789 ,,\n\n\r+-.;*";
    for (int round = 0; round < 2000; ++round) {
        std::string text;
        while (text.size() < 300) text += kCharacters[random() % kCharacters.size()];
        EXPECT_EQ(field_ends(text.data()), field_ends_portable(text.data()));
        FieldEnds ends(text.data(), text.data() + text.size());
        std::size_t from = 0;
        while (const char* end = ends.next()) {
            const std::size_t wanted = text.find_first_of(",\n", from);
            ASSERT_EQ(static_cast<std::size_t>(end - text.data()), wanted) << text;
            from = wanted + 1;
        }
        // Those of the last characters may be left, no others.
        EXPECT_GE(from + 64 + kFieldReach + 64, text.size());
    }
}

TEST(TextFields, of_whole_numbers_are_the_same_at_once_and_one_by_one) {
    std::mt19937 random(4);
    constexpr std::string_view kStrange = " \t,.-+x\r1";
    std::size_t good = 0, bad = 0;
    for (int round = 0; round < 60'000; ++round) {
        const std::size_t count = 1 + random() % 13;
        std::string text = kBefore;
        std::vector<std::pair<std::size_t, std::size_t>> places;
        for (std::size_t i = 0; i < count; ++i) {
            const auto number = random() % std::array{10U, 10'000U, 100'000'000U}[random() % 3];
            const std::string field = fmt::format("{:>{}}", number, random() % 12);
            places.emplace_back(text.size(), text.size() + field.size());
            text += field + ",";
        }
        if (round % 2 == 0) {
            const auto& [first, last] = places[random() % count];
            text[first + random() % (last - first)] = kStrange[random() % kStrange.size()];
        }
        std::vector<TextField> fields;
        bool plain = true;
        std::vector<std::uint32_t> wanted, at_once(count), one_by_one(count);
        for (const auto& [first, last] : places) {
            fields.push_back({text.data() + first, text.data() + last});
            const std::string field = text.substr(first, last - first);
            const std::size_t digits = std::min(field.find_first_not_of(' '), field.size());
            plain = plain && digits < field.size() && field.size() - digits <= kMostFieldDigits &&
                    field.find_first_not_of("0123456789", digits) == std::string::npos;
            wanted.push_back(static_cast<std::uint32_t>(parse_integer(field).value_or(0)));
        }
        ASSERT_EQ(whole_numbers_between(fields, at_once.data()), plain) << text;
        ASSERT_EQ(whole_numbers_between_portable(fields, one_by_one.data()), plain) << text;
        ++(plain ? good : bad);
        if (!plain) continue;
        ASSERT_EQ(at_once, wanted) << text;
        ASSERT_EQ(one_by_one, wanted) << text;
    }
    EXPECT_GT(good, 30'000U);
    EXPECT_GT(bad, 10'000U);
}

TEST(TextFields, that_are_empty_or_blank_are_refused) {
    const std::string text = kBefore + "1,,2,    ,3,4";
    const auto field = [&](std::size_t first, std::size_t last) {
        return TextField{&text[kBefore.size() + first], &text[kBefore.size() + last]};
    };
    std::array<std::uint32_t, 4> out{};
    for (const TextField odd : {field(2, 2), field(5, 9)}) {
        const std::array fields{field(0, 1), odd, field(3, 4), field(10, 11)};
        EXPECT_FALSE(whole_numbers_between(fields, out.data()));
        EXPECT_FALSE(whole_numbers_between_portable(fields, out.data()));
    }
}

}  // namespace
}  // namespace feelem
