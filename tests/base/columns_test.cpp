// SPDX-License-Identifier: Apache-2.0
// Many columns at once say what one after the other says, on any processor.
#include "base/columns.hpp"
#include "base/number.hpp"
#include "base/wide_columns.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace feelem {
namespace {

/// In memory of its own size, so that a byte read outside it is noticed by the sanitizers.
struct Exact {
    explicit Exact(const std::string& text) : bytes(new char[text.size()]) {
        std::copy(text.begin(), text.end(), bytes.get());
    }
    std::unique_ptr<char[]> bytes;
};

TEST(Columns, of_integers_are_the_same_at_once_and_one_by_one) {
    std::mt19937_64 random(4);
    int good = 0, bad = 0;
    for (int i = 0; i < 60'000; ++i) {
        const std::size_t width = 8 + random() % 5, count = 1 + random() % 13;
        std::string text;
        std::vector<std::int64_t> wanted;
        for (std::size_t c = 0; c < count; ++c) {
            const auto number = static_cast<std::int64_t>(
                random() % std::array{10ULL, 10'000ULL, 100'000'000ULL}[random() % 3]
            );
            wanted.push_back(number);
            text += fmt::format("{:>{}}", number, width);
        }
        const bool damaged = i % 2 == 0;
        if (damaged) text[random() % text.size()] = static_cast<char>(random() % 256);
        const Exact exact(text);
        std::vector<std::int64_t> all(count, -1), each(count, -1);
        const bool found = columns_of_integers(exact.bytes.get(), width, count, all.data());
        ASSERT_EQ(found, columns_of_integers_portable(exact.bytes.get(), width, count, each.data())) << text;
        std::vector<std::uint32_t> short_all(count, 1), short_each(count, 1);
        ASSERT_EQ(found, columns_of_integers(exact.bytes.get(), width, count, short_all.data())) << text;
        ASSERT_EQ(found, columns_of_integers_portable(exact.bytes.get(), width, count, short_each.data()))
            << text;
        (found ? good : bad) += 1;
        ASSERT_TRUE(found || damaged) << text;
        if (!found) continue;
        ASSERT_EQ(all, each) << text;
        ASSERT_TRUE(std::ranges::equal(all, short_all)) << text;
        ASSERT_EQ(short_all, short_each) << text;
        ASSERT_TRUE(damaged || all == wanted) << text;
        std::vector<std::uint32_t> small(count, 0), small_each(count, 0);
        ASSERT_TRUE(columns_of_integers(exact.bytes.get(), width, count, small.data())) << text;
        ASSERT_TRUE(columns_of_integers_portable(exact.bytes.get(), width, count, small_each.data())) << text;
        ASSERT_EQ(small, small_each) << text;
        ASSERT_TRUE(std::ranges::equal(small, all)) << text;
    }
    EXPECT_GT(good, 30'000);
    EXPECT_GT(bad, 10'000);
}

TEST(Columns, of_integers_refuse_what_is_no_number) {
    for (const char* column :
         {"        ", "      -1", "1234567 ", " 12 4567", "   1.500", "   1234x", "\t      1"}) {
        std::string text;
        for (int c = 0; c < 5; ++c) text += "       7";
        for (std::size_t c = 0; c < 5; ++c) {
            std::string row = text;
            row.replace(8 * c, 8, column);
            std::array<std::int64_t, 5> out{};
            EXPECT_FALSE(columns_of_integers(row.data(), 8, 5, out.data())) << row;
            EXPECT_FALSE(columns_of_integers_portable(row.data(), 8, 5, out.data())) << row;
            std::array<std::uint32_t, 5> short_out{};
            EXPECT_FALSE(columns_of_integers(row.data(), 8, 5, short_out.data())) << row;
        }
    }
}

TEST(Columns, three_reals_are_the_nearest_doubles) {
    if (!has_fast_columns()) GTEST_SKIP() << "this processor takes the other way";
    std::mt19937_64 random(6);
    int known = 0;
    for (int i = 0; i < 200'000; ++i) {
        std::string text;
        for (int c = 0; c < 3; ++c) {
            const std::string digits = fmt::format("{:014}", random() % 100'000'000'000'000ULL);
            const int exponent = static_cast<int>(random() % 24) - 10;
            text += fmt::format(
                "{}{}.{}E{}{:03}",
                random() % 2 == 0 ? '-' : ' ',
                digits[0],
                digits.substr(1),
                exponent < 0 ? '-' : '+',
                std::abs(exponent)
            );
        }
        if (i % 4 == 0) text[random() % text.size()] = static_cast<char>(random() % 256);
        const Exact exact(text);
        std::array<double, 3> out{}, wide{};
        const bool taken = narrow_three_reals_of_21(exact.bytes.get(), out.data());
        if (has_wide_columns()) {
            ASSERT_EQ(wide_three_reals_of_21(exact.bytes.get(), wide.data()), taken) << text;
            ASSERT_TRUE(!taken || std::memcmp(out.data(), wide.data(), sizeof out) == 0) << text;
        }
        if (!taken) continue;
        ++known;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto wanted = parse_double(text.substr(21 * c, 21));
            ASSERT_TRUE(wanted) << text;
            ASSERT_EQ(std::bit_cast<std::uint64_t>(out[c]), std::bit_cast<std::uint64_t>(*wanted)) << text;
        }
    }
    EXPECT_GT(known, 100'000);
}

TEST(Columns, three_reals_refuse_what_is_printed_otherwise) {
    const std::string good = " 1.0000000000000E+000";
    std::array<double, 3> out{};
    for (const char* other :
         {"+1.0000000000000E+000",
          "  1.000000000000E+000",
          " 1.0000000000000D+000",
          " 1.0000000000000E 000",
          " 1.0000000000000E+100",
          " 1.0000000000000E+0 0",
          " 1.0000000000000E-010",
          " 1.0000000000000E+014",
          " 1,0000000000000E+000",
          " .10000000000000E+000",
          "                     ",
          " 0.0000000000000+0000",
          "-1.000000000000 E+000"}) {
        for (std::size_t c = 0; c < 3; ++c) {
            std::string row = good + good + good;
            row.replace(21 * c, 21, other);
            EXPECT_FALSE(three_reals_of_21(row.data(), out.data())) << row;
            EXPECT_FALSE(narrow_three_reals_of_21(row.data(), out.data())) << row;
        }
    }
}

/// A real as Fortran's G prints it in a column: before the point at most `digits` of them, or an exponent.
std::string general_column(std::mt19937_64& random, std::size_t width) {
    const std::size_t digits = width - 7;
    std::string all;
    for (std::size_t i = 0; i < digits; ++i) all += static_cast<char>('0' + random() % 10);
    const bool has_exponent = random() % 3 == 0;
    const std::size_t before = has_exponent ? 0 : random() % (digits + 1);
    std::string text = (random() % 2 == 0 ? "-" : "") + (before == 0 ? "0" : all.substr(0, before)) + "." +
                       all.substr(before, digits - before);
    text += has_exponent ? fmt::format("E{}{:02}", random() % 2 == 0 ? '-' : '+', random() % 12) : "    ";
    return fmt::format("{:>{}}", text, width);
}

template <class Real>
void expect_columns_as_one_by_one(std::size_t width, unsigned seed) {
    std::mt19937_64 random(seed);
    int good = 0, refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        const std::size_t count = 1 + random() % 7;
        std::string text(kBeforeReals, '7');
        std::vector<std::uint32_t> offsets;
        for (std::size_t c = 0; c < count; ++c) {
            if (random() % 4 == 0) text += "9 ";  // As between the rows of a list.
            offsets.push_back(static_cast<std::uint32_t>(text.size() - kBeforeReals));
            text += general_column(random, width);
        }
        if (i % 3 == 0) {
            constexpr std::string_view kOdd = "0123456789.-+E \n*";
            text[kBeforeReals + random() % (text.size() - kBeforeReals)] = kOdd[random() % kOdd.size()];
        }
        const Exact exact(text);
        std::vector<Real> all(count);
        const char* columns = exact.bytes.get() + kBeforeReals;
        if (!columns_of_reals(columns, offsets, width, all.data())) {
            ++refused;
            continue;
        }
        ++good;
        for (std::size_t c = 0; c < count; ++c) {
            std::string_view column(columns + offsets[c], width);
            column.remove_prefix(std::min(column.find_first_not_of(' '), width));
            column = column.substr(0, column.find(' '));
            Real wanted = 0;
            if constexpr (sizeof(Real) == sizeof(float))
                wanted = parse_float(column).value();
            else
                wanted = parse_double(column).value();
            ASSERT_EQ(std::memcmp(&wanted, &all[c], sizeof(Real)), 0) << column << " in " << text;
            ASSERT_TRUE(columns[offsets[c]] == ' ' || columns[offsets[c]] == '-');
        }
    }
    if (!has_fast_columns()) return;
    EXPECT_GT(good, 12'000);
    EXPECT_GT(refused, 2'000);
}

TEST(Columns, of_reals_say_what_each_says_alone_or_refuse) {
    for (const std::size_t width : {12U, 13U, 16U, 19U, 20U}) {
        expect_columns_as_one_by_one<float>(width, 11);
        expect_columns_as_one_by_one<double>(width, 12);
    }
}

TEST(Columns, of_reals_take_every_form_that_fortran_prints) {
    if (!has_fast_columns()) GTEST_SKIP() << "the processor reads them one by one";
    const std::string text = "       -0.12345E-02  0.0000     -123.45      99999.     0.10000E+04";
    std::array<float, 5> values{};
    constexpr std::array<std::uint32_t, 5> kOffsets{0, 12, 24, 36, 48};
    ASSERT_TRUE(columns_of_reals(text.data() + 7, kOffsets, 12, values.data()));
    EXPECT_EQ(values, (std::array<float, 5>{-0.0012345F, 0.0F, -123.45F, 99999.0F, 1000.0F}));
    for (const char* odd :
         {"0.12345E-02 ",
          "  1.2.3     ",
          "  12345     ",
          "    ****    ",
          "   -.-1     ",
          "            ",
          "  1 2.3     ",
          " 0.12345E-2 ",
          " 0.12345D-02",
          " 0.12345-102",
          "       .    ",
          " 0.12345E-40"}) {
        const std::string bad = std::string(7, ' ') + odd;
        EXPECT_FALSE(columns_of_reals(bad.data() + 7, std::span(kOffsets).first(1), 12, values.data()))
            << odd;
    }
    EXPECT_FALSE(columns_of_reals(text.data() + 7, {}, 12, values.data()));
}

TEST(Columns, three_reals_between_say_what_each_says_alone_or_refuse) {
    if (!has_fast_columns()) GTEST_SKIP() << "the processor reads them one by one";
    std::mt19937_64 random(21);
    int good = 0, refused = 0;
    for (int i = 0; i < 60'000; ++i) {
        std::array<std::string, 3> numbers;
        for (std::string& number : numbers) {
            const std::size_t digits = 1 + random() % 15, point = random() % (digits + 1);
            number = random() % 2 == 0 ? "-" : std::string(random() % 3, ' ');
            for (std::size_t k = 0; k < digits; ++k) {
                if (k == point) number += '.';
                number += static_cast<char>('0' + random() % 10);
            }
            if (point == digits) number += '.';
        }
        if (i % 4 == 0) {
            constexpr std::string_view kOdd = "0123456789.-+E, \n";
            std::string& number = numbers[random() % 3];
            number[random() % number.size()] = kOdd[random() % kOdd.size()];
        }
        const Exact exact("12345678901.3,7.," + numbers[0] + "," + numbers[1] + "," + numbers[2]);
        std::array<TextField, 3> fields{};
        const char* at = exact.bytes.get() + 17;
        for (std::size_t c = 0; c < 3; at += numbers[c].size() + 1, ++c)
            fields[c] = {at, at + numbers[c].size()};
        std::array<double, 3> values{};
        if (!three_reals_between(fields, values.data())) {
            ++refused;
            continue;
        }
        ++good;
        for (std::size_t c = 0; c < 3; ++c) {
            std::string_view number = numbers[c];
            number.remove_prefix(number.find_first_not_of(' '));
            const auto wanted = parse_double(number);
            ASSERT_TRUE(wanted && number.size() <= 15) << numbers[c];
            ASSERT_EQ(std::bit_cast<std::uint64_t>(*wanted), std::bit_cast<std::uint64_t>(values[c]))
                << numbers[c];
        }
    }
    EXPECT_GT(good, 15'000);
    EXPECT_GT(refused, 5'000);
}

TEST(Columns, three_reals_between_refuse_what_is_no_plain_number) {
    const std::string before = "1234567890123456,";
    std::array<double, 3> values{};
    const auto reads = [&](const std::string& number) {
        const std::string text = before + number + ",1.5,-2.5";
        const char* const at = text.data() + before.size();
        const char* const next = at + number.size() + 1;
        return three_reals_between({{{at, next - 1}, {next, next + 3}, {next + 4, next + 8}}}, values.data());
    };
    for (const char* plain : {"0.5", ".5", "5.", "-.5", "12345678901234."})
        EXPECT_EQ(reads(plain), has_fast_columns()) << plain;
    for (const char* odd :
         {"",
          ".",
          "-",
          "-.",
          "1",
          "1.5.",
          "1.5 ",
          "--1.5",
          "1-5.",
          "+1.5",
          "1.5E1",
          "1,5",
          "123456789012345.",
          "0.123456789012345"})
        EXPECT_FALSE(reads(odd)) << odd;
}

}  // namespace
}  // namespace feelem
