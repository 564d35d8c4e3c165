// SPDX-License-Identifier: Apache-2.0
// The one truth of a frame: every sense is made of the one value, by the formulas that all viewers share.
#include "support/paths.hpp"
#include "viewer/core/room_of_hands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace feelem::viewer::test {
namespace {

using Json = nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// One node that is held, and the value there.
struct Held : Ready {
    explicit Held(Scene scene = sensed_squares()) : Ready(std::move(scene)) {
        viewer.state.events.enter = false;
        input.pointer.can_vibrate = true;
        input.hold = true;
        input.head.position = {0, 0, 3};
    }
    /// Everywhere on the model, from now on.
    Snapshot at(float value, double seconds = 0.01) {
        for (float& kept : values) kept = value;
        for (Validity& kept : validity) kept = std::isnan(value) ? Validity::Missing : Validity::Solver;
        return next(seconds);
    }
    Snapshot next(double seconds = 0.01) {
        viewer.state.pin = 1;
        return frame(input, seconds);
    }

    FrameInput input;
    std::vector<float> values = std::vector<float>(8);
    std::vector<Validity> validity = std::vector<Validity>(8);
};

/// A scene whose one result is what the test says, whenever it says it.
struct Changing : Held {
    Changing() {
        ModelSource source = memory.source();
        source.values = [this](std::size_t, std::size_t) { return FieldSpan{1, values, validity}; };
        viewer.model = ViewedModel(source);
    }
    PresentedResult& result() { return viewer.state.presentation.results[0]; }
    PresentedEffect& effect(std::size_t i) { return viewer.state.presentation.effects[i]; }
};

Json contract_rows(const char* of) {
    return Json::parse(feelem::test::read_file(feelem::test::project_file("tests/contract/senses.json")))
        .at(of);
}

Scale scale_of(const std::string& word) {
    if (word == "log") return Scale::Log;
    if (word == "signed") return Scale::Signed;
    return word == "symlog" ? Scale::SymLog : Scale::Linear;
}

/// Sets the row's range; its value, where float32, what scenes hold, has it.
std::optional<float> take_row(Changing& changing, const Json& row) {
    changing.result().lo = row["range"]["lo"];
    changing.result().hi = row["range"]["hi"];
    changing.result().scale = scale_of(row["range"]["scale"]);
    if (row["value"].is_null()) return std::nanf("");
    const double value = row["value"];
    const auto kept = static_cast<float>(value);
    return static_cast<double>(kept) == value ? std::optional(kept) : std::nullopt;
}

TEST(Snapshot, colours_are_those_of_the_contract) {
    Changing changing;
    std::size_t rows = 0;
    for (const Json& row : contract_rows("colour")) {
        const auto value = take_row(changing, row);
        if (!value) continue;
        ColourEffect& colour = changing.effect(0).colour;
        colour.map = row["map"];
        colour.bands = row["bands"];
        colour.invert = row["invert"];
        const Rgb wanted{row["colour"][0], row["colour"][1], row["colour"][2]};
        EXPECT_EQ(changing.at(*value).colour, wanted) << row;
        ++rows;
    }
    EXPECT_GT(rows, 200u);
}

TEST(Snapshot, tones_are_those_of_the_contract) {
    Changing changing;
    std::size_t rows = 0;
    for (const Json& row : contract_rows("tone")) {
        const auto value = take_row(changing, row);
        if (!value) continue;
        PitchEffect& pitch = changing.effect(1).pitch;
        pitch.midi_low = row["midi"][0];
        pitch.midi_high = row["midi"][1];
        pitch.gamma = row["gamma"];
        pitch.invert = row["invert"];
        const std::string quantise = row["quantise"];
        pitch.quantise = quantise == "none"       ? Quantise::None
                         : quantise == "semitone" ? Quantise::Semitone
                                                  : Quantise::Pentatonic;
        pitch.sign_timbre = row["signTimbre"];
        const Snapshot now = changing.at(*value);
        ASSERT_TRUE(now.sound);
        EXPECT_NEAR(now.sound->hz, row["hz"].get<double>(), 1e-9) << row;
        EXPECT_NEAR(now.sound->gain, row["gain"].get<double>(), 1e-12) << row;
        EXPECT_EQ(now.sound->negative, row["negative"].get<bool>()) << row;
        ++rows;
    }
    EXPECT_GT(rows, 150u);
}

TEST(Snapshot, pulses_are_those_of_the_contract) {
    Changing changing;
    std::size_t rows = 0;
    for (const Json& row : contract_rows("pulses")) {
        const auto value = take_row(changing, row);
        if (!value) continue;
        PulseEffect& pulses = changing.effect(2).pulses;
        pulses.rate_low = row["rateHz"][0];
        pulses.rate_high = row["rateHz"][1];
        pulses.amplitude_min = row["ampMin"];
        pulses.invert = row["invert"];
        const Snapshot now = changing.at(*value);
        ASSERT_TRUE(now.touch[kRight]);
        EXPECT_NEAR(now.touch[kRight]->rate, row["rate"].get<double>(), 1e-12) << row;
        EXPECT_NEAR(now.touch[kRight]->amplitude, row["amplitude"].get<double>(), 1e-12) << row;
        ++rows;
    }
    EXPECT_GT(rows, 60u);
}

TEST(Snapshot, ticks_are_those_of_the_contract_also_where_they_stand_in_for_pulses) {
    Changing changing;
    changing.input.pointer.can_vibrate = false;
    PresentedEffect own;
    own.result = "T";
    own.sense = Sense::Ticks;
    for (const bool stands_in : {true, false}) {
        std::size_t rows = 0;
        if (!stands_in) changing.viewer.state.presentation.effects.push_back(own);
        for (const Json& row : contract_rows("ticks")) {
            const auto value = take_row(changing, row);
            if (!value) continue;
            TickEffect& ticks = changing.effect(stands_in ? 2 : 3).ticks;
            ticks.rate_low = row["rateHz"][0];
            ticks.rate_high = row["rateHz"][1];
            ticks.invert = row["invert"];
            const Snapshot now = changing.at(*value);
            EXPECT_NEAR(now.sound->tick_rate, row["tickRate"].get<double>(), 1e-12) << row;
            EXPECT_FALSE(now.touch[kRight]);
            ++rows;
        }
        EXPECT_GT(rows, 60u);
    }
}

TEST(Snapshot, every_sense_of_the_boiler_is_made_of_the_value_that_the_card_shows) {
    Ready ready(boiler_path());
    FrameInput input;
    input.pointer.can_vibrate = true;
    input.hold = true;
    const auto &low = ready.viewer.model.arrays().low, &high = ready.viewer.model.arrays().high;
    const glm::vec3 middle((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2);
    std::size_t held = 0;
    for (int i = 0; i < 60; ++i) {
        const float turn = 0.1F * static_cast<float>(i);
        const glm::vec3 eye = middle + 9000.0F * glm::vec3(std::cos(turn), std::sin(turn), 0.3F);
        input.pointer.ray = Ray{eye, glm::normalize(middle - eye)};
        const Snapshot now = ready.frame(input);
        if (!now.probed) continue;
        ++held;
        const Presentation& shown = ready.viewer.state.presentation;
        const auto value = [&](Sense sense) {
            for (const Reading& reading : now.probed->readings) {
                if (reading.key == result_of(shown, sense)->key) return reading.value;
            }
            return kNaN;
        };
        const auto range = [&](Sense sense) {
            return range_at(ready.viewer.state, ready.viewer.model, *result_of(shown, sense));
        };
        EXPECT_EQ(
            now.colour,
            colour_of(value(Sense::Colour), range(Sense::Colour), effect_of(shown, Sense::Colour)->colour)
        );
        const Tone tone =
            tone_of(value(Sense::Pitch), range(Sense::Pitch), effect_of(shown, Sense::Pitch)->pitch);
        EXPECT_EQ(now.sound->hz, tone.hz);
        EXPECT_EQ(now.sound->gain, tone.gain);
        const Pulse pulse =
            pulse_of(value(Sense::Pulses), range(Sense::Pulses), effect_of(shown, Sense::Pulses)->pulses);
        EXPECT_EQ(now.touch[kRight]->rate, pulse.rate);
        EXPECT_EQ(now.touch[kRight]->amplitude, pulse.amplitude);
    }
    EXPECT_GT(held, 20u);
}

TEST(Snapshot, a_limit_is_said_when_it_is_crossed_and_again_only_well_behind_it) {
    Changing changing;
    changing.result().limit = 60;
    changing.viewer.state.events.extremes = false;
    EXPECT_THAT(changing.at(50).events, IsEmpty());
    EXPECT_THAT(changing.at(61, 1).events, ElementsAre(SenseEvent::LimitUp));
    EXPECT_THAT(changing.at(61, 1).events, IsEmpty());
    EXPECT_THAT(changing.at(59.5F, 1).events, IsEmpty()) << "within one per cent of the range";
    EXPECT_TRUE(changing.next().sound->tremolo);
    EXPECT_TRUE(changing.next().touch[kRight]->alarm);
    EXPECT_THAT(changing.at(58, 1).events, ElementsAre(SenseEvent::LimitDown));
    EXPECT_FALSE(changing.next().sound->tremolo);
    changing.result().limit_is_upper = false;
    EXPECT_THAT(changing.next(1).events, ElementsAre(SenseEvent::LimitUp));
}

TEST(Snapshot, an_event_waits_half_a_second_before_it_comes_again) {
    Changing changing;
    changing.result().limit = 60;
    changing.viewer.state.events.extremes = false;
    EXPECT_THAT(changing.at(70).events, ElementsAre(SenseEvent::LimitUp));
    EXPECT_THAT(changing.at(50, 0.1).events, ElementsAre(SenseEvent::LimitDown));
    EXPECT_THAT(changing.at(70, 0.1).events, IsEmpty());
    changing.at(50, 0.2);
    EXPECT_THAT(changing.at(70, 0.2).events, ElementsAre(SenseEvent::LimitUp));
}

TEST(Snapshot, no_value_is_said_once_and_is_silent) {
    Changing changing;
    changing.at(50);
    Snapshot now = changing.at(std::nanf(""), 1);
    EXPECT_THAT(now.events, ElementsAre(SenseEvent::NoValue));
    EXPECT_EQ(now.sound->gain, 0);
    EXPECT_EQ(now.touch[kRight]->rate, 0);
    EXPECT_EQ(now.colour, (Rgb{128, 128, 128}));
    EXPECT_THAT(changing.next(1).events, IsEmpty());
    changing.viewer.state.events.no_value = false;
    changing.at(50, 1);
    EXPECT_THAT(changing.at(std::nanf(""), 1).events, IsEmpty());
}

TEST(Snapshot, largest_and_smallest_value_are_said_when_they_are_found) {
    Held held;
    const auto go = [&](std::int64_t node) {
        held.viewer.state.pin = node;
        return held.frame(held.input, 1).events;
    };
    EXPECT_THAT(go(1), ElementsAre(SenseEvent::Minimum));
    EXPECT_THAT(go(1), IsEmpty());
    EXPECT_THAT(go(4), IsEmpty());
    EXPECT_THAT(go(11), ElementsAre(SenseEvent::Maximum));
    held.viewer.state.events.extremes = false;
    EXPECT_THAT(go(1), IsEmpty());
}

TEST(Snapshot, band_edges_are_said_where_the_person_wants_them_and_not_by_a_trembling_value) {
    Changing changing;
    changing.viewer.state.events.band_edges = true;
    changing.viewer.state.events.extremes = false;
    changing.effect(0).colour.bands = 10;
    EXPECT_THAT(changing.at(49).events, IsEmpty());
    EXPECT_THAT(changing.at(50.2F, 1).events, IsEmpty()) << "half a per cent of play";
    EXPECT_THAT(changing.at(51, 1).events, ElementsAre(SenseEvent::BandUp));
    EXPECT_THAT(changing.at(49.8F, 1).events, IsEmpty());
    EXPECT_THAT(changing.at(45, 1).events, ElementsAre(SenseEvent::BandDown));
    changing.viewer.state.events.band_edges = false;
    EXPECT_THAT(changing.at(75, 1).events, IsEmpty());
}

TEST(Snapshot, coming_onto_the_model_is_said_each_time) {
    Held held;
    held.viewer.state.events.enter = true;
    held.viewer.state.events.extremes = false;
    EXPECT_THAT(held.next().events, ElementsAre(SenseEvent::Enter));
    EXPECT_THAT(held.next(1).events, IsEmpty());
    held.input.hold = false;
    held.next(1);
    held.input.hold = true;
    EXPECT_THAT(held.next(1).events, ElementsAre(SenseEvent::Enter));
}

TEST(Snapshot, above_the_range_flutters_without_a_limit_and_below_is_dull) {
    Changing changing;
    EXPECT_FALSE(changing.at(50).sound->tremolo);
    EXPECT_TRUE(changing.at(101).sound->tremolo);
    changing.result().limit = 500;
    EXPECT_FALSE(changing.next().sound->tremolo);
    EXPECT_TRUE(changing.at(-1).sound->dull);
    EXPECT_EQ(changing.next().colour, (Rgb{255, 255, 0}));
}

TEST(Snapshot, a_rest_is_known_by_place_and_value) {
    Changing changing;
    EXPECT_FALSE(changing.at(50).sound->still);
    EXPECT_TRUE(changing.at(50.4F).sound->still);
    EXPECT_TRUE(changing.next().touch[kRight]->still);
    EXPECT_FALSE(changing.at(51).sound->still);
    EXPECT_TRUE(changing.next().sound->still);
    changing.viewer.state.pin = 2;
    EXPECT_FALSE(changing.frame(changing.input).sound->still);
}

TEST(Snapshot, mute_leaves_the_hand_and_still_leaves_the_ear) {
    Held held;
    held.viewer.state.sound = false;
    Snapshot now = held.next();
    EXPECT_FALSE(now.sound);
    EXPECT_TRUE(now.touch[kRight]);
    held.viewer.state.sound = true;
    held.viewer.state.touch = false;
    now = held.next();
    EXPECT_TRUE(now.sound);
    EXPECT_FALSE(now.touch[kRight]);
}

TEST(Snapshot, the_source_is_where_the_head_finds_the_place) {
    Held held;
    held.input.head.position = {2, 0, 0};
    held.input.head.orientation = glm::angleAxis(std::numbers::pi_v<float> / 2, glm::vec3(0, 1, 0));
    const glm::vec3 source = held.next().sound->source;
    EXPECT_NEAR(source.x, 0, 1e-5);
    EXPECT_NEAR(source.z, -2, 1e-5) << "it looks towards -x, where node 1 lies";
    held.input.head.orientation = {1, 0, 0, 0};
    EXPECT_NEAR(held.next().sound->source.x, -2, 1e-5);
}

TEST(Snapshot, what_the_person_needs_goes_before_what_the_presentation_asks_for) {
    Changing changing;
    changing.viewer.state.person.wide = true;
    changing.viewer.state.person.weakest = 0.3;
    const Snapshot low = changing.at(0);
    EXPECT_NEAR(low.touch[kRight]->amplitude, 0.3, 1e-12);
    EXPECT_NEAR(changing.at(100).sound->hz / low.sound->hz, 16, 1e-9) << "four octaves";
}

TEST(Snapshot, frames_are_counted_and_hover_is_read_only) {
    Held held;
    held.input.hold = false;
    const Snapshot first = held.next();
    EXPECT_TRUE(first.probed && first.colour);
    EXPECT_FALSE(first.is_held || first.sound || first.touch[kRight]);
    EXPECT_THAT(first.events, IsEmpty());
    EXPECT_EQ(held.next().frame, first.frame + 1);
}

TEST(Snapshot, a_result_without_values_at_the_step_is_missing_in_every_sense) {
    Scene scene = sensed_squares();
    scene.results[0].values.pop_back();
    Held held(scene);
    EXPECT_EQ(held.next().probed->readings.at(0).state, "solver");
    held.viewer.state.step = 1;
    const Snapshot now = held.next(1);
    EXPECT_EQ(now.probed->readings.at(0).state, "missing");
    EXPECT_EQ(now.sound->gain, 0);
    EXPECT_THAT(now.events, Contains(SenseEvent::NoValue));
}

}  // namespace
}  // namespace feelem::viewer::test
