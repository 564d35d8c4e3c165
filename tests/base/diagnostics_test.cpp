// SPDX-License-Identifier: Apache-2.0
#include "feelem/diagnostics.hpp"
#include "feelem/error.hpp"

#include <gtest/gtest.h>

#include <set>

namespace feelem {
namespace {

TEST(Diagnostics, equal_texts_are_counted_and_the_first_place_is_kept) {
    Diagnostics diagnostics;
    int asked = 0;
    for (int i = 0; i < 3; ++i) {
        diagnostics.add(
            Code::UnknownNode, [&] { return "file:" + std::to_string(++asked); }, "text"
        );
    }

    ASSERT_EQ(diagnostics.entries().size(), 1U);
    EXPECT_EQ(diagnostics.entries()[0].count, 3U);
    EXPECT_EQ(diagnostics.entries()[0].where, "file:1");
    EXPECT_EQ(asked, 1);
}

TEST(Diagnostics, a_flood_of_different_texts_is_bounded_but_counted) {
    Diagnostics diagnostics;
    for (int i = 0; i < 1000; ++i) diagnostics.add(Code::BadNumber, std::string(), std::to_string(i));

    EXPECT_EQ(diagnostics.entries().size(), 200U);
    EXPECT_EQ(diagnostics.count(Code::BadNumber), 1000U);
}

TEST(Diagnostics, each_code_has_its_own_word) {
    std::set<std::string_view> words;
    for (const CodeInfo& info : code_table()) {
        EXPECT_TRUE(words.insert(info.word).second) << info.word;
        EXPECT_FALSE(info.meaning.empty()) << info.word;
    }
}

TEST(Error, says_where_and_what) {
    const Error error(Code::BadNumber, "a.frd:12", "found 'x'");

    EXPECT_STREQ(error.what(), "a.frd:12: found 'x'");
    EXPECT_EQ(error.code(), Code::BadNumber);
}

}  // namespace
}  // namespace feelem
