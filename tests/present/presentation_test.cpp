// SPDX-License-Identifier: Apache-2.0
// Presentations read, written back with what was not understood, and refused by the path of the wrong key.
#include "support/paths.hpp"

#include "feelem/error.hpp"
#include "feelem/present.hpp"
#include "feelem/presented_view.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <string>

namespace feelem {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The text without blanks outside quotes: equal documents with keys in equal order give equal texts.
std::string squeezed(const std::string& json) {
    std::string out;
    bool quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (json[i] == '"' && (i == 0 || json[i - 1] != '\\')) {
            quoted = !quoted;
        }
        if (quoted || std::isspace(static_cast<unsigned char>(json[i])) == 0) {
            out += json[i];
        }
    }
    return out;
}

std::string boiler() {
    return test::read_file(test::project_file("tests/data/present/boiler.json"));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// What is said about a document that must be refused.
std::string refusal(const std::string& json) {
    try {
        parse_presentation(json, "p.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Code::BadPresentation);
        EXPECT_EQ(error.where(), "p.json");
        return error.what();
    }
    return "accepted";
}

constexpr const char* kTwoResults = R"({"results": [{"key": "T", "name": "temperature"}, {"key": "U",
    "name": "displacement"}], "effects": [EFFECTS]})";
std::string with_effects(const std::string& effects) {
    return replaced(kTwoResults, "EFFECTS", effects);
}

TEST(Presentation, reads_every_field_of_the_boiler) {
    const Presentation p = parse_presentation(boiler(), "boiler.json");

    EXPECT_EQ(p.title, "Boiler: T seen, u heard, stress felt");
    EXPECT_EQ(p.step, (std::array<int, 3>{0, 1, 1}));
    ASSERT_EQ(p.results.size(), 3U);
    EXPECT_EQ(p.results[0].name, "temperature");
    EXPECT_EQ(p.results[1].component, "magnitude");
    EXPECT_EQ(p.results[2].averaging, "part");
    EXPECT_EQ(p.results[2].unit, "MPa");
    EXPECT_EQ(p.results[2].range_mode, "percentile");
    EXPECT_EQ(p.results[2].limit, 250);
    EXPECT_EQ(p.results[2].limit_label, "yield");
    EXPECT_FALSE(p.results[0].lo.has_value());
    ASSERT_EQ(p.effects.size(), 3U);
    EXPECT_EQ(p.effects[0].sense, Sense::Colour);
    EXPECT_EQ(p.effects[0].colour.above, (Rgb{255, 0, 255}));
    EXPECT_EQ(p.effects[1].sense, Sense::Pitch);
    EXPECT_EQ(p.effects[1].pitch.midi_high, 84);
    EXPECT_EQ(p.effects[2].sense, Sense::Pulses);
    EXPECT_EQ(p.effects[2].pulses.rate_high, 10);
    EXPECT_TRUE(p.effects[2].falls_back_to_ticks);
    EXPECT_EQ(p.effects[2].ticks.rate_high, 12);
    EXPECT_THAT(p.card, ElementsAre("T", "U", "S"));
    EXPECT_EQ(p.deformation_result, "U");
    EXPECT_FALSE(p.deformation_factor.has_value());
}

TEST(Presentation, X2_round_trip_changes_nothing_not_even_what_is_unknown) {
    for (const std::string& json :
         {boiler(),
          std::string("{}"),
          with_effects(R"({"result": "U", "type": "pitch", "colour of the cat": {"deep": [1, null, "é"]}})"
          )}) {
        EXPECT_EQ(squeezed(presentation_json(parse_presentation(json, "p.json"))), squeezed(json));
    }
}

TEST(Presentation, shipped_boiler_follows_the_paper) {
    const std::string json = test::read_file(test::project_file("examples/boiler/boiler.presentation.json"));

    const Presentation p = parse_presentation(json, "boiler.presentation.json");

    ASSERT_EQ(p.effects.size(), 3U);
    EXPECT_EQ(p.effects[0].sense, Sense::Colour);
    EXPECT_EQ(p.effects[1].sense, Sense::Pitch);
    EXPECT_EQ(p.effects[2].sense, Sense::Pulses);
    EXPECT_EQ(p.results[0].name, "temperature");
    EXPECT_EQ(squeezed(presentation_json(p)), squeezed(json));
}

TEST(Presentation, change_touches_only_its_key) {
    Presentation p = parse_presentation(boiler(), "p.json");
    p.results[0].lo = 150.5;
    p.results[0].hi = 200.25;
    p.effects[2].pulses.amplitude_min = 0.25;

    std::string expected = replaced(boiler(), R"("lo": null, "hi": null)", R"("lo": 150.5, "hi": 200.25)");
    expected = replaced(expected, R"("ampMin": 0.15)", R"("ampMin": 0.25)");

    EXPECT_EQ(squeezed(presentation_json(p)), squeezed(expected));
}

