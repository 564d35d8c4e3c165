// SPDX-License-Identifier: Apache-2.0
// The fast way through printed numbers gives the bits of the general one, or says that it does not know.
#include "base/number.hpp"
#include "base/plain_real.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>

namespace feelem {
namespace {

template <class Real>
std::optional<Real> scan(const std::string& text, std::size_t* length = nullptr) {
    const std::string padded = text + std::string(2 * kPlainReach, ' ');
    const char* at = padded.data();
    Real value{};
    if (!scan_plain_real(at, value)) {
        EXPECT_EQ(at, padded.data());
        return std::nullopt;
    }
    if (length != nullptr) *length = static_cast<std::size_t>(at - padded.data());
    return value;
}

/// Counts how often the fast way knew the answer.
struct Known {
    int doubles = 0, floats = 0;

    void expect_right(const std::string& text) {
        std::size_t length = 0;
        if (const auto value = scan<double>(text, &length)) {
            ++doubles;
            ASSERT_EQ(std::bit_cast<std::uint64_t>(*value), std::bit_cast<std::uint64_t>(*parse_double(text)))
                << text;
            ASSERT_EQ(length, text.size()) << text;
        }
        if (const auto value = scan<float>(text, &length)) {
            ++floats;
            ASSERT_EQ(std::bit_cast<std::uint32_t>(*value), std::bit_cast<std::uint32_t>(*parse_float(text)))
                << text;
            ASSERT_EQ(length, text.size()) << text;
        }
    }
};

TEST(PlainReal, random_numbers_of_any_length_are_rounded_once) {
    std::mt19937_64 random(1);
    Known known;
    for (std::size_t i = 0; i < 300'000; ++i) {
        const std::string before = std::to_string(random() % std::array{1U, 10U, 1000U, 10'000'000U}[i % 4]);
        std::string behind;
        for (std::uint64_t digits = random() % 16; digits > 0; --digits)
            behind += static_cast<char>('0' + random() % 10);
        std::string text = fmt::format("{}{}.{}", random() % 2 == 0 ? "-" : "", before, behind);
        if (random() % 2 == 0)
            text += fmt::format("E{}{:0{}}", random() % 2 == 0 ? '-' : '+', random() % 40, 2 + random() % 2);
        known.expect_right(text);
    }
    EXPECT_GT(known.doubles, 150'000);
    EXPECT_GT(known.floats, 150'000);
}

/// Rounded twice, these go wrong: numbers in the middle between two floats, and a digit beside it.
TEST(PlainReal, numbers_near_the_middle_between_two_floats_are_rounded_once) {
    std::mt19937_64 random(2);
    Known known;
    int in_the_middle = 0;
    for (int i = 0; i < 100'000; ++i) {
        const auto low = static_cast<float>(
            std::ldexp(static_cast<double>(random() % 16'777'216 + 1), static_cast<int>(random() % 40) - 40)
        );
        const float high = std::nextafter(low, std::numeric_limits<float>::infinity());
        const double middle = 0.5 * (static_cast<double>(low) + static_cast<double>(high));
        for (const int digits : {5, 8, 11, 13, 15}) {
            const std::string text = fmt::format("{:.{}E}", middle, digits);
            known.expect_right(text);
            if (*parse_double(text) == middle) ++in_the_middle;
        }
        // Half a unit of the last place of a float, printed in full.
        const std::string whole = fmt::format("{}.5", 8'388'608 + random() % 100'000);
        known.expect_right(whole);
        known.expect_right(whole + "00000001");
    }
    EXPECT_GT(in_the_middle, 50'000);
    EXPECT_GT(known.floats, 200'000);
}

TEST(PlainReal, numbers_at_the_edges_of_what_a_float_holds_are_left_or_right) {
    Known known;
    for (const char* text :
         {"0.0",
          "-0.0",
          "0.00000E+00",
          "-0.00000E-09",
          "1.17549435E-38",
          "1.17549421E-38",
          "1.0E-45",
          "3.4028235E+38",
          "3.4028236E+38",
          "3.5E+38",
          "9007199254740993.0",
          "9007199254740992.0",
          "4503599627370497.5",
          "1.0E+22",
          "1.0E+23",
          "123456.0E-22",
          ".5",
          "-.5",
          "5."})
        known.expect_right(text);
    EXPECT_GT(known.doubles, 5);
    EXPECT_TRUE(std::signbit(*scan<float>("-0.0")));
}

TEST(PlainReal, what_is_no_plain_number_is_left_to_the_general_way) {
    for (const char* text :
         {"",        "-",       ".",       "-.",        "1",         "12345678.5",
          "1.5D+02", "1.5-101", "1.5+101", "NaN",       "********",  "1.5E",
          "1.5E+",   "1.5E5",   "1.5E+5",  "1.5E+1234", "1.5E+05.1", "1.2345678901234567890",
          "1,5",     "1.5,",    "1.5x",    "+1.5",      "--1.5",     "1.5e+01"}) {
        EXPECT_EQ(scan<double>(text), std::nullopt) << text;
        EXPECT_EQ(scan<float>(text), std::nullopt) << text;
    }
    std::size_t length = 0;
    EXPECT_EQ(scan<double>("-0.24713E+007-0.73354E+006", &length), -2'471'300.0);
    EXPECT_EQ(length, 13u) << "a second number touches the first";
    EXPECT_EQ(scan<float>("1.5\n2.5"), 1.5F);
}

TEST(PlainReal, integers_of_seven_digits_are_read_where_they_stand) {
    for (const char* text : {"7", "42", "1234567"}) {
        const std::string padded = std::string(text) + "        ";
        const char* at = padded.data();
        std::int64_t value = 0;
        ASSERT_TRUE(scan_plain_integer(at, value));
        EXPECT_EQ(value, std::stoll(text));
        EXPECT_EQ(at - padded.data(), static_cast<std::ptrdiff_t>(std::string(text).size()));
    }
    for (const char* text : {"12345678", "-1", " 1", "x", "\x80\x81 "}) {
        const std::string padded = std::string(text) + "        ";
        const char* at = padded.data();
        std::int64_t value = 0;
        EXPECT_FALSE(scan_plain_integer(at, value)) << text;
    }
    for (unsigned digits = 0; digits <= 8; ++digits) {
        for (int c = 0; c < 256; ++c) {
            if (c >= '0' && c <= '9') continue;
            std::string text(8, '5');
            if (digits < 8) text[digits] = static_cast<char>(c);
            ASSERT_EQ(count_digits(load8(text.data())), digits) << c;
        }
    }
}

}  // namespace
}  // namespace feelem
