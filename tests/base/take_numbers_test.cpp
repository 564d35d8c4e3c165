// SPDX-License-Identifier: Apache-2.0
// Numbers off the front of text: bit for bit what the general way gives, or refused.
#include "base/nearest_double.hpp"
#include "base/number.hpp"
#include "base/take_numbers.hpp"

#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>

namespace feelem {
namespace {

constexpr std::string_view kRoom = ",........................................................";

/// What take_real() makes of the whole text; empty when it refuses it or leaves something over.
std::optional<double> taken(const std::string& text) {
    const std::string padded = text + std::string(kRoom);
    const char* at = padded.data();
    double value = 0;
    if (!take_real(at, value) || at != padded.data() + text.size()) return {};
    return value;
}

template <class Word>
std::optional<double> of_field(const std::string& text) {
    std::string field = text;
    field.resize(sizeof(Word), ' ');
    double value = 0;
    if (!fixed_real<Word>(field.data(), sizeof(Word), value)) return {};
    return value;
}

/// The nearest double, from a library of its own.
double nearest(std::string text) {
    for (char& c : text) c = c == 'D' || c == 'd' ? 'e' : c;
    double value = 0;
    fast_float::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(TakeReal, is_the_nearest_double_of_random_numbers_in_every_form) {
    std::mt19937_64 random(20261122);
    std::uniform_real_distribution<double> mantissa(-10, 10);
    std::uniform_int_distribution<int> exponent(-30, 30), digits(0, 16), form(0, 4);
    std::size_t taken_count = 0;
    for (int i = 0; i < 300'000; ++i) {
        const double value = mantissa(random) * std::pow(10.0, exponent(random) / 4);
        std::string text;
        switch (form(random)) {
        case 0: text = fmt::format("{:.{}f}", value, digits(random)); break;
        case 1: text = fmt::format("{:.{}E}", value, digits(random)); break;
        case 2: text = fmt::format("{:.{}e}", mantissa(random), 5) + fmt::format("{}", i % 9); break;
        case 3: text = fmt::format("{:.9g}", static_cast<double>(static_cast<float>(value))); break;
        default:
            text = fmt::format("{:.{}e}", value, 3 + i % 6);
            text[text.find('e')] = 'D';
            break;
        }
        if (const auto found = taken(text)) {
            ++taken_count;
            ASSERT_TRUE(same_bits(*found, nearest(text))) << text << ": " << fmt::format("{:.17g}", *found);
        }
        if (text.size() <= 16) {
            for (const std::string& field : {std::string(16 - text.size(), ' ') + text, text}) {
                const auto found = of_field<SixteenBytes>(field);
                ASSERT_TRUE(!found || same_bits(*found, nearest(text))) << text;
            }
        }
        if (text.size() <= 8) {
            const auto found = of_field<std::uint64_t>(text);
            ASSERT_TRUE(!found || same_bits(*found, nearest(text))) << text;
        }
    }
    EXPECT_GT(taken_count, 200'000U) << "the fast way must take most numbers";
}

TEST(TakeReal, is_the_nearest_double_of_hard_numbers_or_refuses_them) {
    for (const char* text :
         {"9007199254740993",
          "9007199254740992.",
          "9007199254740993.0",
          "900719925474099.3E+1",
          "0.000000000000000000000001",
          "1.7976931348623157e308",
          "2.2250738585072011e-308",
          "4.9e-324",
          "8.10109172351e-10",
          "1448997445238699",
          "6929495644600919.5",
          "3.141592653589793",
          "0.1",
          "0.30000000000000004",
          "-0.0",
          "-0.",
          "-.5",
          "5.E-1",
          "123456789012345678",
          "1.e22",
          "1.e23",
          "1.E-22",
          "1.E-23",
          "7.2057594037927933e16",
          "1.00000005960464477539",
          "10000000.5",
          "1234567.12345678",
          "1234567.123456789012",
          "0.00000001",
          "00000001.5"}) {
        if (const auto found = taken(text)) {
            EXPECT_TRUE(same_bits(*found, nearest(text))) << text << ": " << fmt::format("{:.17g}", *found);
        }
    }
    EXPECT_TRUE(taken("0.1").has_value());
    EXPECT_TRUE(taken("1234567.12345678").has_value());
    EXPECT_TRUE(taken("1.e22").has_value());
}

TEST(TakeReal, knows_the_ways_solvers_write_exponents) {
    EXPECT_EQ(taken("1.5-3"), 0.0015);
    EXPECT_EQ(taken("-2.+2"), -200.0);
    EXPECT_EQ(taken("1.5D+02"), 150.0);
    EXPECT_EQ(taken("1e3"), 1000.0);
    EXPECT_EQ(taken("12"), 12.0);
    EXPECT_EQ(of_field<std::uint64_t>("1.5-3"), 0.0015);
    EXPECT_EQ(of_field<std::uint64_t>("  -2.+2"), -200.0);
    EXPECT_EQ(of_field<SixteenBytes>(" 1.234567890E+02"), 123.456789);
    EXPECT_EQ(of_field<SixteenBytes>("123.4567890123  "), 123.4567890123);
}

TEST(TakeReal, leaves_alone_what_is_no_number) {
    for (const char* text :
         {"", "-", ".", "-.", "x", "1.5x", "--1", "1.5D", "1e", "1e+", "+-1", "1.2.3", "nan", "1e1234"})
        EXPECT_FALSE(taken(text).has_value()) << text;
    for (const char* text : {"", "-", ".", "1 2", "1.5x", "1.5 3", "1.5-", "1e+", "1.5\t", "+1", "$"}) {
        EXPECT_FALSE(of_field<std::uint64_t>(text).has_value()) << text;
        EXPECT_FALSE(of_field<SixteenBytes>(text).has_value()) << text;
    }
}

TEST(TakeDigits, counts_and_adds_up_to_fifteen) {
    for (const char* text : {"0", "7", "12345678", "123456789", "100000000000000", "99999999", "00012"}) {
        const std::string padded = text + std::string(kRoom);
        const char* at = padded.data();
        std::int64_t value = -1;
        ASSERT_TRUE(take_digits(at, value)) << text;
        EXPECT_EQ(value, parse_integer(text)) << text;
        EXPECT_EQ(at, padded.data() + std::string_view(text).size());
    }
    for (const char* text : {"", ",", "-1", "1234567890123456", "12345678901234567890"}) {
        const std::string padded = text + std::string(kRoom);
        const char* at = padded.data();
        std::int64_t value = -1;
        EXPECT_FALSE(take_digits(at, value)) << text;
        EXPECT_EQ(at, padded.data());
    }
}

TEST(CountDigits, stops_at_any_other_character) {
    for (int c = 0; c < 256; ++c) {
        const bool is_digit = c >= '0' && c <= '9';
        std::array<char, 8> text{'1', '2', '3', static_cast<char>(c), '5', '6', '7', '8'};
        EXPECT_EQ(count_digits(load8(text.data())), is_digit ? 8U : 3U) << c;
        text = {static_cast<char>(c), '2', '3', '4', '5', '6', '7', '8'};
        EXPECT_EQ(count_digits(load8(text.data())), is_digit ? 8U : 0U) << c;
    }
}

TEST(FixedInteger, stands_anywhere_in_its_columns) {
    const auto of = [](std::string text, std::size_t width) -> std::optional<std::int64_t> {
        text.resize(16, '9');
        std::int64_t value = 0;
        const bool is_fine = width <= 8 ? fixed_integer<std::uint64_t>(text.data(), width, -1, value)
                                        : fixed_integer<SixteenBytes>(text.data(), width, -1, value);
        return is_fine ? std::optional(value) : std::nullopt;
    };
    EXPECT_EQ(of("      12", 8), 12);
    EXPECT_EQ(of("12      ", 8), 12);
    EXPECT_EQ(of("  12    ", 8), 12);
    EXPECT_EQ(of("        ", 8), -1);
    EXPECT_EQ(of("12345678", 8), 12345678);
    EXPECT_EQ(of("1234", 4), 1234) << "the line ends within the field";
    EXPECT_EQ(of("", 0), -1);
    EXPECT_EQ(of("      1234567890", 16), 1234567890);
    EXPECT_EQ(of("1               ", 16), 1);
    EXPECT_EQ(of("                ", 16), -1);
    for (const char* text : {"1 2     ", "1.      ", "-1      ", "1\t      ", "1,      ", "1$      "})
        EXPECT_FALSE(of(text, 8).has_value()) << text;
}

TEST(NearestDouble, of_digits_and_a_power_is_that_of_their_text) {
    std::mt19937_64 random(4);
    std::size_t found_count = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t digits = (random() >> (random() % 64)) % 10'000'000'000'000'000'000U;
        const int exponent = static_cast<int>(random() % 700) - 360;
        double found = 0;
        if (!nearest_double(digits, exponent, i % 2 == 0, found)) continue;
        ++found_count;
        const std::string text = fmt::format("{}{}e{}", i % 2 == 0 ? "-" : "", digits, exponent);
        ASSERT_TRUE(same_bits(found, parse_double(text).value())) << text;
    }
    EXPECT_GT(found_count, 99'000U);
}

}  // namespace
}  // namespace feelem