TEST(Presentation, unknown_keys_follow_their_result_when_the_order_changes) {
    Presentation p = parse_presentation(
        R"({"results": [{"key": "A", "name": "a", "mark": 1}, {"key": "B", "name": "b", "mark": 2}]})",
        "p.json"
    );
    std::swap(p.results[0], p.results[1]);

    EXPECT_EQ(
        squeezed(presentation_json(p)),
        R"({"results":[{"key":"B","name":"b","mark":2},{"key":"A","name":"a","mark":1}]})"
    );
}

TEST(Presentation, fresh_one_is_written_in_full_and_reads_back_equal) {
    Presentation p;
    p.title = "Bracket";
    p.results.push_back({.key = "S", .name = "stress", .component = "von_mises", .unit = "MPa"});
    p.results[0].limit = 250;
    p.results[0].limit_label = "yield";
    p.effects.push_back({.result = "S", .sense = Sense::Pulses});
    p.effects[0].pulses.invert = true;
    p.card = {"S"};

    const std::string json = presentation_json(p);
    const Presentation back = parse_presentation(json, "p.json");

    EXPECT_EQ(back.title, p.title);
    EXPECT_EQ(back.results, p.results);
    EXPECT_EQ(back.effects, p.effects);
    EXPECT_EQ(back.card, p.card);
    EXPECT_THAT(json, HasSubstr(R"("format": "feelem-presentation")"));
    EXPECT_THAT(json, HasSubstr(R"("gate": "hold")"));
    EXPECT_EQ(presentation_json(back), json);
}

TEST(Presentation, missing_keys_take_their_defaults) {
    const Presentation p = parse_presentation(with_effects(R"({"result": "T", "type": "colour"})"), "p.json");

    EXPECT_EQ(p.effects[0].colour, ColourEffect{});
    EXPECT_EQ(p.results[0].component, "value");
    EXPECT_EQ(p.results[0].scale, Scale::Linear);
    EXPECT_EQ(p.results[0].range_mode, "auto");
}

TEST(Presentation, null_fallback_means_silence_without_an_actuator) {
    const auto falls_back = [](const std::string& effect) {
        return parse_presentation(with_effects(effect), "p.json").effects[0].falls_back_to_ticks;
    };

    EXPECT_TRUE(falls_back(R"({"result": "T", "type": "pulses"})"));
    EXPECT_FALSE(falls_back(R"({"result": "T", "type": "pulses", "fallback": null})"));
}

TEST(Presentation, removed_limit_leaves_the_document) {
    Presentation p = parse_presentation(boiler(), "p.json");
    p.results[2].limit.reset();

    EXPECT_THAT(presentation_json(p), ::testing::Not(HasSubstr("limit\": {")));
    EXPECT_FALSE(parse_presentation(presentation_json(p), "p.json").results[2].limit.has_value());
}

TEST(Presentation, refusals_name_the_path_of_the_key) {
    EXPECT_THAT(
        refusal(with_effects(R"({"result": "T", "type": "colour"}, {"result": "X", "type": "pitch"})")),
        HasSubstr("p.json: effects[1].result: no result has the key 'X'")
    );
    EXPECT_THAT(
        refusal(R"({"results": [{"key": "T", "name": "t", "range": {"scale": "cubic"}}]})"),
        HasSubstr("results[0].range.scale: 'cubic' is none of: lin log signed symlog")
    );
    EXPECT_THAT(refusal(R"({"results": [{"name": "t"}]})"), HasSubstr("results[0].key"));
    EXPECT_THAT(refusal(R"({"results": [{"key": "T"}]})"), HasSubstr("results[0].name"));
    EXPECT_THAT(refusal(R"({"results": {"T": 1}})"), HasSubstr("results: expected an array"));
    EXPECT_THAT(refusal(R"({"results": [5]})"), HasSubstr("results[0]: expected an object, found number"));
    EXPECT_THAT(refusal(R"({"title": 5})"), HasSubstr("title: expected a text, found number"));
    EXPECT_THAT(refusal(R"({"format": "gltf"})"), HasSubstr("format: expected feelem-presentation"));
    EXPECT_THAT(refusal(R"({"version": 2})"), HasSubstr("version: this program reads version 1, found 2"));
    EXPECT_THAT(refusal(R"({"step": {"step": 1.5}})"), HasSubstr("step.step: expected a whole number"));
    EXPECT_THAT(refusal(R"({"probe": {"card": ["Q"]}})"), HasSubstr("probe.card[0]: no result"));
    EXPECT_THAT(refusal(R"({"deformation": {"result": "Q"}})"), HasSubstr("deformation.result: no result"));
    EXPECT_THAT(refusal(R"({"deformation": {"mode": "manual"}})"), HasSubstr("deformation.factor"));
}

