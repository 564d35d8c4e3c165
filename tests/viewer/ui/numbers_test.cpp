// SPDX-License-Identifier: Apache-2.0
// Numbers read the same in the window and on the page: tests/contract/numbers.json, made here, checked by the
// page's tests too. FEELEM_UPDATE_GOLDEN=1 writes it anew; the difference is then for people to judge.
#include "support/paths.hpp"
#include "viewer/core/viewer_state.hpp"
#include "viewer/ui/numbers.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace feelem::viewer {
namespace {

using ::testing::ElementsAre;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string json_of(double value) {
    return std::isnan(value) ? "null" : fmt::format("{}", value);
}

std::string joined(const std::vector<std::string>& items) {
    std::string out;
    for (const std::string& item : items) out += (out.empty() ? "" : ", ") + item;
    return out;
}

/// Hard ones by hand, then many by chance, of all sizes.
std::vector<double> tried_values() {
    std::vector<double> out{
        0,
        -0.0,
        kNaN,
        1,
        -1,
        31.2,
        0.1F,
        123456.789,
        1234565,
        0.5,
        2.5,
        1.0005,
        1e-4,
        9.9999949e-5,
        9.99999e-5,
        9999999,
        9999999.4,
        9999999.6,
        1e7,
        12345675,
        7.85e9,
        1e-300,
        1.5e300,
        -0.000012345678,
        250,
        249.9999,
        249.99999,
        0.30000001192092896,
        100000.5,
        999999.5,
        1000000,
        0.000123456789,
        1.401298464324817e-45,
        3.4028234663852886e38,
        2097151.875,
        8388607.5,
        16777216};
    std::uint64_t state = 7;
    for (int i = 0; i < 200; ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const double share = static_cast<double>(state >> 40U) / static_cast<double>(1U << 24U);
        const double size = std::pow(10.0, static_cast<double>((state >> 20U) % 24U) - 12);
        out.push_back((i % 2 == 0 ? 1 : -1) * static_cast<double>(static_cast<float>(share * size)));
    }
    return out;
}

std::string number_lines() {
    std::vector<std::string> lines;
    for (const double value : tried_values())
        for (const int digits : {6, 4, 3, 2})
            lines.push_back(fmt::format(
                R"({{"value": {}, "digits": {}, "text": "{}"}})",
                json_of(value),
                digits,
                number_text(value, digits)
            ));
    return fmt::format("{}", fmt::join(lines, ",\n    "));
}

std::string axis_lines() {
    std::vector<std::string> lines;
    const std::vector<std::vector<double>> axes{
        {0, 0.001, 0.002},
        {131.143, 142.7, 154.3},
        {1e-7, 2e-7, 3e-7},
        {-5e8, 0, 5e8},
        {100, 100.01},
        {7, 7},
        {-1, -0.5, 0, 0.5, 1},
        {0.125, 0.25, 0.375, 0.5},
        {31.2, 61.3, 91.4, 121.5},
        {999999, 1000000},
        {0.0005, 0.0015},
        {2.5, 3.5, 4.5},
        {250}};
    for (const std::vector<double>& axis : axes) {
        std::vector<std::string> values;
        std::vector<std::string> texts;
        for (const double value : axis) values.push_back(json_of(value));
        for (const std::string& text : axis_texts(axis)) texts.push_back("\"" + text + "\"");
        lines.push_back(fmt::format(R"({{"values": [{}], "texts": [{}]}})", joined(values), joined(texts)));
    }
    return fmt::format("{}", fmt::join(lines, ",\n    "));
}

std::string unit_lines() {
    std::vector<std::string> lines;
    for (const std::string_view unit :
         {"",
          "degC",
          "degF",
          "degrees",
          "um",
          "um/s",
          "N/um",
          "N/mm2",
          "N/mm^2",
          "m3/s",
          "kg/m^3",
          "MPa",
          "W/m2K",
          "m2 s",
          "umbra"})
        lines.push_back(fmt::format(R"({{"unit": "{}", "text": "{}"}})", unit, unit_text(unit)));
    return fmt::format("{}", fmt::join(lines, ",\n    "));
}

std::string bound_lines() {
    std::vector<std::string> lines;
    for (const double bound :
         {0.0, 0.05, 0.0501, 0.26, 0.261, 1.0, 9.9, 9.95, 99.0, 100.0, 1e-9, 3.14159, 12345678.0})
        lines.push_back(fmt::format(R"({{"bound": {}, "text": "{}"}})", json_of(bound), bound_text(bound)));
    return fmt::format("{}", fmt::join(lines, ",\n    "));
}

std::string step_lines() {
    constexpr std::array<std::string_view, 6> kinds{
        "static", "time", "mode", "frequency", "buckling", "other"};
    const std::vector<Step> steps{
        {.step = 1, .substep = 1, .kind = StepKind::Static, .value = 1, .label = ""},
        {.step = 1, .substep = 4, .kind = StepKind::Time, .value = 480, .label = ""},
        {.step = 1, .substep = 4, .kind = StepKind::Mode, .value = 76.66, .label = "Mode 4"},
        {.step = 2, .substep = 3, .kind = StepKind::Frequency, .value = 172.8441, .label = " sweep "},
        {.step = 1, .substep = 2, .kind = StepKind::Buckling, .value = 3.25, .label = ""},
        {.step = 1, .substep = 1, .kind = StepKind::Time, .value = kNaN, .label = ""},
        {.step = 1, .substep = 1, .kind = StepKind::Other, .value = 0, .label = "all"}};
    std::vector<std::string> lines;
    for (const Step& step : steps) {
        const bool is_time = step.kind == StepKind::Time;
        const bool is_frequency = step.kind == StepKind::Mode || step.kind == StepKind::Frequency;
        lines.push_back(fmt::format(
            R"({{"step": {{"id": 1, "kind": "{}", "number": [{}, {}], "value": {}, "unit": {}, "name": "{}"}}, "text": "{}"}})",
            kinds.at(static_cast<std::size_t>(step.kind)),
            step.step,
            step.substep,
            json_of(step.value),
            is_time        ? "\"s\""
            : is_frequency ? "\"Hz\""
                           : "null",
            step.label,
            step_text(step)
        ));
    }
    return fmt::format("{}", fmt::join(lines, ",\n    "));
}

std::string numbers_contract() {
    return fmt::format(
        "{{\n  \"about\": \"numbers, units and steps as people read them; null is no value\",\n"
        "  \"numbers\": [\n    {}\n  ],\n  \"axes\": [\n    {}\n  ],\n  \"units\": [\n    {}\n  ],\n"
        "  \"bounds\": [\n    {}\n  ],\n  \"steps\": [\n    {}\n  ]\n}}\n",
        number_lines(),
        axis_lines(),
        unit_lines(),
        bound_lines(),
        step_lines()
    );
}

TEST(Numbers, read_as_every_viewer_agreed) {
    const std::string path = feelem::test::project_file("tests/contract/numbers.json");
    if (const char* update = std::getenv("FEELEM_UPDATE_GOLDEN"); update != nullptr && *update == '1')
        feelem::test::write_file(path, numbers_contract());

    EXPECT_EQ(numbers_contract(), feelem::test::read_file(path));
}

TEST(Numbers, have_at_most_six_digits_and_none_that_they_have_not) {
    EXPECT_EQ(number_text(31.2), "31.2");
    EXPECT_EQ(number_text(0.1F), "0.1");
    EXPECT_EQ(number_text(-0.000012345678), "-1.23457e-5");
    EXPECT_EQ(number_text(1234565), "1234570") << "a value right between two goes up, as in browsers";
    EXPECT_EQ(number_text(kNaN), "no value");
    EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-∞");
}

TEST(Numbers, have_the_unit_that_was_declared_and_no_other) {
    EXPECT_EQ(with_unit(250, "MPa"), "250 MPa");
    EXPECT_EQ(with_unit(250, ""), "250");
    EXPECT_EQ(with_unit(kNaN, "MPa"), "no value");
    EXPECT_EQ(with_unit(21.5, "degC"), "21.5 °C");
}

TEST(Numbers, a_bound_is_never_less_than_it_is) {
    EXPECT_EQ(bound_text(0.0501), "0.051");
    EXPECT_EQ(bound_text(0.05), "0.05");
}

TEST(Scale, value_at_a_position_stands_at_that_position) {
    for (const ValueRange& range :
         {ValueRange{-3, 9, Scale::Linear},
          ValueRange{0.01, 1000, Scale::Log},
          ValueRange{-4, 2, Scale::Signed},
          ValueRange{-50, 800, Scale::SymLog},
          ValueRange{0, 800, Scale::Log}}) {
        for (const double t : {0.0, 0.1, 0.35, 0.5, 0.9, 1.0})
            EXPECT_NEAR(normalise(value_at_position(t, range), range).position, t, 1e-9);
    }
}

TEST(Scale, labels_stand_on_band_edges_while_there_is_room) {
    EXPECT_THAT(label_positions(4), ElementsAre(0, 0.25, 0.5, 0.75, 1));
    EXPECT_EQ(label_positions(9).size(), 10U);
    for (const int bands : {0, 20, 33, 64}) {
        EXPECT_GT(label_positions(bands).size(), 5U);
        EXPECT_LT(label_positions(bands).size(), 16U);
    }
}

TEST(Limit, is_used_by_share_only_where_a_share_means_something) {
    EXPECT_EQ(utilisation(125, 250, true), 0.5);
    EXPECT_EQ(utilisation(3, 1.5, false), 0.5);
    EXPECT_EQ(utilisation(1, std::nullopt, true), std::nullopt);
    EXPECT_EQ(utilisation(1, 0, true), std::nullopt);
    EXPECT_EQ(utilisation(-1, 2, false), std::nullopt);
    EXPECT_EQ(utilisation(kNaN, 2, true), std::nullopt);
}

}  // namespace
}  // namespace feelem::viewer
