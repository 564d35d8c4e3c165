// SPDX-License-Identifier: Apache-2.0
// What both viewers' sounds are made of: tests/contract/sounds.json, made here, checked by the page's tests
// too. FEELEM_UPDATE_GOLDEN=1 writes it anew; the difference is then for people to judge.
#include "support/paths.hpp"
#include "viewer/audio/earcons.hpp"
#include "viewer/audio/signals.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <string>

namespace feelem::test {
namespace {

using nlohmann::json;
using viewer::SenseEvent;

std::string samples_text(const std::vector<float>& samples, std::size_t every) {
    std::string text = fmt::format(R"({{"count": {}, "samples": [)", samples.size());
    std::string_view comma;
    for (std::size_t i = 0; i < samples.size(); i += every) {
        text += fmt::format("{}[{}, {:.9g}]", comma, i, samples[i]);
        comma = ", ";
    }
    return text + "]}";
}

std::string limiter_text() {
    std::string text = "[";
    for (int i = -10; i <= 10; ++i) {
        text += fmt::format("{}[{}, {:.12g}]", i == -10 ? "" : ", ", i / 10.0, viewer::limited(i / 10.0));
    }
    return text + "]";
}

std::string earcons_text() {
    std::string text = "[\n";
    for (int i = 0; i < 8; ++i) {
        const auto event = static_cast<SenseEvent>(i);
        const viewer::Earcon& earcon = viewer::earcon_of(event);
        text += fmt::format(
            "{}    {{\"event\": \"{}\", \"weight\": {}, \"seconds\": {:.12g}, \"decibel\": {}, \"beeps\": [",
            i == 0 ? "" : ",\n",
            word(event),
            earcon.weight,
            earcon.seconds(),
            earcon.decibel
        );
        for (std::size_t k = 0; k < earcon.beeps; ++k) {
            const double start = static_cast<double>(k) * (earcon.beep_seconds + earcon.gap_seconds);
            text += fmt::format(
                "{}{{\"start\": {:.12g}, \"seconds\": {:.12g}, \"hz\": {:.12g}}}",
                k == 0 ? "" : ", ",
                start,
                earcon.beep_seconds,
                earcon.pitches[k]
            );
        }
        text += "]}";
    }
    return text + "\n  ]";
}

std::string sound_contract() {
    return fmt::format(
        "{{\n  \"about\": \"samples at 48 kHz of a tick and of pink noise, the limiter, the earcons\",\n"
        "  \"tick\": {},\n  \"pink\": {},\n  \"limited\": {},\n  \"earcons\": {}\n}}\n",
        samples_text(viewer::tick_samples(), 8),
        samples_text(viewer::pink_noise(), 997),
        limiter_text(),
        earcons_text()
    );
}

void expect_near(const json& found, const json& wanted, const std::string& where) {
    ASSERT_EQ(found.type(), wanted.type()) << where;
    if (wanted.is_number_float()) {
        EXPECT_NEAR(found.get<double>(), wanted.get<double>(), 1e-6) << where;
    } else if (wanted.is_structured()) {
        ASSERT_EQ(found.size(), wanted.size()) << where;
        for (const auto& item : wanted.items()) {
            const std::string& key = item.key();
            const json& mine = wanted.is_array() ? found.at(std::stoul(key)) : found.at(key);
            expect_near(mine, item.value(), where + "/" + key);
        }
    } else {
        EXPECT_EQ(found, wanted) << where;
    }
}

TEST(SoundContract, sounds_are_made_of_what_every_viewer_agreed_on) {
    const std::string path = project_file("tests/contract/sounds.json");
    if (const char* update = std::getenv("FEELEM_UPDATE_GOLDEN"); update != nullptr && *update == '1') {
        write_file(path, sound_contract());
    }

    // Sines may differ in their last digit between machines.
    expect_near(json::parse(sound_contract()), json::parse(read_file(path)), "");
}

TEST(Limiter, nothing_quiet_is_changed_and_nothing_passes_minus_6_decibels) {
    for (double x = -0.4; x <= 0.4; x += 0.01) EXPECT_EQ(viewer::limited(x), x);
    double last = 0.4;
    for (double x = 0.41; x < 20; x *= 1.02) {
        const double y = viewer::limited(x);
        EXPECT_GE(y, last);
        EXPECT_LE(y, std::pow(10.0, -6.0 / 20));
        EXPECT_EQ(viewer::limited(-x), -y);
        last = y;
    }
    EXPECT_GT(last, 0.5);
}

}  // namespace
}  // namespace feelem::test