TEST(Presentation, refuses_effects_outside_what_is_safe_and_sensible) {
    const auto effect = [](const std::string& rest) {
        return refusal(with_effects(R"({"result": "T", )" + rest + "}"));
    };

    EXPECT_THAT(effect(R"("type": "smell")"), HasSubstr("effects[0].type: 'smell' is none of"));
    EXPECT_THAT(effect(R"("type": "pitch", "sense": "touch")"), HasSubstr("effects[0].sense: 'pitch' is of"));
    EXPECT_THAT(
        effect(R"("type": "pitch", "midi": [84, 48])"), HasSubstr("effects[0].midi: 84 must be less")
    );
    EXPECT_THAT(effect(R"("type": "pitch", "midi": [48, 200])"), HasSubstr("effects[0].midi[1]: 200 is not"));
    EXPECT_THAT(effect(R"("type": "pitch", "gamma": 0)"), HasSubstr("effects[0].gamma"));
    EXPECT_THAT(effect(R"("type": "ticks", "rateHz": [1, 50])"), HasSubstr("effects[0].rateHz[1]"));
    EXPECT_THAT(effect(R"("type": "pulses", "ampMin": 0)"), HasSubstr("effects[0].ampMin"));
    EXPECT_THAT(effect(R"("type": "pulses", "pulseMs": 5000)"), HasSubstr("effects[0].pulseMs"));
    EXPECT_THAT(
        effect(R"("type": "colour", "map": "jet")"), HasSubstr("effects[0].map: 'jet' is none of: batlow")
    );
    EXPECT_THAT(effect(R"("type": "colour", "bands": -1)"), HasSubstr("effects[0].bands"));
    EXPECT_THAT(effect(R"("type": "colour", "above": "magenta")"), HasSubstr("effects[0].above"));
    EXPECT_THAT(effect(R"("sense": "visual")"), HasSubstr("effects[0].type: an effect needs a type"));
}

TEST(Presentation, refuses_what_would_confuse_the_listener) {
    EXPECT_THAT(
        refusal(with_effects(R"({"result": "T", "type": "pitch"}, {"result": "U", "type": "pitch"})")),
        HasSubstr("effects[1].type: effects[0] already uses 'pitch'")
    );
    EXPECT_THAT(
        refusal(R"({"results": [{"key": "S", "name": "s", "range": {"scale": "signed"}}],
                    "effects": [{"result": "S", "type": "ticks"}]})"),
        HasSubstr("effects[0].type: a signed result")
    );
    EXPECT_THAT(
        refusal(R"({"results": [{"key": "T", "name": "a"}, {"key": "T", "name": "b"}]})"),
        HasSubstr("results[1].key: results[0] already has the key 'T'")
    );
    EXPECT_THAT(
        refusal(R"({"results": [{"key": "A", "name": "a", "limit": {"value": 1}},
                                {"key": "B", "name": "b", "limit": {"value": 2}}]})"),
        HasSubstr("results[1].limit: results[0] has a limit of the same label")
    );
}

TEST(Presentation, refuses_ranges_that_are_no_ranges) {
    const auto range = [](const std::string& text) {
        return refusal(R"({"results": [{"key": "T", "name": "t", "range": )" + text + "}]}");
    };

    EXPECT_THAT(range(R"({"mode": "manual", "lo": 1})"), HasSubstr("results[0].range: a manual range needs"));
    EXPECT_THAT(range(R"({"lo": 2, "hi": 1})"), HasSubstr("results[0].range: lo 2 is above hi 1"));
    EXPECT_THAT(range(R"({"p": [99, 1]})"), HasSubstr("results[0].range.p"));
    EXPECT_THAT(range(R"({"p": [1, 2, 3]})"), HasSubstr("expected two numbers, found 3"));
    EXPECT_THAT(range(R"({"lo": 1e999})"), HasSubstr("not JSON"));
}

TEST(Presentation, survives_hostile_text) {
    EXPECT_THAT(refusal("not json"), HasSubstr("this is not JSON"));
    EXPECT_THAT(refusal(""), HasSubstr("this is not JSON"));
    EXPECT_THAT(refusal("[]"), HasSubstr("expected an object"));
    EXPECT_THAT(refusal(std::string(1'000'000, '[')), HasSubstr("nested more than 64 deep"));
    EXPECT_THAT(refusal(std::string(5u << 20, ' ')), HasSubstr("too many for a presentation"));
    std::string keys = "{\"a\": 1";
    for (int i = 0; i < 300'000; ++i) {
        keys += fmt::format(",\"{}\":0", i);
    }
    EXPECT_THAT(refusal(keys + "}"), HasSubstr("more than 1000 keys"));
    EXPECT_THAT(refusal("{\"title\": \"\xff\xfe\"}"), HasSubstr("this is not JSON"));
    const std::string whole = boiler();
    for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
        EXPECT_NE(refusal(whole.substr(0, length)), "accepted") << length;
    }
}

