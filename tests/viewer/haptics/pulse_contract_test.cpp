// SPDX-License-Identifier: Apache-2.0
// What both viewers must send: tests/contract/pulses.json, made here, checked by the page's tests too.
// FEELEM_UPDATE_GOLDEN=1 writes it anew; the difference is then for people to judge.
#include "support/paths.hpp"
#include "viewer/haptics/pulser.hpp"
#include "viewer/haptics/recording_sink.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace feelem::test {
namespace {

using viewer::HapticFrame;
using viewer::SenseEvent;

/// Some frames with the same wish. Event, stop and strength come before its first frame.
struct Step {
    int frames = 0;
    std::optional<HapticFrame> touch{};
    std::optional<SenseEvent> event{};
    bool stop = false;
    std::optional<double> strength{};
};
struct Case {
    std::string name;
    double hz = 72;
    std::vector<Step> steps;
};

HapticFrame touch(double rate, double amplitude) {
    HapticFrame frame;
    frame.rate = rate;
    frame.amplitude = amplitude;
    return frame;
}

HapticFrame changed(HapticFrame frame, void (*change)(HapticFrame&)) {
    change(frame);
    return frame;
}

void alarmed(HapticFrame& frame) {
    frame.alarm = true;
}
void resting(HapticFrame& frame) {
    frame.still = true;
}
void endless(HapticFrame& frame) {
    frame.milliseconds = 5000;
}

/// A hand that does everything in any order, always the same.
Case random_case(double hz) {
    std::uint32_t state = 5;
    const auto random = [&](std::uint32_t below) {
        state = state * 1664525 + 1013904223;
        return (state >> 8U) % below;
    };
    Case made{fmt::format("anything at {} frames a second", hz), hz, {}};
    for (int i = 0; i < 400; ++i) {
        Step step{.frames = static_cast<int>(1 + random(12))};
        if (random(6) != 0) {
            step.touch = touch(2 + random(33) / 4.0, (1 + random(16)) / 16.0);
            step.touch->milliseconds = 10 + random(300);
            step.touch->alarm = random(5) == 0;
            step.touch->still = random(4) == 0;
        }
        if (random(5) == 0) step.event = static_cast<SenseEvent>(random(8));
        if (random(40) == 0) step.stop = true;
        if (random(40) == 0) step.strength = random(7) / 4.0;
        made.steps.push_back(step);
    }
    return made;
}

std::vector<Case> cases() {
    const HapticFrame low = touch(2, 0.15), middle = touch(4.5, 0.375), high = touch(10, 1);
    std::vector<Case> all;
    for (const double hz : {60.0, 72.0, 90.0, 120.0, 8.0}) {
        all.push_back(
            {fmt::format("low, middle, high at {} frames a second", hz),
             hz,
             {{static_cast<int>(2 * hz), low},
              {static_cast<int>(2 * hz), middle},
              {static_cast<int>(2 * hz), high}}}
        );
    }
    all.push_back({"let go and touch again", 72, {{30, high}, {40}, {30, high}, {1}, {30, low}}});
    all.push_back({"a rise is felt within a frame", 72, {{75, low}, {40, high}, {75, low}}});
    all.push_back({"beyond the limit", 72, {{144, changed(middle, alarmed)}, {144, changed(high, alarmed)}}});
    all.push_back({"a hand that rests", 72, {{400, changed(high, resting)}, {72, high}}});
    all.push_back({"no pulse is too long", 72, {{216, changed(low, endless)}, {216, changed(high, endless)}}}
    );
    for (const SenseEvent event :
         {SenseEvent::LimitUp,
          SenseEvent::LimitDown,
          SenseEvent::Maximum,
          SenseEvent::Minimum,
          SenseEvent::NoValue,
          SenseEvent::BandUp,
          SenseEvent::BandDown,
          SenseEvent::Enter}) {
        all.push_back({fmt::format("{} amid beats", word(event)), 90, {{50, middle}, {90, middle, event}}});
        all.push_back({fmt::format("{} alone", word(event)), 72, {{5}, {40, {}, event}}});
    }
    all.push_back(
        {"the limit comes before everything",
         72,
         {{20, high, SenseEvent::Maximum},
          {3, high, SenseEvent::LimitUp},
          {3, high, SenseEvent::Minimum},
          {30, high, SenseEvent::LimitDown}}}
    );
    all.push_back(
        {"stop forgets", 72, {{20, high}, {1, high, SenseEvent::LimitUp}, {40, {}, {}, true}, {20, low}}}
    );
    all.push_back(
        {"personal strength",
         72,
         {{20, middle, {}, false, 0.5}, {20, middle, {}, false, 0}, {20, high, {}, false, 1.5}}}
    );
    all.push_back(random_case(72));
    all.push_back(random_case(90));
    return all;
}

std::string step_json(const Step& step) {
    std::string text = fmt::format(R"({{"frames": {})", step.frames);
    if (step.strength) text += fmt::format(R"(, "strength": {})", *step.strength);
    if (step.stop) text += R"(, "stop": true)";
    if (step.event) text += fmt::format(R"(, "event": "{}")", word(*step.event));
    if (step.touch) {
        text += fmt::format(
            R"(, "touch": {{"rate": {}, "amplitude": {}, "milliseconds": {}, "alarm": {}, "still": {}}})",
            step.touch->rate,
            step.touch->amplitude,
            step.touch->milliseconds,
            step.touch->alarm,
            step.touch->still
        );
    }
    return text + "}";
}

/// Pulses as [frame, strength, milliseconds, cause].
std::string pulses_json(const Case& one) {
    viewer::Pulser pulser;
    RecordingSink sink;
    pulser.set_sink(&sink);
    std::string text;
    int frame = 0;
    for (const Step& step : one.steps) {
        if (step.strength) pulser.set_strength(*step.strength);
        if (step.stop) pulser.stop();
        if (step.event) pulser.event(*step.event);
        for (int i = 0; i < step.frames; ++i, ++frame) {
            pulser.update(step.touch);
            const std::size_t before = sink.calls.size();
            const auto sent = pulser.tick(frame / one.hz);
            EXPECT_EQ(sink.calls.size() - before, sent ? 1U : 0U);
            if (!sent) continue;
            EXPECT_EQ(sink.calls.back().amplitude, sent->strength);
            EXPECT_EQ(sink.calls.back().milliseconds, sent->milliseconds);
            text += fmt::format(
                R"({}[{}, {}, {}, "{}"])",
                text.empty() ? "" : ", ",
                frame,
                sent->strength,
                sent->milliseconds,
                sent->event ? word(*sent->event) : "beat"
            );
        }
    }
    return text;
}

std::string pulse_contract() {
    std::string text =
        "{\n  \"about\": \"frames of touch -> pulses sent, as [frame, strength, milliseconds, cause]; "
        "the time of a frame is its number / hz\",\n  \"cases\": [";
    std::string_view comma = "\n";
    for (const Case& one : cases()) {
        text += fmt::format("{}    {{\"name\": \"{}\", \"hz\": {}, \"steps\": [\n", comma, one.name, one.hz);
        std::string_view between;
        for (const Step& step : one.steps) {
            text += fmt::format("{}      {}", between, step_json(step));
            between = ",\n";
        }
        text += fmt::format("\n    ], \"pulses\": [{}]}}", pulses_json(one));
        comma = ",\n";
    }
    return text + "\n  ]\n}\n";
}

TEST(PulseContract, pulses_are_those_that_every_viewer_agreed_on) {
    const std::string path = project_file("tests/contract/pulses.json");
    if (const char* update = std::getenv("FEELEM_UPDATE_GOLDEN"); update != nullptr && *update == '1') {
        write_file(path, pulse_contract());
    }

    EXPECT_EQ(pulse_contract(), read_file(path));
}

}  // namespace
}  // namespace feelem::test