TEST(Presentation, damaged_text_is_refused_or_read_but_never_harms) {
    const std::string whole = boiler();
    constexpr std::string_view kBytes = "{}[]\",:0129.-eEtfn\\ #\xc3\x00";
    std::uint32_t state = 1;
    const auto random = [&](std::size_t below) {
        state = state * 1664525 + 1013904223;
        return static_cast<std::size_t>(state >> 8U) % below;
    };
    std::size_t read = 0;
    for (int trial = 0; trial < 5000; ++trial) {
        std::string damaged = whole;
        for (std::size_t i = 0; i < 1 + random(4); ++i) {
            const std::size_t at = random(damaged.size());
            switch (random(3)) {
            case 0: damaged[at] = kBytes[random(kBytes.size())]; break;
            case 1: damaged.erase(at, 1 + random(20)); break;
            default: damaged.insert(at, damaged.substr(random(damaged.size()), 1 + random(20)));
            }
        }
        try {
            const Presentation p = parse_presentation(damaged, "p.json");
            const std::string written = presentation_json(p);
            EXPECT_EQ(presentation_json(parse_presentation(written, "p.json")), written);
            ++read;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Code::BadPresentation);
        }
    }
    EXPECT_GT(read, 100U) << "hardly any damage left a document";
}

TEST(Presentation, text_that_is_no_utf8_is_written_as_replacement_characters) {
    Presentation p;
    p.title = "K\xfchler";

    EXPECT_EQ(parse_presentation(presentation_json(p), "p.json").title, "K\xef\xbf\xbdhler");
}

TEST(Presentation, range_without_ends_maps_nothing) {
    EXPECT_TRUE(normalise(1, value_range({})).missing);
    PresentedResult result;
    result.lo = 0;
    result.hi = 4;
    EXPECT_EQ(normalise(1, value_range(result)).u, 0.25);
}

TEST(PresentedView, is_read_and_whatever_is_odd_there_is_its_default) {
    const PresentedView told = presented_view(
        R"({"effects": [{"type": "pitch"}, {"type": "colour", "isolines": true, "shadeFloor": 0.5}],
            "deformation": {"ghost": "featureEdges"},
            "events": {"limit": false, "bandEdges": true}, "audio": {"master": 0.2, "mono": true}})"
    );
    EXPECT_TRUE(told.isolines && told.ghost && told.band_events && told.mono);
    EXPECT_EQ(told.shade_floor, 0.5);
    EXPECT_EQ(told.master, 0.2);
    EXPECT_FALSE(told.limit_events);
    EXPECT_TRUE(told.extreme_events);
    const PresentedView odd = presented_view(
        R"({"effects": [7, {"type": "colour", "isolines": "yes", "shadeFloor": "dark"}],
            "deformation": {"ghost": 7}, "events": {"limit": 0}, "audio": {"master": 30, "mono": null}})"
    );
    EXPECT_FALSE(odd.isolines || odd.ghost || odd.mono);
    EXPECT_TRUE(odd.limit_events);
    EXPECT_EQ(odd.shade_floor, 0.75);
    EXPECT_EQ(odd.master, 1);
    EXPECT_FALSE(presented_view("[1, 2]").ghost);
    EXPECT_TRUE(presented_view("").no_value_events);
}

TEST(PresentedView, lines_and_ghost_are_written_back_beside_all_else) {
    const std::string document =
        R"({"effects": [{"type": "colour", "map": "turbo"}], "deformation": {"ghost": "featureEdges"}, "own": 1})";
    PresentedView view = presented_view(document);
    view.isolines = true;
    view.ghost = false;
    const std::string written = with_presented_view(document, view);
    EXPECT_TRUE(presented_view(written).isolines);
    EXPECT_FALSE(presented_view(written).ghost);
    EXPECT_NE(written.find("turbo"), std::string::npos);
    EXPECT_NE(written.find("own"), std::string::npos);
}

TEST(Presentation, a_factor_that_nobody_has_chosen_is_no_longer_manual) {
    Presentation presentation = parse_presentation(
        R"({"results": [{"key": "U", "name": "displacement", "component": "magnitude"}],
            "effects": [{"result": "U", "type": "colour"}],
            "deformation": {"result": "U", "mode": "manual", "factor": 3}})",
        "read"
    );
    presentation.deformation_factor.reset();
    const Presentation back = parse_presentation(presentation_json(presentation), "written");
    EXPECT_FALSE(back.deformation_factor);
    EXPECT_EQ(back.deformation_result, "U");
    presentation.deformation_factor = 7;
    EXPECT_EQ(parse_presentation(presentation_json(presentation), "again").deformation_factor, 7);
}

}  // namespace
}  // namespace feelem
